// The pages of ref as one page of HTML.
#include "support/proven_pages.hpp"

TEST_CASE("the mathematics as one page has each section of the table, MathML and no dead link") {
  const auto file = std::filesystem::path(program()).parent_path() / "mathematics.html";
  if (!std::filesystem::exists(file)) {
    MESSAGE("skipped: there is no pandoc");
    return;
  }
  std::ifstream stream(file);
  const std::string page{std::istreambuf_iterator<char>(stream), {}};
  const std::vector<std::string> places = matches_in(page, " id=\"([^\"]*)\""),
                                 leads = matches_in(page, " href=\"#([^\"]*)\"");
  const std::set<std::string> sections(places.begin(), places.end());
  CHECK(sections.size() == places.size());
  CHECK(leads.size() > 100);
  for (const std::string& lead : leads) CHECK_MESSAGE(sections.contains(lead), lead);
  std::size_t rows = 0;
  for (const char* table : {"quantities", "contact"}) {
    for (const TableRow& row : rows_of_proven(table)) {
      for (const std::string& link : matches_in(row[0] + row[2], R"(\]\(([a-z_]+/README\.md#[^)]*)\))")) {
        CHECK_MESSAGE(sections.contains(std::regex_replace(link, std::regex("README.md#"), "")), link);
        ++rows;
      }
    }
  }
  CHECK(rows > 25);
  CHECK(matches_in(page, "(<math )").size() > 1000);
  CHECK(page.find('$') == std::string::npos);
}
