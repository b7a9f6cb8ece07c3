#include <fmt/format.h>

#include <boost/property_tree/detail/rapidxml.hpp>

#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/report_parts.hpp>
#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/report/report.hpp>
#include <nipref/verify/support/internal/process.hpp>
#include <nipref/verify/support/internal/template.hpp>
#include <nipref/verify/support/text.hpp>

#include "support/json_schema.hpp"
#include "support/proven_pages.hpp"
#include "support/scratch.hpp"

using namespace nipref;
using namespace nipref::verify;

namespace {

std::vector<Replay> one_of_each_kind() {
  std::vector<Replay> replays;
  for (const char* id : {"thesis-VII", "brock2013-1"}) {
    replays.push_back(replay_table(id));
    correct(replays.back());
  }
  return replays;
}

BenchRow timed(const char* method, double nanoseconds, std::optional<double> error) {
  return {"I1", "alpha in [1e-6,20]", method, nanoseconds, error, error, 1, nanoseconds / 2, 2 * nanoseconds};
}

/// A report of a few quantities at few points, of two tables and of one of everything else.
const Report& small_report() {
  static const Report report = [] {
    Report small;
    small.command = "nipref report -o 'a & b'";
    small.seed = "1";
    for (const char* name : {"I1", "root.re", "rolling.index"})
      small.quantities.push_back(audit(find_quantity(name), {.points = 200, .accuracy = {}}));
    small.hard_cases = {{"converged <full friction>", 30, 0.5, 40, {}, 0.01, 1e-8}};
    small.scenes.resize(1);
    small.scenes[0].numbers = 7;
    small.scenes[0].next_worst.clear();
    small.speed.rows = {timed("fast full", 7, 1e-16), timed("fast rtol=1e-03", 5, 1e-4),
                        timed("GSL QAWF", 1e4, 0), timed("Boost <ooura>", 1e5, 1e-9),
                        timed("no error", 3, {})};
    small.speed.rows.push_back({"I2", "alpha in [0,1]", "fast full", 1, 0.5, 1e-16, 1});
    small.speed.ratios = {{"fast I1 against GSL's QAWF", 1428.6, 500}, {"another", 2, 3}};
    small.tables = one_of_each_kind();
    small.claims = check_all({claims().back()});
    small.limits = {
        {"limit.none", "W < 0", "nobody", "L/B", 2, {{0.1, {1, 1e-9}, 1.1}, {0.05, {1, 1e-9}, 1.025}}}};
    small.errata = settle_all({formula_errata().front()});
    small.golden = {{read_golden(golden_path("I1")), {.path = "I1.csv", .quantity = "I1", .rows = 3}}};
    const std::vector<FigurePlan> plans = figures();
    small.figures = {compute(*std::ranges::find(plans, "thesis-9", &FigurePlan::id))};
    return small;
  }();
  return report;
}

std::string answer_of(const Report& report) { return answer_text("report", report_json(report)); }

std::string text_of_report(const Report& report) {
  return plain(report_text(answer_of(report), "somewhere"));
}

/// The plots of three quantities, one group of ways and one figure.
constexpr std::size_t plots_of_small_report = 5;

std::optional<std::string> empty_drawing(const std::string&) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\"/>";
}

const std::string& small_page() {
  static const std::string page = report_page(answer_of(small_report()), empty_drawing, true);
  return page;
}

/// The values of all attributes with this name.
std::vector<std::string> attributes_of(const std::string& page, const std::string& name) {
  return matches_in(page, " " + name + "=\"([^\"]*)\"");
}

/// Reads markup strictly, as XML. Returns the first error; empty if there is none.
std::string fault_of(std::string page) {
  for (std::size_t at = page.find('&'); at != std::string::npos; at = page.find('&', at + 1)) {
    const std::string near = page.substr(at, 60);
    if (std::ranges::none_of(std::array{"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"},
                             [&](const char* known) { return near.starts_with(known); }))
      return "a stray &: " + near;
  }
  if (!page.starts_with("<!DOCTYPE html>")) return "no document type";
  namespace xml = boost::property_tree::detail::rapidxml;
  try {
    xml::xml_document<> document;
    document.parse<xml::parse_validate_closing_tags>(page.data());
    return document.first_node()->next_sibling() == nullptr ? "" : "more than one document";
  } catch (const xml::parse_error& error) {
    return error.what() + std::string(": ") + std::string(error.where<char>()).substr(0, 60);
  }
}

}  // namespace

