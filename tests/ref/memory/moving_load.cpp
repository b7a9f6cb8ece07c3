#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/ref/memory/moving_load.hpp>
#include <nipref/ref/sheet/internal/residues.hpp>
#include <nipref/ref/sheet/kernels.hpp>

#include "support/decimal.hpp"
#include "support/reference_values.hpp"
#include "support/test.hpp"

using namespace nipref::ref;
using nipref::data::BadInput;
using nipref::test::exact;
using nipref::test::exacts;

namespace {

/// A solid that flows. In theta1 its memory oscillates four times as fast as it decays; in theta2 it has two real
/// rates.
ExactMaterial oscillating_solid() {
  return {
      {mpq_class(1),
       {{mpq_class(1, 8), mpq_class(0)}},
       {{{mpq_class(9), mpq_class(2)}, {mpq_class(17), mpq_class(2), mpq_class(1)}}}},
      {mpq_class(1, 3), {}, {{{mpq_class(1), mpq_class(1)}, {mpq_class(2), mpq_class(4), mpq_class(1)}}}}};
}

const Exact unit(1.0);

}  // namespace

TEST_CASE("moving load: operators are the solids that their roots make") {
  // G = 3/8 (1 + p)/(2 + p), K = (1 + p)/(2 + p): the thesis's solid, also with a factor 3 + p on both sides of G.
  const ExactMaterial solid = exact_solid(Solid::standard_linear_solid, unit, unit);
  for (const ExactMaterial& other :
       {exact_material(exact_operators(exacts({"2", "1"}), exacts({"0.375", "0.375"}), exacts({"2", "1"}),
                                       exacts({"1", "1"}))),
        exact_material(exact_operators(exacts({"6", "5", "1"}), exacts({"1.125", "1.5", "0.375"}),
                                       exacts({"2", "1"}), exacts({"1", "1"})))}) {
    CHECK(other.theta1.fractions.empty());
    CHECK(other.theta1.terms[0].rate == solid.theta1.terms[0].rate);
    CHECK(other.theta1.terms[0].amplitude == solid.theta1.terms[0].amplitude);
    CHECK(other.theta2.instantaneous == solid.theta2.instantaneous);
  }
  // Kelvin and Voigt's G = 1 + p, Maxwell's K = p/(1 + p).
  const ExactMaterial mixed = exact_material(
      exact_operators(exacts({"1"}), exacts({"1", "1"}), exacts({"1", "1"}), exacts({"0", "1"})));
  CHECK(mixed.theta1.instantaneous == 0);
  CHECK(mixed.theta2.instantaneous == 0);
  for (const auto& q : {exacts({"1", "2", "1"}), exacts({"0", "0", "1"})})
    CHECK_THROWS_AS(exact_material(exact_operators(exacts({"2", "1"}), q, exacts({"1"}), exacts({"1"}))),
                    BadInput);
}

TEST_CASE("moving load: with operators what would take long is refused") {
  const MovingLoad load(oscillating_solid(), unit, unit);
  CHECK_NOTHROW(load.steady_normal_displacement(exact("-150"), 16));
  CHECK_THROWS_AS(load.steady_normal_displacement(exact("251"), 16), BadInput);
  CHECK_THROWS_AS(load.normal_displacement(exact("150"), exact("-101"), 16), BadInput);
  CHECK_THROWS_AS(MovingLoad(oscillating_solid(), exact("1e-101"), unit), BadInput);
}

TEST_CASE("moving load: the two solids differ in the fading of theta2 alone") {
  const ExactMaterial solid = exact_solid(Solid::standard_linear_solid, exact("3"), exact("0.25"));
  const ExactMaterial thesis = exact_solid(Solid::thesis, exact("3"), exact("0.25"));
  CHECK(solid.theta1.instantaneous == mpq_class(4, 9));
  CHECK(solid.theta2.instantaneous == mpq_class(4, 27));
  CHECK(solid.theta1.terms[0].amplitude == mpq_class(16, 9));
  CHECK(solid.theta2.terms[0].rate == 4);
  CHECK(thesis.theta2.terms[0].rate == 8);
  CHECK(thesis.theta2.terms[0].amplitude == solid.theta2.terms[0].amplitude);
  CHECK(solid.normal().terms.size() == 1);
  CHECK(thesis.normal().terms.size() == 2);
  // The thesis's solid from doubles.
  const ExactMaterial rounded = exact_material(nipref::data::single_relaxation_time_solid(
      3, 3 * nipref::data::thesis_shear_over_bulk, 0.25, nipref::data::misprinted_rate_factor));
  CHECK(rounded.theta2.terms[0].rate == thesis.theta2.terms[0].rate);
  CHECK(rounded.theta1.instantaneous.get_d() ==
        doctest::Approx(thesis.theta1.instantaneous.get_d()).epsilon(1e-15));
  CHECK(rounded.theta2.instantaneous.get_d() ==
        doctest::Approx(thesis.theta2.instantaneous.get_d()).epsilon(1e-15));
}

