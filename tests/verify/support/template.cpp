#include <nlohmann/json.hpp>

#include <nipref/verify/support/internal/template.hpp>

#include "support/test.hpp"

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
      {"{{#as}}.2g {{x}}{{/as}} {{#as}}>10.4g {{x}}{{/as}} {{#as}}.1e {{x}}{{/as}}",
       "-0.0012  -0.001235 -1.2e-03"},
      {"{{#as}}.3g {{none}}{{/as}}", "-"},
      {"{{#as}}<5 {{n}}a{{/as}}{{#as}}>4 {{none}}{{/as}}", "68441a    "},
      {"{{#as}}.0f% {{off_by}}{{/as}} % {{#off}}{{off_by}}{{/off}}", "-26 % 26 % low"},
      {"{{#upward}}0{{/upward}} {{#upward}}1e-3{{/upward}} {{#upward}}1.01e-3{{/upward}}",
       "0.0e+00 1.0e-03 1.1e-03"},  // never less than the error
      {"{{#upward}}1.99e-3{{/upward}} {{#upward}}9.949e-3{{/upward}}", "2.0e-03 1.0e-02"},
      {"{{#off}}0.0007{{/off}} {{#off}}1.02{{/off}}", "0.07 % high 102 % high"},
      {"{{#two_digits}}{{n}}{{/two_digits}} {{#two_digits}}33.2{{/two_digits}} {{#two_digits}}1e12{{/two_digits}}",
       "68000 33 1e+12"},
      {"{{#decimal}}solid(bulk={{hex}}, -0x1p-1){{/decimal}}", "solid(bulk=3, -0.5)"},
      {"{{#exact}}solid(bulk={{hex}}, -0x1p-1){{/exact}}", "solid(bulk=3 (0x1.8p+1), -0.5 (-0x1p-1))"},
      {"{{#trimmed}}a, b; {{/trimmed}}", "a, b"},
      {"{{#shell}}a=1{{/shell}} {{#shell}}a=b(c){{/shell}}", "a=1 'a=b(c)'"}};
  for (const auto& [text, result] : expected) CHECK(filled_html(text, data) == result);
}

TEST_CASE("a template goes through the members of an object") {
  const TemplateData data{
      {"point", {{"alpha", 1.5}, {"eta", "all"}}}, {"list", {1, 2}}, {"empty", TemplateData::object()}};
  CHECK(filled_html("{{#point.each}}{{key}}={{value}} {{/point.each}}", data) == "alpha=1.5 eta=all ");
  CHECK(filled_html("{{#list}}<{{.}}>{{/list}}{{^empty.each}}none{{/empty.each}}", data) == "<1><2>none");
}

TEST_CASE("a section's tag that stands alone leaves no line, whether the section is left out or not") {
  const TemplateData data{{"there", true}, {"none", nullptr}, {"rows", {{{"n", 1}}, {{"n", 2}}}}};
  CHECK(filled_text("a\n{{#none}}\nb\n{{/none}}\n  {{#there}}\n\nc\n  {{/there}}\nd", data) == "a\n\nc\nd");
  CHECK(filled_text("{{#rows}}\n{{n}}\n{{/rows}}\n\ne\n", data) == "1\n2\n\ne\n");
}

TEST_CASE("a partial of one line stands within a line, another on lines of its own") {
  const TemplateData data{{"rows", {{{"n", 1}}, {{"n", 2}}}}};
  const Partials partials{{"one.txt", "<{{n}}>\n"}, {"all.txt", "{{#rows}}\n- {{n}}\n{{/rows}}\n"}};
  CHECK(filled_text("{{#rows}}{{>one.txt}}{{/rows}}.\n{{>all.txt}}\nend\n", data, partials) ==
        "<1><2>.\n- 1\n- 2\nend\n");
}

TEST_CASE("a table is laid out in columns, bars in values and lines below rows included") {
  const TemplateData data{{"rows", {{{"n", 1}, {"what", "a | b"}}, {{"n", 234}, {"what", "c"}}}},
                          {"none", nullptr}};
  CHECK(filled_text(
            "{{#table}}\nwhat | >n\n{{#rows}}\n{{what}} | {{n}}\n    below {{n}}\n{{/rows}}\n{{/table}}\n",
            data) == "what     n\na | b    1\n    below 1\nc      234\n    below 234\n");
  CHECK(filled_text("{{#table}}\nhead\n{{#none}}{{/none}}\n{{/table}}\n", data).empty());
}

TEST_CASE("what is no template is refused") {
  CHECK_THROWS_AS(filled_html("{{#a}}", TemplateData::object()), std::runtime_error);
  CHECK(filled_html("{{a}}", TemplateData::object()).empty());
  CHECK_THROWS_WITH_AS(filled_text("{{a}}", TemplateData::object()), "template: there is no a",
                       std::runtime_error);
}