TEST_CASE("the report's page is well-formed, its ids are unique, and no link in it is dead") {
  const std::string& page = small_page();
  CHECK(fault_of(page) == "");
  const std::vector<std::string> ids = attributes_of(page, "id"), links = attributes_of(page, "href");
  const std::set<std::string> known(ids.begin(), ids.end());
  CHECK(known.size() == ids.size());
  CHECK(links.size() > 15);
  for (const std::string& link : links) {
    CAPTURE(link);
    if (link == "mathematics.html") continue;  // a file beside the page
    CHECK(link.starts_with("#"));
    CHECK(known.contains(link.substr(1)));
  }
}

TEST_CASE("the report is as the schema has it, its parts as the verbs would answer, without times if so") {
  Report report = small_report();
  AuditResult& broken = report.quantities[1];
  broken.max_error_ulp = broken.allowance_used = infinite;
  broken.errors.add(broken.max_error_ulp);
  report.witness = {true, {{0.25, true, 1e-6, 1e-6, 1e-5}}};
  report.scenes.clear();  // no text of a scene: made by hand
  const auto answer = nlohmann::json::parse(answer_of(report));
  CHECK(answer_schema().misfit(answer, "report") == "");
  CHECK_FALSE(holds_anywhere(answer, [](const auto&, const nlohmann::json& item) { return item == ""; }));
  for (const std::string part : {"audit", "bench", "tables"}) {
    nlohmann::json as_verb = answer.at(part);
    for (const char* head : {"schema", "nipref"}) as_verb[head] = answer.at(head);
    as_verb["verb"] = part;
    CAPTURE(part);
    CHECK(answer_schema().misfit(as_verb, part) == "");
  }
  const auto& rows = answer["audit"]["rows"];
  CHECK(rows[0]["passed"] == true);
  CHECK(rows[1]["passed"] == false);
  for (const char* unknown : {"max_error_ulp", "mean_error_ulp", "allowance_used"})
    CHECK(rows[1].at(unknown).is_null());
  CHECK(answer["seed_errors"][0]["table"] == "thesis-VII");
  CHECK(answer["bench"]["times"]["ratios"][1]["met"] == false);
  const auto timeless = nlohmann::json::parse(answer_text("report", report_json(report), true));
  CHECK(answer_schema().misfit(timeless, "report") == "");
  CHECK_FALSE(holds_anywhere(timeless, [](const auto& name, const auto&) { return name == "times"; }));
}

TEST_CASE("a page that is not well-formed is seen") {
  const std::string start = "<!DOCTYPE html>";
  CHECK(fault_of(start + "<p>a &lt; b</p>") == "");
  for (const std::string& wrong :
       {std::string("<p></p>"), start + "<p>", start + "<p><b></p></b>", start + "<p>a & b</p>",
        start + "<p>a < b</p>", start + "<p class=x></p>"}) {
    CAPTURE(wrong);
    CHECK(fault_of(wrong) != "");
  }
}

TEST_CASE("the report's page needs nothing but itself, and has all plots, with words that stand for them") {
  const std::string& page = small_page();
  for (const char* foreign : {"<script", "<link", "@import", "url("}) CHECK_FALSE(contains(page, foreign));
  for (const std::string& source : attributes_of(page, "src"))
    CHECK(source.starts_with("data:image/svg+xml,%3C"));
  CHECK(times_in(page, "<img ") == plots_of_small_report);
  const std::vector<std::string> instead = attributes_of(page, "alt");
  REQUIRE(instead.size() == plots_of_small_report);
  for (const std::string& words : instead) CHECK(words.size() > 40);
}

TEST_CASE("a plot stands in the report's page as a picture, encoded as RFC 3986 has it") {
  const std::string page = report_page(answer_of(small_report()), [](const std::string&) {
    return "<a b='#1'>\n\n  5 % \u00b7 \"x\"&\n</a>";
  });
  CHECK(contains(page, "src=\"data:image/svg+xml,%3Ca b='%231'%3E 5 %25 %C2%B7 %22x%22%26 %3C/a%3E\""));
}

