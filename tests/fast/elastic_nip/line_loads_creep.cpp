#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/elastic_nip/line_loads_diagnostics.hpp>
#include <nipref/fast/elastic_nip/line_loads_grip.hpp>
#include <nipref/fast/number/internal/feasible_set.hpp>

#include "support/test.hpp"
#include "support/thesis_nips.hpp"

using namespace nipref;
using fast::Affine;
using fast::FeasibleSet;
using fast::LineLoadSolution;
using test::middling_nip;
using test::thick_nip;
using test::thin_nip;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// By how much the thesis's conditions are violated, each in units of its own size; <= 0 if they are met.
double violation(const LineLoadSolution& solution, bool monotone_ratio) {
  const auto& P = solution.line_loads;
  const auto& Q = solution.shear_loads;
  const double p = *std::ranges::max_element(P);
  const double q = solution.peak_shear * solution.element_width();
  const double sign =
      std::copysign(1.0, *std::ranges::max_element(Q, {}, [](double x) { return std::abs(x); }));
  double worst = -infinity;
  for (std::size_t k = 0; k < P.size(); ++k) {
    worst = std::max({worst, -P[k] / p, -sign * Q[k] / q});
    if (monotone_ratio && k > 0) {
      worst = std::max(worst, std::abs(Q[k - 1]) / P[k - 1] - std::abs(Q[k]) / P[k]);
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("where linear and quadratic functions are not negative") {
  const auto parts = [](std::initializer_list<fast::Quadratic> conditions) {
    FeasibleSet set;
    for (const fast::Quadratic& condition : conditions) set.require_not_negative(condition);
    return set.parts();
  };
  CHECK(parts({}).size() == 1);
  const auto half_line = parts({{-6, 2, 0}});  // 2 x >= 6
  REQUIRE(half_line.size() == 1);
  CHECK(half_line[0].lower == 3);
  CHECK(half_line[0].upper == infinity);
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
  // The root next to 0 of x^2 + 1e8 x + 1 without cancellation.
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
    for (const bool monotone : {true, false}) {
      CAPTURE(c.nip.sheet_thickness);
      CAPTURE(c.m);
      CAPTURE(monotone);
      const auto violation_at = [&](double creep) {
        return violation(fast::gripped_line_loads_for_length(c.nip, c.m, c.length, creep), monotone);
      };
      const auto ranges = fast::creep_ranges(c.nip, c.m, c.length, {monotone});
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
  }
  CHECK(limits == 24);
}

TEST_CASE("the thesis's creep is the least in size, and there may be none") {
  const auto thick_range = fast::creep_ranges(thick_nip, 2, 0.08)[0];
  const auto chosen = fast::thesis_line_loads_for_length(thick_nip, 2, 0.08);
  REQUIRE(chosen);
  CHECK(thick_range.upper < 0);  // drawn in
  CHECK(*chosen->gripped_creep == thick_range.upper);
  const auto thin_range = fast::creep_ranges(thin_nip, 10, 0.03)[0];
  CHECK(thin_range.lower > 0);  // squeezed out
  CHECK(*fast::thesis_line_loads_for_length(thin_nip, 10, 0.03)->gripped_creep == thin_range.lower);
  // One factorisation, whatever the number of conditions.
  fast::Work work;
  CHECK(fast::creep_ranges(middling_nip, 10, 1.164 * 0.0625, {}, &work).empty());
  CHECK(work.systems == 1);
  CHECK_FALSE(fast::thesis_line_loads_for_length(middling_nip, 10, 1.164 * 0.0625).has_value());
}

TEST_CASE("the thesis's choice for a load carries it, by either iteration") {
  for (const data::ElasticNip& nip : {thick_nip, thin_nip}) {
    const int m = nip.sheet_thickness == 1.0 ? 2 : 10;
    CAPTURE(m);
    fast::Work fast_work;
    fast::Work thesis_work;
    const auto fast_search = fast::thesis_line_loads_for_load(nip, m, 100.0, {}, &fast_work);
    const auto thesis_search = fast::thesis_line_loads_for_load(
        nip, m, 100.0, {fast::LoadSearch::Iteration::thesis, 1e-12}, &thesis_work);
    REQUIRE(fast_search);
    REQUIRE(thesis_search);
    CHECK(fast_search->load == approx(100.0, 1e-13));
    CHECK(thesis_search->contact_length == approx(fast_search->contact_length, 1e-11));
    const auto range = fast::creep_ranges(nip, m, fast_search->contact_length)[0];
    CHECK(std::min(std::abs(range.lower), std::abs(range.upper)) ==
          approx(std::abs(*fast_search->gripped_creep), 1e-12));
    CHECK(fast_work.systems < thesis_work.systems);
  }
}

TEST_CASE("the creep range closes on the continuous contact like 1/m, and there the shear does not zigzag") {
  for (const double thickness : {1.0, 0.25}) {
    CAPTURE(thickness);
    const data::ElasticNip nip = data::seed::nip(thickness);
    const double length = 0.45 * thickness;
    const auto truth = fast::converged_for_length(nip, data::Friction::full, length, 1e-8);
    double last_distance = infinity;
    double last_excess = infinity;
    for (const int m : {50, 100, 200}) {
      CAPTURE(m);
      const auto ranges = fast::creep_ranges(nip, m, length);
      REQUIRE(ranges.size() == 1);
      const double creep = truth.creep_ratio().value;
      const double distance = std::max(std::abs(ranges[0].lower - creep), std::abs(ranges[0].upper - creep));
      CHECK(ranges[0].upper - ranges[0].lower < distance);
      CHECK(distance < 0.7 * last_distance);
      last_distance = distance;
      const auto chosen = fast::thesis_line_loads_for_length(nip, m, length);
      REQUIRE(chosen);
      const double excess = std::abs(chosen->load / truth.load().value - 1);
      CHECK(excess < 0.7 * last_excess);
      last_excess = excess;
      CHECK(fast::oscillation(chosen->shear_loads) < 0.1);
    }
    CHECK(last_excess < 0.02);
  }
}

TEST_CASE(
    "the thesis's creep is an end of its range: within it the conditions hold, beyond it one does not") {
  const data::ElasticNip nip{6, 0.25, {1.45e5, 1.0 / 3}};
  for (const double length : {0.05, 0.1, 0.25}) {
    CAPTURE(length);
    const auto creep = fast::thesis_creep(nip, 10, length);
    REQUIRE(creep);
    const auto [lower, upper] = creep->range;
    CHECK((creep->chosen == lower || creep->chosen == upper || creep->chosen == 0));
    CHECK(creep->chosen == fast::thesis_line_loads_for_length(nip, 10, length)->gripped_creep);
    const auto meets = [&](double chi) {
      const auto s = fast::gripped_line_loads_for_length(nip, 10, length, chi);
      bool positive = true, outwards = true, inwards = true, monotone = true;
      for (std::size_t k = 0; k < s.line_loads.size(); ++k) {
        positive = positive && s.line_loads[k] > 0;
        outwards = outwards && s.shear_loads[k] > 0;
        inwards = inwards && s.shear_loads[k] < 0;
        monotone = monotone && (k == 0 || std::fabs(s.shear_loads[k]) / s.line_loads[k] >=
                                              std::fabs(s.shear_loads[k - 1]) / s.line_loads[k - 1]);
      }
      return positive && monotone && (outwards || inwards);
    };
    const double width = upper - lower;
    CHECK(meets(lower + 1e-6 * width));
    CHECK(meets((lower + upper) / 2));
    CHECK(meets(upper - 1e-6 * width));
    CHECK_FALSE(meets(lower - 1e-6 * width));
    CHECK_FALSE(meets(upper + 1e-6 * width));
  }
}
