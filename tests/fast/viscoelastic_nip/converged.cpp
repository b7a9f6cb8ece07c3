// The converged viscoelastic nip: fluids, two discretisations, memories that are hard, errors of small numbers.
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/internal/rolling_equations.hpp>

#include "support/covered.hpp"
#include "support/softening_sheet.hpp"

using namespace nipref;
using namespace nipref::test;
using data::ViscoelasticNip;
using fast::converged_for_length;
using fast::Estimate;
using fast::Panel;
using fast::RollingEquations;
using fast::Solution;

namespace {

/// Dimensionless equations of a sheet that softens by one half.
RollingEquations equations(double rate) {
  return RollingEquations({fast::rolling_compliance({{rate, rate}}), 0.25, {{rate / 4, rate}}});
}

Solution solve(double half_length, const RollingEquations& equations, const std::vector<Panel>& panels) {
  fast::Work work;
  fast::CountedKernels kernels(fast::Accuracy{}, work);
  return equations.solve(half_length, panels, 1e-16, kernels);
}

Solution solve(double half_length, const RollingEquations& equations) {
  return solve(half_length, equations, fast::panels(half_length, equations.resolution(34)));
}

/// The pressure at the distance e from the leading or the trailing end.
double pressure(const Solution& solution, bool trailing, double e) {
  const std::complex<double> g = solution.traction(e);
  return trailing ? g.real() - g.imag() : g.real() + g.imag();
}

double carried_load(const Solution& solution) { return solution.value(solution.load()); }

}  // namespace

TEST_CASE("behind a fluid's contact the sheet keeps its displacement and strain, as nearly a slow one") {
  const auto rolled = [](double rate) {
    const ViscoelasticNip nip{radius, thickness, {{1e-5, {{8e-5, rate}}}, {4e-6, {{1e-5, rate}}}}, 1};
    return converged_for_length(nip, 0.1, 1e-12);
  };
  const auto fluid = rolled(0), slow = rolled(1e-12);
  CHECK(slow.load().value == approx(fluid.load().value, 1e-11));
  CHECK(slow.surface_strain(-1).value == approx(fluid.surface_strain(-1).value, 1e-9));
  CHECK(fluid.surface_strain(-1e6).value == approx(fluid.surface_strain(-5).value, 1e-12));
  CHECK(fluid.tangential_displacement(-1e6).value == approx(-1e6 * fluid.surface_strain(-5).value, 1e-5));
  // I1 integrates to pi/2 half-thicknesses, and a dashpot forgets no force.
  for (const double y : {-5.0, -1e6})
    CHECK(fluid.normal_displacement(y).value == approx(9e-5 * fluid.load().value * thickness / 4, 1e-11));
}

TEST_CASE("what is kept of one contact changes no other, shorter or longer") {
  const RollingEquations used = equations(0.5);
  for (const double half_length : {0.2, 0.36, 0.1, 0.105}) {
    const double fresh = carried_load(solve(half_length, equations(0.5)));
    CHECK(carried_load(solve(half_length, used)) == approx(fresh, 1e-14));
  }
}

TEST_CASE("two discretisations of a rolling contact agree") {
  for (const double half_length : {1e-4, 0.4, 2.0, 15.0}) {
    for (const double rate_length : {0.01, 1.0, 30.0}) {  // half-length over the relaxation length
      CAPTURE(half_length, rate_length);
      const RollingEquations equations = ::equations(rate_length / half_length);
      std::vector<Panel> panels{{0, half_length / 16, true, false, 26}};
      for (double left = half_length / 16; left < half_length / 2; left *= 2)
        panels.push_back({left, 2 * left, false, false, 26});
      panels.push_back({half_length / 2, 1.5 * half_length, false, true, 22});
      const Solution one = solve(half_length, equations), two = solve(half_length, equations, panels);
      const auto check = [&](double a, double b, double scale) {
        CHECK(std::fabs(a - b) <= 1e-10 * std::max(scale, std::fabs(b)));
      };
      check(carried_load(one), carried_load(two), 0);
      check(one.unknown(RollingEquations::offset), two.unknown(RollingEquations::offset), 0);
      check(one.unknown(RollingEquations::middle_displacement(one)),
            two.unknown(RollingEquations::middle_displacement(two)), half_length * half_length);
      check(one.value(equations.eccentricity(one)), two.value(equations.eccentricity(two)), 0);
      const double middle = pressure(two, false, half_length);
      for (const double part : {0.01, 0.3, 1.0}) {
        check(pressure(one, true, part * half_length), pressure(two, true, part * half_length), middle);
        check(pressure(one, false, part * half_length), pressure(two, false, part * half_length), middle);
      }
    }
  }
}

