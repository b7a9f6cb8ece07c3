#include <doctest/doctest.h>

#include <nipref/verify/report/internal/markup.hpp>

using namespace nipref::verify;

TEST_CASE("text in markup is escaped, in elements, attributes and tables alike") {
  CHECK(Markup("a < b & \"c\" > d").html() == "a &lt; b &amp; &quot;c&quot; &gt; d");
  CHECK(Markup(std::string_view("a\x01"
                                "b\tc"))
            .html() == "a b c");
  CHECK(element("b", {{"title", "1 < 2"}}, "x > y").html() == "<b title=\"1 &lt; 2\">x &gt; y</b>");
  CHECK(empty_element("img", {{"alt", "\""}}).html() == "<img alt=\"&quot;\"/>");
  TableMarkup table("cap & tion", {"name", "#value"});
  table.row({{"<I1>"}, number_cell("1 < 2")}, "row-1");
  const std::string html = table.markup().html();
  CHECK(html.find("<caption>cap &amp; tion</caption>") != std::string::npos);
  CHECK(html.find("<th scope=\"col\" class=\"n\">value</th>") != std::string::npos);
  CHECK(html.find("<tr id=\"row-1\"><th scope=\"row\">&lt;I1&gt;</th><td class=\"n\">1 &lt; 2</td></tr>") !=
        std::string::npos);
}

TEST_CASE("a picture holds its drawing, encoded as RFC 3986 has it, with text instead of it") {
  const std::string html = picture("<a b='#1'>\n\n  5 % \u00b7 \"x\"&\n</a>", "a \"drawing\"").html();
  CHECK(
      html ==
      "<img src=\"data:image/svg+xml,%3Ca b='%231'%3E 5 %25 %C2%B7 %22x%22%26 %3C/a%3E\" alt=\"a &quot;drawing&quot;\"/>");
}
