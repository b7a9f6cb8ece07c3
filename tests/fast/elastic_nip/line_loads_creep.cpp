#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/number/internal/feasible_set.hpp>

#include "support/test.hpp"
#include "support/thesis_nips.hpp"

using namespace nipref;
using namespace nipref::test;

namespace {

/// The normal or the shear loads of one side, from the middle outwards.
std::vector<double> side_of(const fast::LineLoadNip& solution, double fast::FaceLoad::*kind) {
  std::vector<double> loads;
  for (auto k = static_cast<std::size_t>(solution.leading_elements); k > 0; --k)
    loads.push_back(solution.loads[k - 1].*kind);
  return loads;
}

/// The largest violation of the thesis's conditions, each divided by its own scale; <= 0 if all conditions are met.
double violation(const fast::LineLoadNip& solution) {
  const std::vector<double> P = side_of(solution, &fast::FaceLoad::normal),
                            Q = side_of(solution, &fast::FaceLoad::shear);
  const double p = *std::ranges::max_element(P);
  const double q = solution.peak_shear() * solution.element_width();
  const double sign =
      std::copysign(1.0, *std::ranges::max_element(Q, {}, [](double x) { return std::abs(x); }));
  double worst = -infinite;
  for (std::size_t k = 0; k < P.size(); ++k) {
    worst = std::max({worst, -P[k] / p, -sign * Q[k] / q});
    if (k > 0) worst = std::max(worst, std::abs(Q[k - 1]) / P[k - 1] - std::abs(Q[k]) / P[k]);
  }
  return worst;
}

/// The ranges of creep that meet the conditions. They do not depend on the given creep.
std::vector<fast::CreepRange> creep_ranges(const data::ElasticNip& where, int m, double length) {
  return fast::line_loads_for_length(where, m, length, full_friction(0)).creep_ranges;
}

}  // namespace

TEST_CASE("the parts of the axis where linear and quadratic functions are not negative are found") {
  const auto parts = [](std::initializer_list<fast::Quadratic> conditions) {
    fast::FeasibleSet set;
    for (const fast::Quadratic& condition : conditions) set.require_not_negative(condition);
    return set.parts();
  };
  CHECK(parts({}).size() == 1);
  const auto half_line = parts({{-6, 2, 0}});  // 2 x >= 6
  REQUIRE(half_line.size() == 1);
  CHECK(half_line[0].lower == 3);
  CHECK(half_line[0].upper == infinite);
  const auto outside = parts({{6, -5, 1}});  // (x - 2) (x - 3) >= 0
  REQUIRE(outside.size() == 2);
  CHECK(outside[0].upper == doctest::Approx(2));
  CHECK(outside[1].lower == doctest::Approx(3));
  const auto inside = parts({{-6, 5, -1}, {5, -2, 0}});  // 2 <= x <= 3 and x <= 2.5
  REQUIRE(inside.size() == 1);
  CHECK(inside[0].lower == doctest::Approx(2));
  CHECK(inside[0].upper == 2.5);
  CHECK(parts({{-1, 0, -1}}).empty());             // -1 - x^2 >= 0
  CHECK(parts({{1, 0, 1}}).size() == 1);           // always
  CHECK(parts({{-1, 0, 0}}).empty());              // never
  CHECK(parts({{-6, 2, 0}, {2, -1, 0}}).empty());  // x >= 3 and x <= 2
  // The root next to 0 of x^2 + 1e8 x + 1 is computed without cancellation.
  CHECK(parts({{1, 1e8, 1}})[1].lower == approx(-1e-8, 1e-15));
}

TEST_CASE("inside the creep range the thesis's conditions hold, just outside they do not") {
  struct Case {
    data::ElasticNip nip;
    int m;
    double length;
  };
  int limits = 0;
  for (const Case& c : {Case{thick_nip, 2, 0.08}, Case{thick_nip, 5, 0.1}, Case{thick_nip, 10, 0.1},
                        Case{middling_nip, 5, 0.05}, Case{thin_nip, 10, 0.03}, Case{thin_nip, 10, 0.044}}) {
    CAPTURE(c.nip.sheet_thickness, c.m);
    const auto violation_at = [&](double creep) {
      return violation(fast::line_loads_for_length(c.nip, c.m, c.length, full_friction(creep)));
    };
    const auto ranges = creep_ranges(c.nip, c.m, c.length);
    REQUIRE(ranges.size() == 1);
    const auto [lower, upper] = ranges[0];
    const double margin = 1e-5 * (upper - lower);
    for (const double part : {0.0, 0.3, 0.5, 1.0}) {
      CHECK(violation_at(lower + margin + part * (upper - lower - 2 * margin)) <= 1e-12);
    }
    CHECK(violation_at(lower - margin) > 0);
    CHECK(violation_at(upper + margin) > 0);
    limits += 2;
  }
  CHECK(limits == 12);
}

TEST_CASE("the thesis's creep is the least in size, and there may be none") {
  const auto thick_range = creep_ranges(thick_nip, 2, 0.08)[0];
  const auto chosen = fast::line_loads_for_length(thick_nip, 2, 0.08, thesis_friction);
  CHECK(thick_range.upper < 0);  // drawn in
  CHECK(*chosen.gripped_creep == thick_range.upper);
  const auto thin_range = creep_ranges(thin_nip, 10, 0.03)[0];
  CHECK(thin_range.lower > 0);  // squeezed out
  CHECK(*fast::line_loads_for_length(thin_nip, 10, 0.03, thesis_friction).gripped_creep == thin_range.lower);
  // One factorisation serves any number of conditions.
  const auto without = fast::line_loads_for_length(middling_nip, 10, 1.164 * 0.0625, full_friction(0));
  CHECK(without.creep_ranges.empty());
  CHECK(without.work().systems == 1);
  CHECK_REFUSED(fast::line_loads_for_length(middling_nip, 10, 1.164 * 0.0625, thesis_friction),
                "no creep meets the thesis's conditions here");
}

TEST_CASE("the thesis's choice for a load carries it, by either iteration") {
  for (const data::ElasticNip& nip : {thick_nip, thin_nip}) {
    const int m = nip.sheet_thickness == 1.0 ? 2 : 10;
    CAPTURE(m);
    const auto fast_search = fast::line_loads_for_load(nip, m, 100.0, thesis_friction);
    const auto thesis_search = fast::line_loads_for_load(nip, m, 100.0, thesis_friction,
                                                         {fast::LoadSearch::Iteration::thesis, 1e-12});
    CHECK(fast_search.load() == approx(100.0, 1e-13));
    CHECK(thesis_search.contact_length() == approx(fast_search.contact_length(), 1e-11));
    const auto range = creep_ranges(nip, m, fast_search.contact_length())[0];
    CHECK(std::min(std::abs(range.lower), std::abs(range.upper)) ==
          approx(std::abs(*fast_search.gripped_creep), 1e-12));
    CHECK(fast_search.work().systems < thesis_search.work().systems);
  }
}
