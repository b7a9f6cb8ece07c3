#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <set>
#include <stdexcept>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

using namespace nipref;
using verify::AuditResult;
using verify::Quantity;

namespace {

constexpr std::size_t few = 3000;

/// I3 with fast's value changed by `damage(alpha, value)`. A cheap kernel without zeros.
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

TEST_CASE("the audit passes the sound kernel") {
  const Quantity sound = damaged_I3([](double, double value) { return value; });
  const AuditResult found = audit_few(sound);
  CHECK(found.kept());
  CHECK(found.max_error_ulp > 0);
  CHECK(found.mean_error_ulp > 0);
  CHECK(found.mean_error_ulp < found.max_error_ulp);
  CHECK(found.points >= few / 2);
  REQUIRE(found.worst.size() == 1);
}

TEST_CASE(
    "a density scales a quantity's own number of points, one is the least, and a number of points is absolute") {
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
  CHECK(least.few_points());
  CHECK(least.worst.size() == 1);
}

TEST_CASE("the audit is the same every time") {
  const Quantity& quantity = verify::find_quantity("I7");
  const AuditResult first = verify::audit(quantity, {500, {}, {}});
  const AuditResult second = verify::audit(quantity, {500, {}, {}});
  CHECK(first.max_error_ulp == second.max_error_ulp);
  CHECK(first.mean_error_ulp == second.mean_error_ulp);
  CHECK(first.worst == second.worst);
}

TEST_CASE("the audit finds an error of a few ulps in a narrow window") {
  const Quantity wrong = damaged_I3([](double alpha, double value) {
    return std::fabs(alpha) > 1.5 && std::fabs(alpha) < 1.6 ? value * (1 + 0x1p-50) : value;
  });
  const AuditResult found = audit_few(wrong);
  CHECK_FALSE(found.kept());
  CHECK(std::fabs(found.worst[0]) > 1.5);
  CHECK(std::fabs(found.worst[0]) < 1.6);
}

TEST_CASE("the audit finds an error at a branch point's neighbour alone") {
  const double branch = verify::find_quantity("I3").arguments[0].hard_values[2];
  const Quantity wrong =
      damaged_I3([branch](double alpha, double value) { return alpha == branch ? 1.001 * value : value; });
  const AuditResult found = verify::audit(wrong, {20'000, {}, {}});
  CHECK_FALSE(found.kept());
  CHECK(found.worst[0] == branch);
}

TEST_CASE("the audit does not let a value pass that is no number") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Quantity wrong =
      damaged_I3([](double alpha, double value) { return alpha > 3 && alpha < 4 ? nan : value; });
  CHECK_FALSE(audit_few(wrong).kept());
}

TEST_CASE("the audit's local search climbs to the peak of a smooth error") {
  // The error peaks at 2 with a width of 1e-2; its top is 1000 ulps.
  const Quantity wrong = damaged_I3([](double alpha, double value) {
    const double distance = (std::fabs(alpha) - 2) / 1e-2;
    return value * (1 + 1000 * 0x1p-53 * std::exp(-distance * distance));
  });
  const AuditResult found = verify::audit(wrong, {10'000, {}, {}});
  CHECK(std::fabs(std::fabs(found.worst[0]) - 2) < 1e-3);
}

TEST_CASE("at a lower accuracy the audit allows that much and no more") {
  const Quantity wrong = damaged_I3([](double, double value) { return value * (1 + 1e-7); });
  CHECK(verify::audit(wrong, {few, fast::Accuracy(1e-6), {}}).kept());
  CHECK_FALSE(verify::audit(wrong, {few, fast::Accuracy(1e-9), {}}).kept());
}

TEST_CASE("a parallel loop visits each index once and passes exceptions on") {
  std::mutex mutex;
  std::multiset<std::size_t> visited;
  verify::parallel_for(1000,
                       [&](std::size_t i) {
                         const std::scoped_lock lock(mutex);
                         visited.insert(i);
                       },
                       {});
  CHECK(visited.size() == 1000);
  CHECK(std::set<std::size_t>(visited.begin(), visited.end()).size() == 1000);
  CHECK_THROWS_AS(verify::parallel_for(1000,
                                       [](std::size_t i) {
                                         if (i == 500) throw std::runtime_error("planted");
                                       },
                                       {}),
                  std::runtime_error);
}