TEST_CASE("what the templates of a report name is there: a name that is not would leave a gap") {
  std::set<std::string> known{
      "each",    "key",    "value",   "page",        "subjects", "ways",   "first",      "count",   "rows",
      "columns", "judged", "drawn",   "picture",     "as",       "off",    "two_digits", "decimal", "shell",
      "good",    "bad",    "message", "interrupted", "coming",   "mathml", "mathematics"};
  Report report = small_report();
  report.comparison = ReportComparison{"abc", "", {{Change::slower, "speed", "100", "70"}}};
  report.witness = {true, {{0.25, true, 1e-6, 1e-6, 1e-5}}};
  const std::function<void(const nlohmann::json&)> add_names = [&](const nlohmann::json& value) {
    for (const auto& [name, member] : value.items()) {
      if (value.is_object()) known.insert(name);
      if (member.is_structured()) add_names(member);
    }
  };
  add_names(nlohmann::json::parse(answer_of(report)));
  for (const char* name : {"report.html", "report.txt"}) {
    const std::string text = template_text(name);
    for (std::size_t at = text.find("{{"); at != std::string::npos; at = text.find("{{", at + 2)) {
      std::string tag = text.substr(at + 2, text.find("}}", at) - at - 2);
      tag.erase(0, tag.find_first_not_of("#^/{"));
      if (tag.starts_with('!') || tag == ".") continue;
      CAPTURE(tag);
      std::istringstream parts(tag);
      for (std::string part; std::getline(parts, part, '.');) CHECK(known.contains(part));
    }
  }
}

TEST_CASE("without gnuplot the report's page says so in the place of each plot, and the rest stands") {
  const std::string page =
      report_page(answer_of(small_report()), [](const std::string&) { return std::nullopt; });
  CHECK(fault_of(page) == "");
  CHECK_FALSE(contains(page, "<img "));
  CHECK_FALSE(contains(page, "mathematics.html"));
  CHECK(times_in(page, "Not drawn: gnuplot") == plots_of_small_report);
  CHECK(contains(page, "id=\"thesis-VII\""));
}

TEST_CASE("the report's page tells what the report holds") {
  const std::string& page = small_page();
  const AuditResult& worst = *closest_to_its_promise(small_report().quantities);
  CHECK(contains(page, fmt::format("<a href=\"#accuracy-{}\"><b>{:.0f} %</b></a>", worst.quantity->name,
                                   100 * worst.allowance_used)));
  CHECK(contains(page, "<b>1400 times</b>"));
  CHECK(contains(page, "<a href=\"mathematics.html\">"));
  CHECK(contains(page, "<a href=\"#brock2013-1\"><b>47 % low</b></a>"));
  CHECK(contains(page, "Boost &lt;ooura&gt;"));
  CHECK(contains(page, "converged &lt;full friction&gt;"));
  CHECK(contains(page, "title=\"seed-error; true: "));                // tooltip of a printed cell
  CHECK(contains(page, "<a href=\"#brock2013-1\">brock2013-1</a>"));  // link to its paragraph
  CHECK(contains(page, "nipref report -o &apos;a &amp; b&apos;"));
  CHECK(contains(page, "\u2717 MISSED"));
  std::size_t left_out = 0, unexplained = 0;
  for (const AuditResult& result : small_report().quantities) left_out += result.left_out;
  for (const Replay& replay : small_report().tables) unexplained += replay.count(Verdict::unexplained);
  CHECK(contains(page, "<b>1 missed</b>"));                               // the ratio "another"
  CHECK(contains(page, fmt::format("<b>{} skipped</b>", left_out + 1)));  // a hard case without a truth
  CHECK(contains(page, fmt::format("<b>{} unexplained</b>", unexplained)));
  // Each judged cell has its verdict in words.
  for (const Verdict verdict :
       {Verdict::match, Verdict::misprint, Verdict::seed_error, Verdict::unexplained}) {
    std::size_t cells = 0;
    for (const Replay& replay : small_report().tables) cells += replay.count(verdict);
    CAPTURE(name(verdict));
    CHECK(times_in(page, "class=\"keep " + std::string(name(verdict)) + "\"") == cells);
  }
}

