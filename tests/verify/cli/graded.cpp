#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/audit_run.hpp>
#include <nipref/verify/cli/graded.hpp>
#include <nipref/verify/golden/check.hpp>
#include <nipref/verify/golden/golden.hpp>

#include "support/scratch.hpp"

using namespace nipref;

namespace {

verify::Graded graded_at(const char* quantity, double alpha) {
  const std::vector<verify::Point> points{{alpha}};
  const std::vector<double> values{1.0};
  return {verify::grade_of("mine", "its points",
                           verify::audit_values(verify::find_quantity(quantity), points, values, {})),
          0};
}

}  // namespace

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
