#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/report/report.hpp>

#include "support/run_nipref.hpp"

using namespace nipref::verify;
using nlohmann::json;

namespace {

json quantity_row(const char* name, double error, long points, bool kept) {
  return {{"quantity", name}, {"max_error_ulp", error}, {"points", points}, {"passed", kept}};
}

json older_json() {
  return {{"verb", "report"},
          {"nipref", {{"commit", "0123456789abcdef"}, {"commit_date", "2026-01-02"}}},
          {"audit",
           {{"rows",
             {quantity_row("I1", 0.5, 100, true), quantity_row("I2", 0.5, 100, true),
              quantity_row("I3", 0.5, 100, true), quantity_row("I4", 0.5, 100, true),
              quantity_row("I5", 0.5, 100, true)}},
            {"scenes", {{{"kind", "die"}, {"scenes", 10}, {"passed", true}, {"median_overestimate", 3.0}}}},
            {"contacts", json::array()}}},
          {"bench",
           {{"times",
             {{"ratios",
               {{{"what", "a"}, {"ratio", 100.0}},
                {{"what", "b"}, {"ratio", 100.0}},
                {{"what", "c"}, {"ratio", 100.0}}}}}}}},
          {"summary", {{"tables", {{{"id", "T"}, {"match", 1}, {"unexplained", 1}}}}}},
          {"claims", {{{"id", "C"}, {"verdict", "holds"}}}}};
}

const ChangedItem* item_about(const ReportComparison& comparison, const std::string& what) {
  for (const ChangedItem& item : comparison.items) {
    if (item.what.starts_with(what)) return &item;
  }
  return nullptr;
}

}  // namespace

TEST_CASE("a report against itself has changed nothing") {
  CHECK(is_report(older_json().dump()));
  const ReportComparison none = compare_reports(older_json().dump(), older_json().dump());
  CHECK(none.items.empty());
  CHECK(none.note.empty());
  CHECK(none.older == "0123456789, 2026-01-02");
}

TEST_CASE("an older report may lack what this one has, or have it otherwise, a part it lacks is new, once") {
  json older = older_json();
  older["claims"] = {{{"id", "C"}}};
  older["audit"] = {3, "rows"};
  older["summary"]["tables"] = {7, {{"id", "T"}, {"match", "many"}}};
  const ReportComparison comparison = compare_reports(older.dump(), older_json().dump());
  const ChangedItem* const claim = item_about(comparison, "claim C");
  REQUIRE(claim != nullptr);
  CHECK(claim->before.empty());
  CHECK(claim->now == "holds");
  json without = older_json();
  without.erase("claims");
  const ReportComparison found = compare_reports(without.dump(), older_json().dump());
  REQUIRE(found.items.size() == 1);
  CHECK(found.items[0].change == Change::appeared);
  CHECK(found.items[0].what.starts_with("claim: all 1"));
}

TEST_CASE("what is better, worse, slower, new or gone in a report is told, the worst first") {
  json now = older_json();
  json& rows = now["audit"]["rows"];
  rows[0]["max_error_ulp"] = 0.6;   // worse
  rows[1]["max_error_ulp"] = 0.4;   // better
  rows[2]["max_error_ulp"] = 0.51;  // the same
  rows[3]["points"] = 10;           // not comparable
  rows[3]["max_error_ulp"] = 0.1;
  rows[4]["quantity"] = "I9";  // new, and one gone
  now["audit"]["scenes"][0]["passed"] = false;
  json& ratios = now["bench"]["times"]["ratios"];
  ratios[0]["ratio"] = 70.0;   // slower
  ratios[1]["ratio"] = 130.0;  // quicker
  ratios[2]["ratio"] = 110.0;  // noise
  now["summary"]["tables"][0].update({{"match", 2}, {"unexplained", 0}});
  now["claims"][0]["verdict"] = "false";
  const ReportComparison found = compare_reports(older_json().dump(), now.dump());
  const auto change = [&](const char* what) {
    const ChangedItem* item = item_about(found, what);
    return item == nullptr ? "none" : std::string(name(item->change));
  };
  CHECK(change("audit I1") == "worse");
  CHECK(change("audit I2") == "better");
  CHECK(change("audit I3") == "none");
  CHECK(change("audit I4") == "none");
  CHECK(change("audit I5") == "gone");
  CHECK(change("audit I9") == "new");
  CHECK(change("random contacts die") == "worse");
  CHECK(change("speed, a") == "slower");
  CHECK(change("speed, b") == "quicker");
  CHECK(change("speed, c") == "none");
  CHECK(change("table T, cells: match") == "better");
  CHECK(change("table T, cells: unexplained") == "better");
  CHECK(change("claim C") == "changed");
  CHECK(found.items.front().change == Change::worse);
  CHECK(found.items.back().change == Change::gone);
  CHECK(found.note.starts_with("of 1 quantities"));
  CHECK(item_about(found, "audit I1")->before == "0.5");
  CHECK(item_about(found, "audit I1")->now == "0.6");
  const std::string text = text_of("comparison.txt", comparison_json(found, 2));
  CHECK(text.starts_with(
      "against 0123456789, 2026-01-02: 2 worse, 1 slower, 3 better, 1 quicker, 1 changed, 1 new, 1 gone\n"));
  CHECK(contains(text, "  worse   audit I1, largest error, ulp: 0.5 -> 0.6\n"));
  CHECK(contains(text, "and 8 more"));
}
