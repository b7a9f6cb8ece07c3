#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include <nipref/verify/support/internal/template.hpp>

using namespace nipref::verify;

namespace {

std::string filled_html(const std::string& text, const TemplateData& data) {
  return filled(text, data, escaped_for_html);
}

}  // namespace

TEST_CASE("text in a template is escaped, in elements and attributes alike") {
  const TemplateData data{{"text", "a < b & \"c\" > 'd'\x01\t."}};
  CHECK(filled_html("<b title=\"{{text}}\">{{text}}</b>", data) ==
        "<b title=\"a &lt; b &amp; &quot;c&quot; &gt; &apos;d&apos;  .\">"
        "a &lt; b &amp; &quot;c&quot; &gt; &apos;d&apos;  .</b>");
}

TEST_CASE("a template formats the numbers of its sections, and writes a dash where there is none") {
  const TemplateData data{
      {"x", -0.00123456}, {"n", 68441}, {"none", nullptr}, {"off_by", -0.256}, {"hex", "0x1.8p+1"}};
  const std::pair<const char*, const char*> expected[]{
      {"{{x}} {{n}} {{none}}", "-0.00123456 68441 "},
      {"{{#g2}}{{x}}{{/g2}} {{#g4}}{{x}}{{/g4}} {{#e1}}{{x}}{{/e1}}", "-0.0012 -0.001235 -1.2e-03"},
      {"{{#g3}}{{none}}{{/g3}}", "-"},
      {"{{#percent}}{{off_by}}{{/percent}} {{#off}}{{off_by}}{{/off}}", "-26 % 26 % low"},
      {"{{#off}}0.0007{{/off}} {{#off}}1.02{{/off}}", "0.07 % high 102 % high"},
      {"{{#two_digits}}{{n}}{{/two_digits}} {{#two_digits}}33.2{{/two_digits}} {{#two_digits}}1e12{{/two_digits}}",
       "68000 33 1e+12"},
      {"{{#decimal}}solid(bulk={{hex}}, -0x1p-1){{/decimal}}", "solid(bulk=3, -0.5)"},
      {"{{#shell}}a=1{{/shell}} {{#shell}}a=b(c){{/shell}}", "a=1 'a=b(c)'"}};
  for (const auto& [text, result] : expected) CHECK(filled_html(text, data) == result);
}

TEST_CASE("a template goes through the members of an object") {
  const TemplateData data{
      {"point", {{"alpha", 1.5}, {"eta", "all"}}}, {"list", {1, 2}}, {"empty", TemplateData::object()}};
  CHECK(filled_html("{{#point.each}}{{key}}={{value}} {{/point.each}}", data) == "alpha=1.5 eta=all ");
  CHECK(filled_html("{{#list}}<{{.}}>{{/list}}{{^empty.each}}none{{/empty.each}}", data) == "<1><2>none");
}

TEST_CASE("what is no template is refused") {
  CHECK_THROWS_AS(filled_html("{{#a}}", TemplateData::object()), std::runtime_error);
}