TEST_CASE("complex rates: a pair acts as its own limit, two equal real rates") {
  const auto with = [](std::complex<double> split) {
    const std::complex<double> rate = 2.0 + split;
    const std::vector<fast::Memory> pair{{0.5, rate}, {0.5, std::conj(rate)}};
    return carried_load(solve(0.8, RollingEquations({fast::rolling_compliance(pair), 0.25, {}})));
  };
  const double joined =
      carried_load(solve(0.8, RollingEquations({fast::rolling_compliance({{1.0, 2.0}}), 0.25, {}})));
  CHECK(with({0, 1e-7}) == approx(joined, 1e-12));
  const double far = with({0, 0.1}) - joined, near = with({0, 0.05}) - joined;
  CHECK(far / near == doctest::Approx(4).epsilon(1e-2));  // even in the imaginary part
}

TEST_CASE("the peak is the pressure where it is largest, also where both layers reach over the contact") {
  // The positions that are searched for the two layers coincide there.
  const ViscoelasticNip rolled{6, 0.0224399870581,
                               data::standard_linear_solid({.shear_1 = 7.985999e4,
                                                            .shear_2 = 5.681485e3,
                                                            .bulk_1 = 2.267720e5,
                                                            .bulk_2 = 6.959332e5,
                                                            .shear_viscosity = 3.718509e-1,
                                                            .bulk_viscosity = 6.502540}),
                               2.948901427};
  for (const double length : {3e-4, 1e-3, 1e-2}) {
    CAPTURE(length);
    const auto contact = converged_for_length(rolled, length, 1e-12);
    check_covered(contact.peak_pressure(), contact.pressure(contact.peak_pressure_position().value));
  }
}

TEST_CASE("a short memory that softens by thousands loses no digits") {
  constexpr double softer_by = 4095, rate = 0x1p60;
  const RollingEquations soft({fast::rolling_compliance({{softer_by * rate, rate}}), 0.25, {}}),
      at_once({fast::rolling_compliance({}), 0.25, {}});
  const double expected = carried_load(solve(0.8, at_once)) / (1 + softer_by);
  CHECK(carried_load(solve(0.8, soft)) == approx(expected, 1e-14));
}

TEST_CASE("viscoelastic nip: what an endless memory does to all points alike is no rounding of the creep") {
  // While the nip passes, the memory does not fade at any of these rates, so that all of them give the same creep.
  const auto creep = [](double rate) {
    const ViscoelasticNip nip{6, 0.25,
                              data::prony_solid({9.2e-6, {9.2e-7}, {rate}}, {3.1e-6, {1.5e-7}, {rate}}), 1};
    return fast::converged_for_load(nip, 100, 1e-10).creep_ratio();
  };
  const Estimate slow = creep(1e-14);
  for (const double rate : {1e-9, 1e-20, 1e-40}) {
    const Estimate other = creep(rate);
    CHECK(std::fabs(other.value - slow.value) <= other.error + slow.error + rate * std::fabs(slow.value));
  }
}