TEST_CASE("moving load: a material in double is taken as it is, complex rates are refused") {
  const nipref::data::ViscoelasticMaterial material{{1.5, {{0.5, 2.0}}}, {0.5, {{0.125, 2.0}}}};
  const ExactMaterial taken = exact_material(material);
  CHECK(taken.theta1.instantaneous == mpq_class(3, 2));
  CHECK(taken.theta2.terms[0].amplitude == mpq_class(1, 8));
  CHECK(taken.normal().terms[0].amplitude == mpq_class(5, 8));
  const nipref::data::ViscoelasticMaterial waves{
      {1.5, {{{0.25, 0}, {2.0, 0.125}}, {{0.25, 0}, {2.0, -0.125}}}},
      {0.5, {{{0.0625, 0}, {2.0, 0.125}}, {{0.0625, 0}, {2.0, -0.125}}}}};
  CHECK_THROWS_AS(exact_material(waves), BadInput);
}

TEST_CASE("moving load: a standard linear solid is as its constants say, to more digits than a double has") {
  // theta1 = 1/2 (1 + 1/(1 + 3 p)) with G1 = G2 = 1 and the viscosity 3: the rate and twice the amplitude are 1/3.
  const ExactMaterial solid = exact_material(nipref::data::standard_linear_solid({1, 1, 5, 7, 3, 11}));
  REQUIRE(solid.theta1.terms.size() == 1);
  CHECK(abs(solid.theta1.terms[0].rate - mpq_class(1, 3)) < 1e-38);
  CHECK(abs(2 * solid.theta1.terms[0].amplitude - mpq_class(1, 3)) < 1e-38);
}

TEST_CASE("moving load: the bounds hold against more digits, whatever the rate and the place") {
  // More digits mean another step and other nodes, so that the two share no quadrature error.
  for (const std::string tau : {"1e-6", "0.3", "1e6"}) {
    const MovingLoad load(exact_solid(Solid::thesis, exact("1"), exact(tau)), unit, unit);
    for (const std::string alpha : {"-900", "-30", "-0.01", "1e-9", "2.5", "30", "900"}) {
      CAPTURE(tau, alpha);
      const Exact passing(mpq_class(exact(alpha).value() + 4));
      const auto check = [&](auto value) {
        const Enclosure few = value(16), many = value(24);
        // Far from the load a value may have far more digits than requested, and fewer for a larger request.
        CHECK(meet(few, many));
      };
      check([&](int n) { return load.steady_normal_displacement(exact(alpha), n); });
      check([&](int n) { return load.steady_tangential_displacement(exact(alpha), exact("0.7"), n); });
      check([&](int n) { return load.normal_displacement(exact("4"), passing, n); });
      check([&](int n) { return load.tangential_displacement(exact("4"), passing, exact("-3"), n); });
    }
  }
}

// The memory of the time before the start has faded to e^-1000. To compute it to full accuracy would take a minute.
TEST_CASE("moving load: a start that has faded is worked out to the digits that are left of it") {
  const MovingLoad load(exact_solid(Solid::standard_linear_solid, unit, unit), exact("0.5"), unit);
  const auto value = [&](const char* T) { return load.normal_displacement(exact("1000"), exact(T), 40); };
  const Enclosure here = value("5e-324"), at_start = value("0");
  CHECK(meet(here, at_start));
  CHECK(static_cast<double>(abs((here.error + at_start.error) / here.value)) < 2e-40);
}

TEST_CASE("moving load: bad arguments are refused") {
  const ExactMaterial solid = exact_solid(Solid::thesis, unit, unit);
  const MovingLoad load(solid, unit, unit);
  CHECK_REFUSED(load.normal_displacement(unit, exact("2000"), 20), "T = 2000");
  CHECK_REFUSED(load.normal_displacement(unit, exact("2"), 10), "digits = 10");
  CHECK_REFUSED(load.steady_tangential_displacement(exact("2000"), unit, 20), "alpha = 2000");
  CHECK_REFUSED(exact_solid(Solid::thesis, exact("0"), unit), "bulk = 0");
  CHECK_REFUSED(exact_solid(Solid::thesis, unit, exact("-1")), "tau = -1");
  ExactMaterial growing = solid;
  growing.theta1.terms[0].rate = -1;
  CHECK_THROWS_AS(MovingLoad(growing, unit, unit), BadInput);
}

