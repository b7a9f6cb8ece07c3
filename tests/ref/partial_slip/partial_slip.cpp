// The contact with partial slip in multiprecision: against closed limits, its own inequalities and balances.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/nip/internal/sheet_kernels.hpp>
#include <nipref/ref/partial_slip/internal/slip_solution.hpp>
#include <nipref/ref/partial_slip/partial_slip.hpp>

#include "support/reference_values.hpp"
#include "support/test.hpp"

using namespace nipref;
using data::GivenCreep;
using data::GivenTraction;
using ref::Estimate;
using ref::Float;
using ref::partial_slip_for_length;
using ref::partial_slip_for_load;
using ref::PartialSlipNip;

namespace {

/// All units of the dimensionless contact are powers of two: b = 1, b/(2R) = 2^-10, N = 1.
constexpr double slope = 0x1p-10;

/// A contact with much friction and coupling.
ref::SlipProblem short_contact(double shear) {
  ref::SlipProblem problem;
  problem.beta = 0.6875;
  problem.friction = 0.75;
  problem.length = problem.unit = 0.0625;
  problem.shear = shear;
  return problem;
}

data::PartialSlipNip slipping_nip(double poisson, double friction, const data::Drive& drive) {
  data::ElasticNip nip = data::seed::nip(2);
  nip.roller_radius = 512;
  nip.material.poisson = poisson;
  nip.material.young = 2 * (1 - poisson) * (1 + poisson);
  return {nip, friction, drive};
}

Float apart(const Float& a, const Float& b) { return abs(a - b); }

/// Checks that the dissipation is the power of traction and load.
void check_balance(const PartialSlipNip& nip) {
  const Estimate lost = nip.dissipation();
  CHECK(lost.value > 0);
  CHECK(meet(nip.load() * nip.rolling_resistance() - nip.creep_ratio() * nip.traction(), lost));
}

void check_inequalities(const PartialSlipNip& nip, double friction) {
  const std::vector<Estimate> ends = nip.zone_boundaries();
  const std::vector<int> signs = nip.zone_signs();
  REQUIRE(ends.size() == signs.size() + 1);
  for (std::size_t zone = 0; zone < signs.size(); ++zone) {
    for (double part : {0.03, 0.6}) {
      const double y = (1 - part) * ends[zone].to_double() + part * ends[zone + 1].to_double();
      const Estimate pressure = nip.pressure(y), shear = nip.shear(y), slip = nip.slip(y);
      CAPTURE(y, signs[zone], pressure.to_double(), shear.to_double(), slip.to_double());
      CHECK(pressure.value > 0);
      if (signs[zone] == 0) {
        CHECK(abs(shear.value) < friction * pressure.value);
        CHECK(slip.value == 0);
      } else {
        CHECK(apart(shear.value, signs[zone] * Float(friction) * pressure.value) <= shear.error);
        CHECK(signs[zone] * slip.value > 0);
      }
    }
  }
}

}  // namespace

TEST_CASE("ref partial slip: a small contact without coupling is Carter's") {
  constexpr double friction = 0.3;
  const ref::WorkingDigits working(60);
  const Float a = Float(0x1p-26), load = ref::pi() * a * a;
  const double traction = 0.4375 * friction * static_cast<double>(load) * slope;
  const PartialSlipNip nip = partial_slip_for_length(slipping_nip(0.5, friction, GivenTraction{traction}),
                                                     2 * static_cast<double>(a), 16);
  // The relative corrections of Carter's contact are a^2, except for the strain under the whole load.
  const Float coupling = ref::SheetKernels(30).coupling_slope(0) / ref::pi();
  const Float carried = nip.load().value / slope,
              stick = sqrt(1 - traction / (friction * carried * slope)) * a,
              creep = -2 * friction * (a - stick) + coupling * load, least = a * a;
  CHECK(nip.zone_signs() == std::vector<int>{0, 1});
  CHECK(apart(carried, load) < load * least);
  CHECK(apart(nip.leading_length().value, a + coupling * traction / slope / 2) < a * least);
  CHECK(apart(nip.zone_boundaries()[1].value, nip.leading_length().value - 2 * stick) < a * least);
  CHECK(apart(nip.creep_ratio().value / slope, creep) < 4 * a * least);
  CHECK(apart(nip.pressure(0).value / slope, 2 * a) < 2 * a * least);
  CHECK(nip.creep_ratio().error < a * slope * 1e-15);
  CHECK(nip.shear(1).value_text() == "0");
  // Next to an end the pressure is like the root of the distance, and errs by its change over the error of the end.
  const Estimate end = nip.leading_length();
  const double beside = std::nextafter(end.to_double(), 0);
  const Estimate least_pressure = nip.pressure(beside);
  CHECK(least_pressure.error >= least_pressure.value * end.error / (2 * (end.value - beside)));
  check_balance(nip);
}