TEST_CASE("the terms that resolve a memory that swings are integrated as well as the first ones") {
  struct SwingingMemory {
    double half_length;
    std::complex<double> amplitude, rate;
  };
  for (const auto& [half_length, amplitude, rate] :
       {SwingingMemory{0.337857, {-2.88706, 59.8894}, {36.3151, 207.976}},
        SwingingMemory{0.251194, {11.0518, 195.581}, {23.9811, 664.655}}}) {
    CAPTURE(rate.imag());
    const RollingEquations equations(
        {fast::rolling_compliance({{amplitude, rate}, {std::conj(amplitude), std::conj(rate)}}), 0.25, {}});
    const Solution truth = solve(half_length, equations, fast::panels(half_length, equations.resolution(30)));
    for (const double nats : {9.0, 13.0, 17.0, 21.0}) {
      CAPTURE(nats);
      const Solution solution =
          solve(half_length, equations, fast::panels(half_length, equations.resolution(nats)));
      const Estimate load = solution.estimate(solution.load());
      check_covered(load, truth.estimate(truth.load()));
      check_covered(solution.estimate(equations.eccentricity(solution)),
                    truth.estimate(equations.eccentricity(truth)));
      CHECK(load.error < 1e-10 * load.value);
    }
  }
}

TEST_CASE("thin sheet without slip: the shear in the middle is exactly 0, and beside it rounds little") {
  const data::ElasticNip nip{
      257.67271760106087, 0.04019963248356362, {0.06679909559898078, 0.09020804732626768}};
  for (const double accuracy : {1e-8, 1e-10, 1e-13}) {
    const auto contact = converged_for_length(nip, data::Friction::full, 1.3241265709511936, accuracy);
    CHECK(contact.shear(0).value == 0);
    CHECK(contact.shear(0).error == 0);
    check_covered(contact.shear(1e-300), {});
    CHECK(contact.shear(1e-300).error <= 1e-8 * contact.peak_shear().value);
  }
}

TEST_CASE("outside a contact displacements are as sure as they are small, behind a rolling one too") {
  const auto check = [](const auto& solved, const std::vector<double>& places) {
    const auto asked = solved(1e-8), truth = solved(1e-13);
    for (const double y : places) {
      const Estimate found = asked.normal_displacement(y);
      check_covered(found, truth.normal_displacement(y));
      CHECK(found.error <= 1e-4 * std::fabs(found.value) + 1e-14 * asked.indentation().value);
    }
  };
  for (const data::Friction friction : {data::Friction::none, data::Friction::full}) {
    const auto solved = [&](double accuracy) {
      return fast::converged_for_length(data::ElasticNip{100, 1, {1, 0.3}}, friction, 2, accuracy);
    };
    check(solved, {3.0, 4.5, 6.0, 9.0, 20.0});
    CHECK(solved(1e-8).normal_displacement(200).error > 0);
  }
  const data::ViscoelasticNip rolling{100, 1, data::single_relaxation_time_solid(2, 1, 0.25), 1};
  check([&](double accuracy) { return converged_for_length(rolling, 2, accuracy); },
        {-20.0, -9.0, -6.0, -3.0, 3.0, 4.5, 6.0, 9.0, 20.0});
}

TEST_CASE("next to the leading end the strain rounds as the pressure does that makes it at once") {
  const data::ViscoelasticNip nip{15660.851572036743, 1.854786531534046,
                                  data::operator_solid({{34480.27462387085, 1.0},
                                                        {243385.40824890137, 329.2721646130085},
                                                        {0.00040817430831907586, 1.0},
                                                        {0.00536199903308443, 612.7908380031586}}),
                                  0.012102478431188501};
  const auto contact = converged_for_length(nip, 0.008795065559752402, 2.7259528381578472e-11);
  const double y = 0.004396866668230359;
  const Estimate strain = contact.surface_strain(y), pressure = contact.pressure(y);
  // Nearly all of the strain is theta2 times the pressure there.
  CHECK(strain.error / std::fabs(strain.value) > 0.3 * pressure.error / pressure.value);
}