TEST_CASE("a page that grows says what is still to come, and lines about a part are found by their heads") {
  Report report = small_report();
  CHECK_FALSE(contains(small_page(), "This page grows"));
  report.golden.clear();
  report.comparison = ReportComparison{"abc, yesterday", "", {{Change::slower, "speed, a < b", "100", "70"}}};
  report.to_come = {"golden values", "figures"};
  const std::string page = report_page(answer_of(report), empty_drawing);
  CHECK(fault_of(page) == "");
  // The comparison with an older report stands at the top.
  CHECK(page.find("speed, a &lt; b") < page.find("id=\"headline\""));
  CHECK(contains(small_page(), " missed</b>"));
  CHECK_FALSE(contains(page, " missed</b>"));  // it would be 0
  CHECK(contains(
      page, "Still to come: <span class=\"list\"><span>golden values</span><span>figures</span></span>"));
  const std::string text = text_of_report(report);
  CHECK(report_lines(text, {"page"}) == "page       somewhere\n");
  const std::string lines = report_lines(text, {"tables", "sources"});
  CHECK(lines.starts_with("tables "));
  CHECK(contains(lines, "\nsources "));
  CHECK(contains(lines, "low"));  // from the continuation line
  CHECK_FALSE(contains(lines, "claims"));
}

TEST_CASE("the report's text is one screen of 80 columns") {
  Report report = small_report();
  const std::string text = text_of_report(report);
  std::istringstream lines(text);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    CAPTURE(line);
    CHECK(line.size() <= 80);
  }
  CHECK(count <= 30);
  CHECK(contains(text, "audit      all 3 quantities pass; closest to its promise: "));
  CHECK(contains(text, "1 of 2 promised ratios met"));
  CHECK(contains(text, "short      1 missed promises: 0 of 3 quantities, 1 of 2 ratios"));
  CHECK(contains(text, "page       somewhere\n"));
  CHECK_FALSE(report.kept(false));  // the limit is missed
  report.limits.clear();
  CHECK(report.kept(false));
  CHECK_FALSE(report.kept(true));  // a ratio of times is missed
  report.quantities[0].allowance_used = 1.5;
  CHECK_FALSE(report.kept(false));
  CHECK(contains(text_of_report(report), "2 of 3 quantities pass; closest to its promise: I1 with 150 %"));
}

TEST_CASE("the report's page is drawn by gnuplot and shown by Chromium, on a telephone and on paper") {
  if (std::system("command -v gnuplot >/dev/null && command -v chromium >/dev/null") != 0) {
    MESSAGE("skipped: gnuplot or chromium is not installed");
    return;
  }
  std::string page = report_page(answer_of(small_report()), drawn_by_gnuplot);
  CHECK(fault_of(page) == "");
  CHECK(page.size() < 1'000'000);
  // The script writes into the title how many pictures the browser shows, and what is too wide for a telephone.
  const std::string probe =
      "<script>addEventListener('load', () => { document.querySelectorAll('details').forEach(d => d.open = true);"
      "document.documentElement.style.width = '360px';"
      "const shown = [...document.images].filter(i => i.complete && i.naturalWidth > 0).length;"
      "const boxes = [...document.body.querySelectorAll('*')].filter(e => !e.parentElement.closest('.scroll, pre') && "
      "e.getBoundingClientRect().right > 361);"
      "document.title = shown + ' shown, ' + boxes.length + ' too wide ' + (boxes[0] ? boxes[0].outerHTML.slice(0, 80) : ''); });"
      "</script></body>";
  page.replace(page.find("</body>"), 7, probe);
  const ScratchFolder folder;
  const std::string file = folder.write("page.html", page), pdf = folder.file("page.pdf");
  const std::vector<std::string> chromium{"chromium", "--headless", "--no-sandbox", "--disable-gpu",
                                          "--user-data-dir=" + folder.path().string()};
  auto dump = chromium, print = chromium;
  dump.insert(dump.end(), {"--dump-dom", "file://" + file});
  print.insert(print.end(), {"--no-pdf-header-footer", "--print-to-pdf=" + pdf, "file://" + file});
  const std::string shown = output_of(dump).text;
  const std::string title = shown.substr(shown.find("<title>"), 200);
  CAPTURE(title);
  CHECK(title.starts_with("<title>" + std::to_string(plots_of_small_report) + " shown, 0 too wide"));
  CHECK(output_of(print).status == 0);
  CHECK(std::filesystem::file_size(pdf) > 10'000);
}
