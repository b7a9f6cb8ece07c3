// The converged viscoelastic nip: its limits, its energy, two discretisations, its error estimates, its work.
#include <boost/math/quadrature/gauss.hpp>

#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/internal/rolling_equations.hpp>

#include "support/softening_sheet.hpp"
#include "support/test.hpp"

using namespace nipref;
using namespace nipref::test;
using data::ElasticNip;
using data::ViscoelasticNip;
using fast::converged_for_length;
using fast::converged_for_load;
using fast::ConvergedNip;
using fast::Estimate;
using fast::Panel;
using fast::RollingEquations;
using fast::Solution;
using fast::Work;

namespace {

/// The same, dimensionless.
RollingEquations equations(double rate) {
  return RollingEquations({fast::rolling_compliance({{rate, rate}}), 0.25, {{rate / 4, rate}}});
}

Solution solve(double half_length, const RollingEquations& equations, const std::vector<Panel>& panels) {
  Work work;
  fast::CountedKernels kernels(fast::Accuracy{}, work);
  return equations.solve(half_length, panels, 1e-16, kernels);
}

Solution solve(double half_length, const RollingEquations& equations) {
  return solve(half_length, equations, fast::panels(half_length, equations.resolution(34)));
}

/// At e from the leading or the trailing end.
double pressure(const Solution& solution, bool trailing, double e) {
  const std::complex<double> g = solution.traction(e);
  return trailing ? g.real() - g.imag() : g.real() + g.imag();
}

double carried_load(const Solution& solution) { return solution.value(solution.load()); }

using Result = std::function<Estimate(const ConvergedNip&)>;

std::vector<Result> results() {
  return {[](const ConvergedNip& contact) { return contact.contact_length(); },
          [](const ConvergedNip& contact) { return contact.indentation(); },
          [](const ConvergedNip& contact) { return contact.peak_pressure(); },
          [](const ConvergedNip& contact) { return contact.rolling_resistance(); },
          [](const ConvergedNip& contact) { return contact.leading_length(); },
          [](const ConvergedNip& contact) { return contact.load(); },
          [](const ConvergedNip& contact) { return contact.leading_displacement(); },
          [](const ConvergedNip& contact) { return contact.trailing_displacement(); },
          [](const ConvergedNip& contact) { return contact.creep_ratio(); },
          [](const ConvergedNip& contact) { return contact.pressure(0); },
          // Behind the contact.
          [](const ConvergedNip& contact) { return contact.normal_displacement(-0.07); },
          [](const ConvergedNip& contact) { return contact.tangential_displacement(-0.09); }};
}

}  // namespace

TEST_CASE("without relaxation the viscoelastic nip is the elastic one") {
  const ViscoelasticNip rolling{radius, thickness, {{4 / (3 * bulk), {}}, {4 / (9 * bulk), {}}}, 1};
  const auto contact = converged_for_load(rolling, load, 1e-12);
  const auto expected = fast::converged_for_load(elastic(1), data::Friction::none, load, 1e-12);
  const auto check = [](const Estimate& found, const Estimate& truth) {
    CHECK(found.value == approx(truth.value, 3e-12));
  };
  check(contact.contact_length(), expected.contact_length());
  check(contact.indentation(), expected.indentation());
  check(contact.leading_displacement(), expected.leading_displacement());
  check(contact.trailing_displacement(), expected.leading_displacement());
  check(contact.peak_pressure(), expected.peak_pressure());
  check(contact.creep_ratio(), expected.creep_ratio());
  check(contact.pressure(0.02), expected.pressure(0.02));
  check(contact.pressure(-0.03), expected.pressure(0.03));
  check(contact.normal_displacement(-0.2), expected.normal_displacement(0.2));
  check(contact.tangential_displacement(-0.2), {-expected.tangential_displacement(0.2).value, 0});
  CHECK(std::fabs(contact.rolling_resistance().value) < 1e-13 * thickness / radius);
}