TEST_CASE(
    "ref partial slip: what is lost is what traction and load bring in, and slip is opposed everywhere") {
  constexpr double friction = 0.3;
  const double load = 0x1p-5 * slope;
  const PartialSlipNip nip =
      partial_slip_for_load(slipping_nip(0.25, friction, GivenTraction{-0.5 * friction * load}), load, 16);
  CHECK(nip.zone_signs() == std::vector<int>{1, 0, -1});
  CHECK(apart(nip.load().value, load) <= nip.load().error);
  check_balance(nip);
  check_inequalities(nip, friction);
  const Estimate d0 = nip.indentation();
  const Float trailing = nip.trailing_length().value;
  CHECK(apart(nip.trailing_displacement().value, d0.value - trailing * trailing * slope) <= 4 * d0.error);
  // In the stick zone the strain of the surface is the creep.
  const double y = 0.5 * nip.leading_length().to_double();
  const Estimate v = nip.tangential_displacement(y);
  CHECK(apart(v.value - nip.tangential_displacement(y / 2).value, nip.creep_ratio().value * y / 2) <=
        4 * v.error);
  for (double place : {-0.02, 0., 0.003}) CHECK(nip.pressure(place).value < nip.peak_pressure().value);
  // The shear has a peak at either end of the stick zone, with opposite signs.
  const Estimate highest = nip.peak_shear(), place = nip.peak_shear_position();
  for (const Estimate& end : nip.zone_boundaries())
    CHECK(abs(nip.shear(end.to_double()).value) < highest.value + highest.error);
  CHECK(abs(abs(nip.shear(place.to_double()).value) - highest.value) < 1e-9 * highest.value);
  CHECK(place.error < 1e-14 * nip.contact_length().value);
}

TEST_CASE(
    "ref partial slip: a contact that rolls freely and sticks all along is the one with full friction") {
  const auto nip = slipping_nip(0.4921875, 0.5, GivenTraction{0});
  const PartialSlipNip stuck = partial_slip_for_length(nip, 1.5, 16);
  const ref::ConvergedNip gripped = ref::converged_for_length(nip, data::Friction::full, 1.5, 20);
  CHECK(stuck.zone_signs() == std::vector<int>{0});
  CHECK(abs(stuck.traction().value) <= stuck.traction().error);
  CHECK(meet(stuck.load(), gripped.load()));
  CHECK(meet(stuck.creep_ratio(), gripped.creep_ratio()));
  CHECK(meet(stuck.peak_shear(), gripped.peak_shear()));
  for (double y : {0., 0.3, -0.7}) CHECK(meet(stuck.shear(y), gripped.shear(y)));
}

TEST_CASE("ref partial slip: what is no contact with partial slip is refused") {
  const auto nip = slipping_nip(0.5, 0.25, GivenTraction{0x1p-30});
  const auto sliding = slipping_nip(0.5, 0.25, GivenTraction{0x1p-22});
  CHECK_REFUSED(partial_slip_for_load(sliding, 0x1p-20, 16), "force_per_length = ");
  CHECK_REFUSED(partial_slip_for_load(nip, -1, 16), "load = -1");
  CHECK_REFUSED(partial_slip_for_load(nip, 1e9, 16), "load = 1000000000");
  CHECK_REFUSED(partial_slip_for_length(nip, 21, 16), "contact_length = 21");
  CHECK_REFUSED(partial_slip_for_length(nip, 1e-9, 16), "contact_length = 1e-09");
  CHECK_REFUSED(partial_slip_for_length(nip, 1, 31), "digits = 31");
  CHECK_REFUSED(partial_slip_for_length(slipping_nip(0.5, 0, GivenCreep{0}), 1, 16),
                "friction_coefficient = 0");
  CHECK_REFUSED(partial_slip_for_length(slipping_nip(0.5, 1, GivenCreep{HUGE_VAL}), 1, 16),
                "creep_ratio = inf");
}

TEST_CASE("ref partial slip: without slip that is opposed all of a fast roller's contact slides") {
  const PartialSlipNip nip = partial_slip_for_length(slipping_nip(0.3, 0.25, GivenCreep{-1}), 0x1p-4, 16);
  CHECK(nip.zone_signs() == std::vector<int>{1});
  CHECK(apart(nip.traction().value, Float(0.25) * nip.load().value) <= nip.load().error);
  check_balance(nip);
  check_inequalities(nip, 0.25);
}

