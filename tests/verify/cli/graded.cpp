#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/audit_run.hpp>
#include <nipref/verify/cli/graded.hpp>
#include <nipref/verify/golden/check.hpp>
#include <nipref/verify/golden/golden.hpp>

#include "support/run_nipref.hpp"
#include "support/unfolded.hpp"

using nlohmann::json;
using namespace nipref;

namespace {

std::string grade_kernels(const std::string& more) {
  return "grade '" + plugin_file("kernels") + "' --quiet --points 300 " + more;
}

json row_of(const Outcome& outcome) {
  CAPTURE(outcome.err);
  const json rows = json::parse(outcome.out)["rows"];
  REQUIRE(rows.size() == 1);
  return rows[0];
}

verify::Graded graded_at(const char* quantity, double alpha) {
  const std::vector<verify::Point> points{{alpha}};
  const std::vector<double> values{1.0};
  return {verify::grade_of("mine", "its points",
                           verify::audit_values(verify::find_quantity(quantity), points, values, {})),
          0};
}

}  // namespace

TEST_CASE("a kernel of a shared object is graded with the numbers of audit and its speed beside fast") {
  const Outcome graded = run(grade_kernels("all_sound --json"));
  CHECK(graded.status == 0);
  const json row = row_of(graded);
  const json audited = answer_to("audit I3 --points 300 --quiet")["rows"][0];
  for (const auto& [name, number] : audited.items()) {
    CAPTURE(name);
    if (name != "times") CHECK(row[name] == number);
  }
  CHECK(row["faults"].empty());
  CHECK(row["where"] == "its domain");
  CHECK(row["times"]["to_fast"]["ratio"].get<double>() > 0);
  CHECK(row["times"]["to_older"].is_null());
  CHECK(answer_to(grade_kernels("all_sound --no-times"))["rows"][0].contains("times") == false);
}

TEST_CASE("a bare function is graded in ranges, promise and baseline as kernels are") {
  const std::string call = grade_kernels("I3 alpha=1e-3..50:log --symbol bare_I3 --thread-safe");
  const ScratchFile baseline;
  CHECK(run(call + " --baseline '" + baseline.path() + "' --update-baseline").status == 0);
  CHECK(run(call + " --baseline '" + baseline.path() + "'").status == 0);
  CHECK(run(call + " --seed 2 --baseline '" + baseline.path() + "'").status == 1);
  // The same library in another folder, with its version.
  const ScratchFolder folder;
  const std::filesystem::path other = folder.path() / "kernels.so.1.2";
  std::filesystem::copy(plugin_file("kernels"), other);
  const std::string of_other = "grade '" + other.string() + call.substr(call.find("' --quiet"));
  CHECK(run(of_other + " --baseline '" + baseline.path() + "'").status == 0);
  CHECK(run(call + " --promise 1e-3ulp").status == 1);
  const json row = row_of(run(call + " --json"));
  CHECK(row["quantity"] == "I3");
  CHECK(row["where"] == "alpha=1e-3..50:log");
  CHECK(run(grade_kernels("--symbol bare_I6 --quantity I6")).status == 0);
}

TEST_CASE("a kernel that crashes is told of, with status 1, and is an error in JUnit") {
  const ScratchFile junit;
  const Outcome outcome = run(grade_kernels("crashes alpha=17.25 --junit '" + junit.path() + "'"));
  CHECK(outcome.status == 1);
  CHECK(outcome.err.empty());
  CHECK(contains(outcome.out, "  crash at alpha=17.25 (0x1.14p+4): SIGSEGV (Segmentation fault)\n"));
  CHECK(contains(outcome.out, "above the promise at"));
  CHECK(contains(junit.text(), "errors=\"1\""));
  CHECK(contains(junit.text(), "crash at alpha=17.25 (0x1.14p+4)"));
  // A right value is not enough.
  const json row = row_of(run(grade_kernels("rounds_up alpha=17.25 --json")));
  CHECK(row["passed"] == true);
  CHECK(row["faults"][0]["kind"] == "environment changed");
  CHECK(run(grade_kernels("rounds_up alpha=17.25")).status == 1);
}

TEST_CASE("a kernel that is slower than an older one by more than is allowed falls short") {
  // `slow` does its work thirty times, and both files have it.
  const std::string same = grade_kernels("slow --against '" + plugin_file("kernels") + "'");
  CHECK(run(same + " --max-slowdown 10000%").status == 0);
  const json row = row_of(run(same + " --max-slowdown 100 --json"));
  CHECK(row["times"]["to_older"]["passed"] == true);
  CHECK(row["times"]["to_older"]["allowed_slowdown"] == 100);
  const std::string slower = "grade '" + plugin_file("slower") +
                             "' all_sound --quiet --points 100 --against '" + plugin_file("kernels") +
                             "' --max-slowdown 200%";
  const Outcome outcome = run(slower);
  CHECK(outcome.status == 1);
  CHECK(contains(unfolded(outcome.out), "FAIL, 200 % slower is allowed"));
}

TEST_CASE("the worst point of a grade is appended once to a file like a golden one") {
  const ScratchFile file;
  std::filesystem::remove(file.path());
  for (const double alpha : {0.75, 2.5, 0.75}) verify::keep_worst(file.path(), graded_at("I3", alpha));
  const verify::GoldenFile kept = verify::read_golden(file.path());
  REQUIRE(kept.rows.size() == 2);
  CHECK(kept.rows[0].arguments == verify::Point{0.75});
  CHECK(kept.rows[1].arguments == verify::Point{2.5});
  CHECK(kept.rows[0].origin == "worst:mine");
  CHECK(kept.rows[0].numbers[0].value.size() > 50);
  CHECK_FALSE(kept.rows[0].confirmed_by.empty());
  CHECK(verify::check_golden(file.path(), {}).kept());
  CHECK_THROWS_AS(verify::keep_worst(file.path(), graded_at("I4", 1)), data::BadInput);
}

TEST_CASE("golden points are those of the ranges, and no more than asked for") {
  const verify::Quantity& quantity = verify::find_quantity("I1");
  const verify::Ranges ranges = verify::parse_ranges(quantity, {{"alpha", "1..20"}});
  const auto all = verify::golden_points(quantity, {}, 1000);
  const auto some = verify::golden_points(quantity, ranges, 1000);
  CHECK(all.size() >= 200);
  CHECK(some.size() > 0);
  CHECK(some.size() < all.size());
  for (const verify::Point& point : some) CHECK(verify::contains(ranges, point));
  CHECK(verify::golden_points(quantity, {}, 7).size() == 7);
}