TEST_CASE("fast and slow relaxation give the two elastic contacts, with errors of known order") {
  const auto difference = [](double relaxation_length, double compliance, const auto& rolling_result,
                             const auto& elastic_result) {
    const double truth =
        elastic_result(fast::converged_for_load(elastic(compliance), data::Friction::none, load, 1e-12))
            .value;
    return std::fabs(rolling_result(converged_for_load(nip(relaxation_length), load, 1e-11)).value / truth -
                     1);
  };
  const auto check = [&](double quick_order, const auto& rolling_result, const auto& elastic_result) {
    // The error shrinks as the small number is halved.
    const double slow = difference(1e4, 1, rolling_result, elastic_result);
    CHECK(slow < 1e-4);
    CHECK(slow / difference(2e4, 1, rolling_result, elastic_result) == doctest::Approx(2).epsilon(1e-2));
    const double quick = difference(1e-5, 2, rolling_result, elastic_result);
    CHECK(quick < 1e-3);
    CHECK(quick / difference(5e-6, 2, rolling_result, elastic_result) ==
          doctest::Approx(std::exp2(quick_order)).epsilon(2e-2));
  };
  // The first correction of fast relaxation is odd in Y: the indentation knows the second only.
  check(
      2, [](const ConvergedNip& c) { return c.indentation(); },
      [](const fast::ConvergedNip& c) { return c.indentation(); });
  check(
      1, [](const ConvergedNip& c) { return c.creep_ratio(); },
      [](const fast::ConvergedNip& c) { return c.creep_ratio(); });
}

TEST_CASE("a fluid's contact is what those of slow rates tend to, by as much as the rate, also far behind") {
  const auto rolled = [](double rate) -> ViscoelasticNip {
    return {radius, thickness, {{1e-5, {{8e-5, rate}}}, {4e-6, {{1e-5, rate}}}}, 1};
  };
  const double length = 0.1;
  const auto fluid = converged_for_length(rolled(0), length, 1e-12);
  const auto check = [&](const char* name, double size, const Result& result) {
    CAPTURE(name);
    const Estimate limit = result(fluid);
    CHECK(limit.error <= 1e-10 * size);
    const auto short_by = [&](double rate) {
      return result(converged_for_length(rolled(rate), length, 1e-12)).value - limit.value;
    };
    const double slow = short_by(1e-4);
    CHECK(std::fabs(slow) < 1e-3 * size);
    CHECK(std::fabs(slow) > 1e-9 * size);
    CHECK(slow / short_by(5e-5) == doctest::Approx(2).epsilon(1e-2));
    CHECK(std::fabs(short_by(1e-12)) <= 1e-11 * size + 2 * limit.error);
  };
  const double displacement = length * length / radius, strain = length / radius;
  check("load", fluid.load().value, [](const auto& c) { return c.load(); });
  check("indentation", displacement, [](const auto& c) { return c.indentation(); });
  check("resistance", strain, [](const auto& c) { return c.rolling_resistance(); });
  check("creep", strain, [](const auto& c) { return c.creep_ratio(); });
  check("peak", fluid.peak_pressure().value, [](const auto& c) { return c.peak_pressure(); });
  check("u behind", displacement, [](const auto& c) { return c.normal_displacement(-1); });
  check("v behind", displacement, [](const auto& c) { return c.tangential_displacement(-1); });
  check("strain behind", strain, [](const auto& c) { return c.surface_strain(-1); });
  // Behind the sheet keeps its displacement and its strain, so that v grows for ever; a dashpot forgets no force.
  CHECK(fluid.normal_displacement(-1e6).value ==
        doctest::Approx(fluid.normal_displacement(-5).value).epsilon(1e-12));
  CHECK(fluid.surface_strain(-1e6).value == doctest::Approx(fluid.surface_strain(-5).value).epsilon(1e-12));
  CHECK(fluid.tangential_displacement(-1e6).value ==
        doctest::Approx(-1e6 * fluid.surface_strain(-5).value).epsilon(1e-5));
  // I1 integrates to pi/2, half-thicknesses.
  CHECK(fluid.normal_displacement(-5).value ==
        doctest::Approx(9e-5 * fluid.load().value * thickness / 4).epsilon(1e-11));
}

TEST_CASE("towards both elastic limits the pressure becomes its own mirror image") {
  for (const double relaxation_length : {1e5, 1e-5}) {
    CAPTURE(relaxation_length);
    const auto asymmetry = [](double length) {
      const auto contact = converged_for_load(nip(length), load, 1e-11);
      return contact.pressure(0.03).value / contact.pressure(-0.03).value - 1;
    };
    const double here = asymmetry(relaxation_length);
    const double nearer = asymmetry(relaxation_length > 1 ? 10 * relaxation_length : relaxation_length / 10);
    CHECK(here > 0);  // more pressure where the material enters
    CHECK(here < 1e-3);
    CHECK(here / nearer == doctest::Approx(10).epsilon(2e-2));
  }
}