TEST_CASE("ref partial slip: a zone keeps its panels when its length changes") {
  const ref::WorkingDigits working(20);
  ref::SlipProblem problem;
  problem.beta = 0.25;
  problem.friction = 0.5;
  ref::Row<ref::SlipZone> zones;
  zones.push_back({0, 2.75});
  const ref::ZoneGrid grid(problem, 10, zones);
  zones[0].length = 3.25;
  CHECK(ref::ZonePanels(zones, grid).count() == 1);
  CHECK(ref::ZonePanels(zones, ref::ZoneGrid(problem, 10, zones)).count() == 2);
}

TEST_CASE("ref partial slip: what nearly slides is guessed to stick somewhere") {
  const ref::WorkingDigits working(40);
  ref::SlipProblem problem;
  problem.beta = 0.25;
  problem.friction = 0.0625;
  problem.load = 1e-6;
  problem.shear = -0.9999 * problem.friction * problem.load;
  ref::SheetKernels kernels(20);
  const ref::Row<ref::SlipZone> zones = ref::plain_zones(problem, kernels, 1e-3);
  CHECK(std::ranges::count(zones, 0, &ref::SlipZone::sign) == 1);
}

TEST_CASE("ref partial slip: with large friction and coupling, zones are guessed to an element of 1/120") {
  const ref::WorkingDigits working(60);
  ref::SlipProblem problem;
  problem.beta = 0.6875;
  problem.friction = 0.75;
  problem.load = 1e-3;
  problem.unit = 0.03125;
  for (const double part : {0.375, 0.875}) {
    problem.shear = part * problem.friction * problem.load;
    ref::SheetKernels kernels(20);
    const ref::Row<ref::SlipZone> guess = ref::plain_zones(problem, kernels, 0.03125);
    const ref::SolvedSlip solved = ref::solved_slip(problem, kernels, guess, 6);
    REQUIRE(solved.fine != nullptr);
    CHECK(guess.back().sign == solved.fine->zones().back().sign);
    CHECK(apart(guess.back().length / 0.03125, solved.fine->zones().back().length / solved.fine->length()) <
          1.0 / 120);
  }
}

TEST_CASE("ref partial slip: a zone that shrinks to nothing at the trailing end leaves the slip before it") {
  const ref::WorkingDigits working(60);
  // This contact is not found either if Newton's method begins at least squares in place of tractions found before.
  const ref::SlipProblem problem = short_contact(1.848e-4);
  ref::SheetKernels kernels(20);
  const ref::Row<ref::SlipZone> guess{{-1, 0.004}, {0, 0.0455}, {1, 0.0115}, {0, 0.0013}, {-1, 0.0002}};
  CHECK(ref::solved_slip(problem, kernels, guess, 2).fine != nullptr);
}

TEST_CASE(
    "ref partial slip: a solution whose slip is not opposed is not taken, though its zones have the right signs") {
  const ref::WorkingDigits working(60);
  const ref::SlipProblem problem = short_contact(9.259e-5);
  ref::SheetKernels kernels(20);
  const ref::SolvedSlip solved =
      ref::solved_slip(problem, kernels, ref::plain_zones(problem, kernels, 0.0625), 2);
  REQUIRE(solved.fine != nullptr);
  for (const ref::SlipField::Sample& sample : solved.fine->samples()) CHECK(sample.sign * sample.slip < 1e-6);
}

TEST_CASE("ref partial slip: with little friction, zones are guessed as half-spaces have them") {
  const ref::WorkingDigits working(40);
  constexpr double a = 0x1p-11;  // half the length
  ref::SlipProblem problem;
  problem.beta = 0.25;
  problem.friction = 1e-6;
  problem.load = std::numbers::pi * a * a;
  ref::SheetKernels kernels(20);
  const ref::Row<ref::SlipZone> zones = ref::plain_zones(problem, kernels, 2 * a);
  REQUIRE(zones.count() == 5);
  // p = 2 (a^2 - x^2)^(1/2) strains the surface by beta p. Without traction half of the load is between -x and x. An
  // element is a sixtieth of a long, which makes errors of some hundredths of the slope of the slip.
  constexpr double x = 0.40397 * a;
  for (int outer : {0, 4}) CHECK(apart(zones[outer].length, a - x) < 0.02 * a);
  for (int sticks : {1, 3}) {
    CHECK(zones[sticks].sign == 0);
    const double length = 4 * problem.friction * (a * a - x * x) / (std::numbers::pi * 0.25 * x);
    CHECK(apart(zones[sticks].length, length) < 0.1 * length);
  }
}
