#include <mutex>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/ranges.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

#include "support/test.hpp"

using namespace nipref;
using verify::AuditResult;
using verify::Quantity;

namespace {

constexpr std::size_t few = 3000;

/// I3, a cheap kernel without zeros, with fast's value replaced by damage(alpha, value).
template <class Damage>
Quantity damaged_I3(Damage damage) {
  Quantity quantity = verify::find_quantity("I3");
  const auto sound = quantity.by_fast;
  quantity.by_fast = [sound, damage](std::span<const double> point, fast::Accuracy accuracy) {
    return damage(point[0], sound(point, accuracy));
  };
  return quantity;
}

AuditResult audit_few(const Quantity& quantity) { return verify::audit(quantity, {few, {}, {}}); }

}  // namespace

TEST_CASE("the audit passes the sound kernel, the same every time") {
  const Quantity sound = damaged_I3([](double, double value) { return value; });
  const AuditResult found = audit_few(sound), again = audit_few(sound);
  CHECK(found.kept());
  CHECK(found.max_error_ulp > 0);
  CHECK(found.errors.mean() > 0);
  CHECK(found.errors.mean() < found.max_error_ulp);
  CHECK(found.points >= few / 2);
  CHECK(found.max_error_ulp == again.max_error_ulp);
  CHECK(found.errors == again.errors);
  CHECK(found.worst == again.worst);
}

TEST_CASE("the audit finds what is wrong in a window, at one point or no number, and climbs to a peak") {
  struct Planted {
    std::size_t points;
    double lower, upper;  ///< range of |alpha| at the worst point
    std::function<double(double alpha, double value)> damage;
  };
  const auto at = [](double place) {
    return Planted{20'000, place, place,
                   [=](double alpha, double value) { return alpha == place ? 1.001 * value : value; }};
  };
  const auto between = [](double lower, double upper, double factor) {
    return Planted{few, lower, upper, [=](double alpha, double value) {
                     return std::fabs(alpha) > lower && std::fabs(alpha) < upper ? value * factor : value;
                   }};
  };
  for (const Planted& planted : {between(1.5, 1.6, 1 + 0x1p-50), between(3, 4, std::nan("")),
                                 at(verify::find_quantity("I3").arguments[0].hard_values[2]),
                                 at(17.25),  // a branch point, a knot of a table
                                 // An error with a peak of 1000 ulps at 2 and a width of 1e-2.
                                 Planted{10'000, 2 - 1e-3, 2 + 1e-3, [](double alpha, double value) {
                                           const double distance = (std::fabs(alpha) - 2) / 1e-2;
                                           return value *
                                                  (1 + 1000 * 0x1p-53 * std::exp(-distance * distance));
                                         }}}) {
    const AuditResult found = verify::audit(damaged_I3(planted.damage), {planted.points, {}, {}});
    CHECK_FALSE(found.kept());
    CHECK(std::fabs(found.worst.at(0)) >= planted.lower);
    CHECK(std::fabs(found.worst.at(0)) <= planted.upper);
  }
}

TEST_CASE("a density scales a quantity's own number of points, at least one, a given number is absolute") {
  Quantity quantity = verify::find_quantity("I3");
  quantity.audit_points = 6;
  const auto points = [&](std::size_t absolute, double density) {
    return verify::AuditOptions{absolute, {}, {}, density}.points_of(quantity);
  };
  CHECK(points(0, 1) == 6);
  CHECK(points(0, 0.5) == 3);
  CHECK(points(0, 1e-6) == 1);
  CHECK(points(0, 10) == 60);
  CHECK(points(5, 10) == 5);
  const AuditResult least = verify::audit(quantity, {0, {}, {}, 1e-6});
  CHECK(least.points == 1);
  CHECK(least.fault_width() == doctest::Approx(0.95));
  CHECK(least.worst.size() == 1);
}

TEST_CASE("at a lower accuracy the audit allows that much and no more") {
  const Quantity wrong = damaged_I3([](double, double value) { return value * (1 + 1e-7); });
  CHECK(verify::audit(wrong, {few, fast::Accuracy(1e-6), {}}).kept());
  CHECK_FALSE(verify::audit(wrong, {few, fast::Accuracy(1e-9), {}}).kept());
}

TEST_CASE("in ranges the audit looks nowhere else, and its search does not leave them") {
  const Quantity& quantity = verify::find_quantity("I6");
  std::mutex mutex;
  std::size_t looked = 0, outside = 0;
  std::set<double> ends;
  const verify::Ranges ranges = verify::parse_ranges(quantity, {{"alpha", "1..2"}, {"eta", "-3"}});
  const auto watch = [&](std::span<const verify::Point> points, std::span<double> values) {
    const std::scoped_lock lock(mutex);
    for (const verify::Point& point : points) {
      ++looked;
      if (!verify::contains(ranges, point)) ++outside;
      if (point[0] == 1 || point[0] == 2) ends.insert(point[0]);
    }
    verify::fast_evaluator(quantity, {})(points, values);
  };
  verify::AuditOptions options{few, {}, {}};
  options.ranges = ranges;
  const AuditResult found = verify::audit(quantity, watch, options);
  CHECK(found.kept());
  CHECK(found.points == looked);
  CHECK(outside == 0);
  CHECK(ends.size() == 2);
}