TEST_CASE("moving load: what a displacement changes by is bounded, and not loosely") {
  std::mt19937_64 random(3);
  const auto rational = [&](double low, double high) { return Exact(between(low, high, random)).value(); };
  const auto sign = [&] { return std::uniform_int_distribution(0, 1)(random) == 0 ? -1 : 1; };
  const mpq_class small("1/1000000000");
  double loosest[2][3] = {};
  for (int i = 0; i < 132; ++i) {
    const mpq_class alpha = sign() * rational(0.01, 5), t = rational(0.1, 5),
                    eta = sign() * rational(0.01, 5);
    const int which = i % 3,
              terms = i % 4 == 3 ? i % 50 + 1 : 0;  // what is changed: the place, the start, the memory
    const mpq_class amplitude = rational(0.1, 10), rate = rational(1e-2, 30);
    const auto material_with = [&](const mpq_class& share) {
      return ExactMaterial{{1, {{amplitude * (1 + share), rate * (1 - share)}}, {}},
                           {mpq_class(1, 4), {{amplitude / 3, rate * (1 + share) / 2}}, {}}};
    };
    const mpq_class off = std::min(t, mpq_class(abs(alpha))) * small;
    const PathError moved{which == 0 ? off : mpq_class(0), which == 1 ? off : mpq_class(0)};
    const MovingLoadError error{moved, moved, which == 2 ? small : mpq_class(0)};
    const MovingLoad before(material_with(0), unit, unit, terms),
        after(material_with(error.memory), unit, unit, terms);
    // t, T and t0 from the distances now and at the start.
    const auto times = [&](const mpq_class& now, const mpq_class& start) {
      return std::pair(Exact(mpq_class(start - now)), Exact(start));
    };
    const auto [time, T] = times(alpha, alpha + t);
    const auto [new_time, new_T] = times(alpha + moved.alpha, alpha + t + moved.start);
    const Exact t0(mpq_class(time.value() + eta)), new_t0(mpq_class(new_time.value() + eta + moved.alpha));
    const auto check = [&](const Enclosure& old_value, const Enclosure& new_value, const Interval& bound,
                           double& loose) {
      const double size = difference(new_value, old_value), most = mpfi_get_d(bound.get());
      CAPTURE(i);
      CHECK(size <= most);
      loose = std::max(loose, size / most);
    };
    check(before.normal_displacement(time, T, 20), after.normal_displacement(new_time, new_T, 20),
          before.normal_change(time, T, error), loosest[0][which]);
    check(before.tangential_displacement(time, T, t0, 20),
          after.tangential_displacement(new_time, new_T, new_t0, 20),
          before.tangential_change(time, T, t0, error), loosest[1][which]);
  }
  for (const auto& of_kind : loosest)
    for (const double share : of_kind) CHECK(share > 1e-2);
}

TEST_CASE("moving load: the kernels, their slopes and sums of residues are within the bounds of a change") {
  const double step = 1e-3;
  double integral = 0;
  const auto differ = [&](auto kernel, double alpha) {
    return std::fabs(kernel(Exact(alpha + step), 16).to_double() - kernel(Exact(alpha), 16).to_double());
  };
  for (int k = 1; k <= 4000; ++k) {
    const double alpha = 3 * k * step;
    const double value = std::fabs(I1(Exact(alpha), 16).to_double());
    CHECK(value <= 3 + std::max(0.0, -std::log(alpha)));
    CHECK(differ(I1, alpha) <= (2 + 1 / alpha) * step);
    integral += value * 2 * 3 * step;
    for (const auto kernel : {&I3, &I4, &I5}) {
      CHECK(std::fabs(kernel(Exact(alpha), 16).to_double()) <= 4);
      CHECK(differ(kernel, alpha) <= 4 * step);
    }
  }
  CHECK(integral < 8);
  CHECK(integral > 1.4);
  CHECK(2 * 3 + 2 * 7 * 2 / M_PI * std::exp(-M_PI / 2) < 8);
  for (const PlainKernel kernel : {PlainKernel::I1, PlainKernel::I3, PlainKernel::I4, PlainKernel::I5}) {
    double sum = M_PI / 4, slope = 0;
    for (int n = 1; n <= most_residue_terms; ++n) {
      const auto pole = sheet_pole(n, 64);
      const double size = M_PI * mpfi_get_d(abs(plain_coefficient(kernel, *pole)).get());
      sum += size;
      slope += size * mpfi_get_d(abs(pole->z).get());
      CHECK(sum <= 7 * n + 1);
      CHECK(slope <= 13 * std::pow(n, 1.5));
    }
  }
}