TEST_CASE("two discretisations agree") {
  for (const double half_length : {1e-4, 0.4, 2.0, 15.0}) {
    for (const double rate_length : {0.01, 1.0, 30.0}) {  // A over the relaxation length
      CAPTURE(half_length);
      CAPTURE(rate_length);
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

namespace {

/// int_0^inf |p^(x)|^2 x Im theta(x) G(x) dx/(2 pi), with theta(x) = 1 + sum g/(rate - i x) and G = 2 sinh^2
/// x/(x (sinh 2x + 2x)) the transform of I1: by Parseval the work that the pressure does on the passing
/// surface, which goes into loss.
double dissipation(const Solution& contact, const std::vector<fast::Memory>& normal) {
  // The pressure at nodes that crowd towards both ends.
  std::vector<double> y, weight;
  const auto& gauss = boost::math::quadrature::gauss<double, 60>{};
  constexpr int parts = 24;  // each holds fewer radians of the last waves than it has nodes
  const double half_length = contact.half_length();
  for (const bool trailing : {false, true}) {
    for (int part = 0; part < parts; ++part) {
      for (std::size_t i = 0; i < gauss.abscissa().size(); ++i) {
        for (const double side : {-1, 1}) {
          const double root = (part + 0.5 + side * gauss.abscissa()[i] / 2) / parts,
                       e = half_length * root * root;
          y.push_back(trailing ? e - half_length : half_length - e);
          weight.push_back(gauss.weights()[i] / (2 * parts) * 2 * root * half_length *
                           pressure(contact, trailing, e));
        }
      }
    }
  }
  const auto integrand = [&](double x) {
    std::complex<double> transform = 0;
    for (std::size_t i = 0; i < y.size(); ++i) transform += weight[i] * std::polar(1.0, -x * y[i]);
    double loss = 0;
    for (const auto& term : normal) loss += (term.amplitude / (term.rate - std::complex(0.0, x))).imag();
    const double e2 = std::exp(-2 * x), e4 = e2 * e2;
    const double kernel = std::pow(-std::expm1(-2 * x), 2) / (1 - e4 + 4 * x * e2);  // x G
    return std::norm(transform) * loss * kernel;
  };
  // At most half a period of the transform at a time, and less where kernel and loss vary. Beyond the end,
  // far beyond the rate, the mean over a period falls like x^-4.
  const double rate = std::abs(normal.front().rate);
  const double half_period = std::numbers::pi / (2 * half_length);
  const double end = std::max(500 * half_period, 40 * rate);
  const auto over = [&](double from, double step) {
    return boost::math::quadrature::gauss<double, 7>::integrate(integrand, from, from + step);
  };
  double sum = 0, x = 0;
  while (x < end) {
    const double step = std::min(half_period, std::min(0.5, rate) + x / 4);
    sum += over(x, step);
    x += step;
  }
  const double mean = (over(x - 2 * half_period, half_period) + over(x - half_period, half_period)) / 2;
  return (sum + mean / half_period * x / 3) / (2 * std::numbers::pi);
}

}  // namespace

TEST_CASE("rolling resistance times speed is the energy lost, computed in frequency space") {
  for (const auto& [half_length, rate] : {std::pair(0.4, 1.0), std::pair(3.0, 2.0), std::pair(0.4, 1e-6),
                                          std::pair(0.4, 1e-3), std::pair(0.4, 100.0)}) {
    CAPTURE(half_length);
    CAPTURE(rate);
    const RollingEquations equations = ::equations(rate);
    const Solution contact = solve(half_length, equations);
    const double resistance = carried_load(contact) * contact.value(equations.eccentricity(contact));
    CHECK(dissipation(contact, {{rate, rate}}) == approx(resistance, 1e-8));
  }
}

TEST_CASE("results at 1e-8 over twelve decades of the relaxation length") {
  for (const double relaxation : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0, 1e3, 1e6}) {
    CAPTURE(relaxation);
    const double length = 0.1;
    const auto rough = converged_for_length(nip(relaxation * length), length, 1e-8);
    const auto fine = converged_for_length(nip(relaxation * length), length, 1e-11);
    CHECK(rough.work().unknowns <= fine.work().unknowns);  // one level may serve both
    for (const Result& result : {results()[1], results()[2], results()[3], results()[5]}) {
      CHECK(result(rough).value == approx(result(fine).value, 1e-8));
    }
  }
}

TEST_CASE("the error estimates cover the errors and are not idle") {
  for (const double relaxation_length : {3.0, 0.1, 0.004}) {
    const auto best = converged_for_load(nip(relaxation_length), load, 1e-13);
    for (const double accuracy : {1e-3, 1e-5, 1e-7, 1e-9}) {
      const auto contact = converged_for_load(nip(relaxation_length), load, accuracy);
      int index = 0;
      for (const Result& result : results()) {
        CAPTURE(relaxation_length);
        CAPTURE(accuracy);
        CAPTURE(index);
        ++index;
        const Estimate found = result(contact), truth = result(best);
        CHECK(std::fabs(found.value - truth.value) <= found.error + truth.error);
        CHECK(found.error <= 100 * accuracy * std::max(std::fabs(truth.value), 1e-2 * load));
      }
      for (const Result& result : {results()[0], results()[1], results()[2], results()[3]}) {
        const Estimate found = result(contact), truth = result(best);
        CHECK(std::fabs(found.value - truth.value) <= accuracy * std::fabs(truth.value));
      }
    }
  }
}

TEST_CASE("asking for less costs less") {
  const auto cost = [](double accuracy) { return converged_for_load(nip(0.1), load, accuracy).work(); };
  const Work little = cost(1e-4), much = cost(1e-11);
  CHECK(little.unknowns < much.unknowns);
  CHECK(little.kernel_evaluations[0] < much.kernel_evaluations[0]);
  CHECK(much.kernel_evaluations[2] == 0);  // no tangential kernel before the creep is asked for
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
  // The layers' places coincide there.
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
    const Estimate peak = contact.peak_pressure(),
                   there = contact.pressure(contact.peak_pressure_position().value);
    CHECK(std::fabs(peak.value - there.value) <= peak.error + there.error);
  }
}

TEST_CASE("a short memory that softens by thousands loses no digits") {
  constexpr double softer_by = 4095, rate = 0x1p60;
  const RollingEquations soft({fast::rolling_compliance({{softer_by * rate, rate}}), 0.25, {}}),
      at_once({fast::rolling_compliance({}), 0.25, {}});
  const double expected = carried_load(solve(0.8, at_once)) / (1 + softer_by);
  CHECK(carried_load(solve(0.8, soft)) == approx(expected, 1e-14));
}

TEST_CASE("viscoelastic nips refuse what is outside their domain") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto rolling = nip(0.1);
  CHECK_THROWS_AS(converged_for_load(rolling, 0, 1e-6), data::BadInput);
  CHECK_THROWS_AS(converged_for_load(rolling, nan, 1e-6), data::BadInput);
  CHECK_THROWS_AS(converged_for_load(rolling, 1e9, 1e-6), data::BadInput);  // L > R
  CHECK_THROWS_AS(converged_for_length(rolling, 7, 1e-6), data::BadInput);
  CHECK_THROWS_AS(converged_for_length(rolling, 0.1, 1e-14), data::BadInput);
  CHECK_THROWS_AS((void)converged_for_length(rolling, 0.1, 1e-6).pressure(nan), data::BadInput);
  auto standing = rolling;
  standing.speed = 0;
  CHECK_THROWS_AS(converged_for_length(standing, 0.1, 1e-6), data::BadInput);
}

TEST_CASE(
    "viscoelastic nip: what a memory without end does to all points alike is no rounding of the creep") {
  // It creeps by 1e-5 of itself while the nip passes, so that of rates below that one is as good as another.
  const auto creep = [](double rate) {
    const ViscoelasticNip nip{6, 0.25,
                              data::prony_solid({9.2e-6, {9.2e-7}, {rate}}, {3.1e-6, {1.5e-7}, {rate}}), 1};
    return converged_for_load(nip, 100, 1e-10).creep_ratio();
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
      const auto agrees = [](const fast::Estimate& found, const fast::Estimate& other) {
        CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
      };
      const fast::Estimate load = solution.estimate(solution.load());
      agrees(load, truth.estimate(truth.load()));
      agrees(solution.estimate(equations.eccentricity(solution)),
             truth.estimate(equations.eccentricity(truth)));
      CHECK(load.error < 1e-10 * load.value);
    }
  }
}