TEST_CASE("points of the ranges that have no such quantity are left out, unless all are") {
  const Quantity& quantity = verify::find_quantity("halfspace.compliance");
  verify::AuditOptions options{60, {}, {}};
  options.ranges =
      verify::parse_ranges(quantity, {{"poisson", "0.3"}, {"speed", "0.5..1.5"}, {"psi_deg", "0"}});
  const AuditResult found = verify::audit(quantity, options);
  CHECK(found.kept());
  CHECK(found.left_out > 0);
  CHECK(found.errors.percentile(0.5) > 0);
  options.ranges =
      verify::parse_ranges(quantity, {{"poisson", "0.3"}, {"speed", "1.1..1.5"}, {"psi_deg", "0"}});
  CHECK_THROWS_AS(static_cast<void>(verify::audit(quantity, options)), data::BadInput);
}

TEST_CASE("points for which the reference has no value are counted, and no fault of the audit") {
  Quantity quantity = verify::find_quantity("I1");
  const auto sound = quantity.by_ref;
  quantity.by_ref = [sound](std::span<const ref::Exact> x, int digits) {
    if (std::fabs(x[0].approximate()) < 1) throw data::BadInput("alpha", x[0].approximate(), "too near");
    return sound(x, digits);
  };
  const AuditResult found = verify::audit(quantity, {300, {}, {}});
  CHECK(found.kept());
  CHECK(found.left_out > 0);
  CHECK(verify::audit_row_json(found).at("left_out").as_count() == found.left_out);
}

TEST_CASE("zeros are looked for where the reference has values") {
  static constexpr double farthest = 60;
  Quantity quantity = verify::find_quantity("I1");
  quantity.arguments[0].hard_values = {};
  quantity.draw = [](verify::Random& random) { return verify::Point{random.uniform(0.1, farthest)}; };
  quantity.keep_off = [](verify::Point& point) { point[0] = std::clamp(point[0], -farthest, farthest); };
  const auto sound = quantity.by_ref;
  quantity.by_ref = [sound](std::span<const ref::Exact> x, int digits) {
    if (std::fabs(x[0].approximate()) > farthest)
      throw data::BadInput("alpha", x[0].approximate(), "too far");
    return sound(x, digits);
  };
  CHECK(audit_few(quantity).kept());
}

TEST_CASE("a promise of one's own and points of one's own decide") {
  constexpr double only = 0.7296875;
  const Quantity wrong =
      damaged_I3([only](double alpha, double value) { return alpha == only ? 2 * value : value; });
  verify::AuditOptions options{300, {}, {}};
  CHECK(verify::audit(wrong, options).kept());
  options.more_points = {{only}};
  const AuditResult found = verify::audit(wrong, options);
  CHECK_FALSE(found.kept());
  CHECK(found.worst == verify::Point{only});
  REQUIRE(found.spread.wrong.has_value());
  CHECK(found.spread.wrong->lower == verify::Point{only});
  options.promise = 1e17;
  CHECK(verify::audit(wrong, options).kept());
}

TEST_CASE("values that are there already are judged as the evaluator's would be") {
  const Quantity& quantity = verify::find_quantity("I3");
  const std::vector<verify::Point> points{{0.5}, {1}, {2}};
  std::vector<double> values(points.size());
  verify::fast_evaluator(quantity, {})(points, values);
  CHECK(verify::audit_values(quantity, points, values, {}).kept());
  values[1] *= 1 + 1e-12;
  const AuditResult found = verify::audit_values(quantity, points, values, {});
  CHECK_FALSE(found.kept());
  CHECK(found.points == 3);
  CHECK(found.worst == points[1]);
  CHECK(found.max_relative_error == doctest::Approx(1e-12).epsilon(1e-3));
}

TEST_CASE("a parallel loop visits each index once and passes exceptions on") {
  std::mutex mutex;
  std::multiset<std::size_t> visited;
  verify::parallel_for(1000, [&](std::size_t i) {
    const std::scoped_lock lock(mutex);
    visited.insert(i);
  });
  CHECK(visited.size() == 1000);
  CHECK(std::set<std::size_t>(visited.begin(), visited.end()).size() == 1000);
  const auto fail_at_500 = [](std::size_t i) {
    if (i == 500) throw std::runtime_error("planted");
  };
  CHECK_THROWS_AS(verify::parallel_for(1000, fail_at_500), std::runtime_error);
}
