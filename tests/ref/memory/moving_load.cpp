#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/ref/memory/moving_load.hpp>
#include <nipref/ref/sheet/displacements.hpp>
#include <nipref/ref/sheet/internal/plain_terms.hpp>
#include <nipref/ref/sheet/kernels.hpp>

#include "support/decimal.hpp"
#include "support/test.hpp"

// The reference path takes the memory of the sheet from the symbols of the kernels. Here it is the integral over
// the past itself, by quadrature over the elastic kernels in real space, and what is known of its limits.

using namespace nipref::ref;
using nipref::data::BadInput;
using nipref::test::exact;

namespace {

using Float45 = nipref::test::Decimal<45>;

constexpr int digits = 32;

Float45 number(const Enclosure& x) { return Float45(x.value_text()); }

using KernelFunction = std::function<Float45(const Float45&)>;

Float45 kernel_1(const Float45& w) { return number(I1(exact(w), 36)); }
Float45 kernel_2(const Float45& w) {
  const Float45 half_pi = boost::math::constants::half_pi<Float45>();
  return w > 0 ? half_pi : Float45(-half_pi);
}
Float45 kernel_3(const Float45& w) { return number(I3(exact(w), 36)); }
Float45 kernel_4(const Float45& w) { return number(I4(exact(w), 36)); }
Float45 kernel_5(const Float45& w) { return number(I5(exact(w), 36)); }

Float45 real(const mpq_class& x) { return Float45(x.get_num().get_str()) / Float45(x.get_den().get_str()); }

/// The function of time of (c + b p)/(d + 2 rho p + p^2), c + b p being the numerator.
Float45 oscillating_part(const ExactRatio& fraction, const Float45& since) {
  const Float45 rho = real(fraction.denominator[1]) / 2, square = rho * rho - real(fraction.denominator[0]);
  const Float45 b = real(fraction.numerator[1]), c = real(fraction.numerator[0]) - b * rho;
  const Float45 width = sqrt(abs(square)), x = width * since;
  return exp(-rho * since) *
         (square < 0 ? b * cos(x) + c / width * sin(x) : b * cosh(x) + c / width * sinh(x));
}

/// What of theta comes after the beginning, at once for all rates: the kernels are what takes time.
Float45 fading(const ExactFunction& theta, const Float45& since) {
  Float45 sum = 0;
  for (const ExactRatio& fraction : theta.fractions) sum += oscillating_part(fraction, since);
  for (const ExactFunction::Term& term : theta.terms)
    sum += real(term.amplitude) * exp(-real(term.rate) * since);
  return sum;
}

/// int_from^to fading(w - from) I(w) dw in pieces that end at 0, where I1 and I2 are singular.
Float45 memory_integral(const ExactFunction& theta, const KernelFunction& kernel, const Float45& from,
                        const Float45& to) {
  static boost::math::quadrature::tanh_sinh<Float45> rule(9);
  const Float45 nothing("1e-80");
  const Float45 zero = 0;
  const auto piece = [&](const Float45& a, const Float45& b) -> Float45 {
    if (!(b > a)) return 0;
    // Measured from the end nearer to 0, so that the distance to the singularity is exact.
    const bool backwards = b <= 0;
    const Float45 origin = backwards ? b : a;
    const auto integrand = [&](const Float45& v) -> Float45 {
      if (v < nothing) return 0;
      const Float45 w = backwards ? Float45(origin - v) : Float45(origin + v);
      return fading(theta, w - from) * kernel(w);
    };
    return rule.integrate(integrand, zero, Float45(b - a), Float45("1e-34"));
  };
  Float45 sum = piece(from, std::min(to, zero));
  // Short pieces near the start, where the memory is fresh.
  Float45 left = std::max(from, zero);
  for (Float45 length = 2; left < to; length *= 2) {
    const Float45 right = std::min(to, Float45(left + length));
    sum += piece(left, right);
    left = right;
  }
  return sum;
}

Float45 convolution(const ExactFunction& theta, const KernelFunction& kernel, const Float45& from,
                    const Float45& to) {
  return real(theta.instantaneous) * kernel(from) + memory_integral(theta, kernel, from, to);
}

void check_agrees(const Enclosure& reference, const Float45& other) {
  const Float45 tolerance("1e-30");
  CHECK(abs(number(reference) - other) <= tolerance * abs(other));
}

/// A solid with two relaxation times of its own in theta1, another one in theta2; speed and half thickness 1.
ExactMaterial two_times() {
  return {{mpq_class(1), {{mpq_class(3, 2), mpq_class(4)}, {mpq_class(1, 4), mpq_class(1, 2)}}, {}},
          {mpq_class(1, 3), {{mpq_class(1, 5), mpq_class(7)}}, {}}};
}

/// A solid whose memory oscillates four times as fast as it decays in theta1 and has two real rates in theta2, and
/// which flows.
ExactMaterial oscillating_solid() {
  return {
      {mpq_class(1),
       {{mpq_class(1, 8), mpq_class(0)}},
       {{{mpq_class(9), mpq_class(2)}, {mpq_class(17), mpq_class(2), mpq_class(1)}}}},
      {mpq_class(1, 3), {}, {{{mpq_class(1), mpq_class(1)}, {mpq_class(2), mpq_class(4), mpq_class(1)}}}}};
}

const Exact one(1.0);

void check_Un(const std::string& t, const std::string& T, const ExactMaterial& solid = two_times()) {
  CAPTURE(t);
  CAPTURE(T);
  const Float45 from = Float45(T) - Float45(t);
  check_agrees(
      moving_load_normal_displacement(exact(t), exact(T), one, one, solid, digits),
      convolution(solid.normal(), kernel_1, from, Float45(T)) / boost::math::constants::pi<Float45>());
}

void check_Vn(const std::string& t, const std::string& T, const std::string& t0,
              const ExactMaterial& solid = two_times()) {
  CAPTURE(t);
  CAPTURE(T);
  CAPTURE(t0);
  const Float45 alpha = Float45(T) - Float45(t);
  const Float45 eta = Float45(t0) - Float45(t);
  const Float45 sum = convolution(solid.normal(), kernel_3, alpha, Float45(T)) -
                      convolution(solid.theta2, kernel_2, alpha, Float45(T)) +
                      convolution(solid.theta2, kernel_4, eta, Float45(t0)) -
                      convolution(solid.theta1, kernel_5, eta, Float45(t0));
  check_agrees(moving_load_tangential_displacement(exact(t), exact(T), exact(t0), one, one, solid, digits),
               sum / boost::math::constants::pi<Float45>());
}

double relative_difference(const Enclosure& x, const Enclosure& y) {
  return static_cast<double>(abs(number(x) / number(y) - 1));
}

}  // namespace

TEST_CASE("moving load: Un is the memory integral over the elastic kernel, in all cases of T") {
  check_Un("1.5", "2.25");
  check_Un("1.5", "0.5");
  check_Un("1.5", "-0.75");
  check_Un("2", "0");
  check_Un("0.125", "0.126");
  check_Un("6", "3");
}

TEST_CASE("moving load: Vn is the memory integral over the elastic kernels, in all four cases") {
  check_Vn("1.5", "2.25", "1");
  check_Vn("1.5", "0.5", "-0.5");
  check_Vn("1.5", "-0.75", "0.25");
  check_Vn("1.5", "-0.75", "-2");
}

TEST_CASE(
    "moving load: a memory that oscillates is the memory integral too, and so is one whose roots are irrational") {
  check_Un("1.5", "2.25", oscillating_solid());
  check_Un("1.5", "0.5", oscillating_solid());
  check_Un("6", "3", oscillating_solid());
  check_Vn("1.5", "0.5", "-0.5", oscillating_solid());
  check_Vn("0.125", "0.126", "4", oscillating_solid());
}

TEST_CASE("moving load: operators are the solids that their roots make") {
  const auto list = [](const std::vector<std::string>& texts) {
    std::vector<Exact> numbers;
    for (const std::string& text : texts) numbers.push_back(exact(text));
    return numbers;
  };
  // G = 3/8 (1 + p)/(2 + p), K = (1 + p)/(2 + p): the thesis's solid; and with a factor 3 + p on both sides of G.
  const ExactMaterial solid = exact_solid(Solid::standard_linear_solid, one, one);
  for (const ExactMaterial& other :
       {exact_material(
            exact_operators(list({"2", "1"}), list({"0.375", "0.375"}), list({"2", "1"}), list({"1", "1"}))),
        exact_material(exact_operators(list({"6", "5", "1"}), list({"1.125", "1.5", "0.375"}),
                                       list({"2", "1"}), list({"1", "1"})))}) {
    CHECK(other.theta1.fractions.empty());
    CHECK(other.theta1.terms[0].rate == solid.theta1.terms[0].rate);
    CHECK(other.theta1.terms[0].amplitude == solid.theta1.terms[0].amplitude);
    CHECK(other.theta2.instantaneous == solid.theta2.instantaneous);
  }
  // Kelvin and Voigt's G = 1 + p, Maxwell's K = p/(1 + p).
  const ExactMaterial mixed =
      exact_material(exact_operators(list({"1"}), list({"1", "1"}), list({"1", "1"}), list({"0", "1"})));
  CHECK(mixed.theta1.instantaneous == 0);
  CHECK(mixed.theta2.instantaneous == 0);
  const auto refused = [&](const std::vector<std::string>& q) {
    CHECK_THROWS_AS(exact_material(exact_operators(list({"2", "1"}), list(q), list({"1"}), list({"1"}))),
                    BadInput);
  };
  refused({"1", "2", "1"});
  refused({"0", "0", "1"});
}

TEST_CASE("moving load: with operators what would take long is refused") {
  const ExactMaterial solid = oscillating_solid();
  CHECK_NOTHROW(moving_load_steady_normal_displacement(exact("-150"), one, one, solid, 16));
  CHECK_THROWS_AS(moving_load_steady_normal_displacement(exact("251"), one, one, solid, 16), BadInput);
  CHECK_THROWS_AS(moving_load_normal_displacement(exact("150"), exact("-101"), one, one, solid, 16),
                  BadInput);
  CHECK_THROWS_AS(moving_load_steady_normal_displacement(one, exact("1e-101"), one, solid, 16), BadInput);
}

TEST_CASE("moving load: steady Un is the memory integral of a load that came from far away") {
  const ExactMaterial solid = two_times();
  for (const std::string alpha : {"0.5", "-1.25", "1e-6"}) {
    CAPTURE(alpha);
    // Beyond w = 40 the kernel is below e^{-84}.
    check_agrees(moving_load_steady_normal_displacement(exact(alpha), one, one, solid, digits),
                 convolution(solid.normal(), kernel_1, Float45(alpha), Float45(40)) /
                     boost::math::constants::pi<Float45>());
  }
}

TEST_CASE("moving load: the displacements do not jump where the cases meet") {
  const ExactMaterial solid = two_times();
  const auto U = [&](const char* t, const char* T) {
    return moving_load_normal_displacement(exact(t), exact(T), one, one, solid, 25);
  };
  CHECK(relative_difference(U("1.5", "1e-20"), U("1.5", "-1e-20")) < 1e-17);
  const auto V = [&](const char* T, const char* t0) {
    return moving_load_tangential_displacement(exact("1.5"), exact(T), exact(t0), one, one, solid, 25);
  };
  CHECK(relative_difference(V("1e-20", "0.4"), V("-1e-20", "0.4")) < 1e-18);
  CHECK(relative_difference(V("0.4", "1e-20"), V("0.4", "-1e-20")) < 1e-18);
  const char* near_now = "1.50000000000000000001";
  CHECK(relative_difference(V("0.4", near_now), V("0.4", "1.5")) < 1e-17);
  // At T = t the jump is that of theta2's step, and the value is the mean.
  const Float45 mean = (number(V(near_now, "0.4")) + number(V("1.49999999999999999999", "0.4"))) / 2;
  CHECK(abs(mean / number(V("1.5", "0.4")) - 1) < Float45("1e-17"));
}

TEST_CASE("moving load: what happened long ago is forgotten") {
  const ExactMaterial solid = two_times();
  // The slowest rate is 1/2: e^{-50} is 2e-22.
  const Enclosure steady = moving_load_steady_normal_displacement(exact("-0.75"), one, one, solid, 25);
  CHECK(relative_difference(
            moving_load_normal_displacement(exact("100"), exact("99.25"), one, one, solid, 25), steady) <
        1e-19);
  const Enclosure steady_shear =
      moving_load_steady_tangential_displacement(exact("-0.75"), exact("1.5"), one, one, solid, 25);
  CHECK(relative_difference(moving_load_tangential_displacement(exact("100"), exact("99.25"), exact("101.5"),
                                                                one, one, solid, 25),
                            steady_shear) < 1e-19);
}

TEST_CASE("moving load: at first the sheet answers at once, gamma_0 alone") {
  const ExactMaterial solid = two_times();
  const Float45 pi = boost::math::constants::pi<Float45>();
  check_agrees(moving_load_normal_displacement(exact("0"), exact("0.75"), one, one, solid, digits),
               Float45(4) / 3 * kernel_1(Float45("0.75")) / pi);
  // Young 4/3 and Poisson 1/3 have theta1 = 1, theta2 = 1/3; their rounding to double is seen.
  const double elastic = vn(exact("0.75"), exact("0.5"), Exact(4.0 / 3), Exact(1.0 / 3), 25).to_double();
  CHECK(moving_load_tangential_displacement(exact("0"), exact("0.75"), exact("0.5"), one, one, solid, 25)
            .to_double() == doctest::Approx(elastic).epsilon(1e-14));
  // The memory grows in proportion to the time.
  const Float45 start =
      number(moving_load_normal_displacement(exact("0"), exact("0.75"), one, one, solid, digits));
  const auto growth = [&](const char* t) -> Float45 {
    return (number(moving_load_normal_displacement(exact(t), exact("0.75"), one, one, solid, digits)) -
            start) /
           Float45(t);
  };
  CHECK(static_cast<double>(abs(growth("1e-10") / growth("2e-10") - 1)) < 1e-9);
}

TEST_CASE("moving load: slow and fast motion are the soft and the stiff elastic sheet, to first order") {
  const auto deviation = [](const char* tau, double stiffness) {
    const ExactMaterial solid = exact_solid(Solid::standard_linear_solid, exact("1"), exact(tau));
    const Float45 value = number(moving_load_steady_normal_displacement(exact("0.5"), one, one, solid, 25));
    const Float45 elastic =
        Float45(stiffness) * 16 / 9 * kernel_1(Float45("0.5")) / boost::math::constants::pi<Float45>();
    return static_cast<double>(value / elastic - 1);
  };
  CHECK(std::abs(deviation("1e-6", 2)) < 1e-5);
  CHECK(deviation("1e-6", 2) / deviation("1e-5", 2) == doctest::Approx(0.1).epsilon(1e-3));
  CHECK(std::abs(deviation("1e6", 1)) < 1e-5);
  CHECK(deviation("1e6", 1) / deviation("1e5", 1) == doctest::Approx(0.1).epsilon(1e-3));
}

TEST_CASE("moving load: only speed tau/half thickness counts, and bulk scales") {
  const ExactMaterial solid = exact_solid(Solid::thesis, exact("2"), exact("0.5"));
  const ExactMaterial other = exact_solid(Solid::thesis, exact("1"), exact("1"));
  const Enclosure x =
      moving_load_normal_displacement(exact("3"), exact("2"), exact("6"), exact("4"), solid, 25);
  const Enclosure y =
      moving_load_normal_displacement(exact("6"), exact("4"), exact("3"), exact("4"), other, 25);
  CHECK(abs(2 * number(x) / number(y) - 1) < Float45("1e-24"));
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
  // The same from doubles.
  const ExactMaterial rounded = exact_material(
      nipref::data::misprinted_thesis_solid(3, 3 * nipref::data::thesis_shear_over_bulk, 0.25));
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
  // More digits mean another step and other nodes: nothing of the quadrature's error is shared.
  for (const std::string tau : {"1e-6", "0.3", "1e6"}) {
    const ExactMaterial solid = exact_solid(Solid::thesis, exact("1"), exact(tau));
    for (const std::string alpha : {"-900", "-30", "-0.01", "1e-9", "2.5", "30", "900"}) {
      CAPTURE(tau);
      CAPTURE(alpha);
      const auto difference = [&](auto value) {
        const Enclosure few = value(16), many = value(24);
        Float error = zero_of_bits(64), allowed = zero_of_bits(64);
        mpfr_sub(raw(error), raw(few.value), raw(many.value), MPFR_RNDA);
        // Far from the load a value may have far more digits than were asked for, and fewer when more were.
        mpfr_add(raw(allowed), raw(few.error), raw(many.error), MPFR_RNDU);
        CHECK(mpfr_cmpabs(raw(error), raw(allowed)) <= 0);
      };
      difference(
          [&](int n) { return moving_load_steady_normal_displacement(exact(alpha), one, one, solid, n); });
      difference([&](int n) {
        return moving_load_steady_tangential_displacement(exact(alpha), exact("0.7"), one, one, solid, n);
      });
      difference([&](int n) {
        return moving_load_normal_displacement(exact("4"), exact(Float45(alpha) + 4), one, one, solid, n);
      });
      difference([&](int n) {
        return moving_load_tangential_displacement(exact("4"), exact(Float45(alpha) + 4), exact("-3"), one,
                                                   one, solid, n);
      });
    }
  }
}

// What lies before the start has faded by e^-1000: to work it out to as many digits takes a minute.
TEST_CASE("moving load: a start that has faded is worked out to the digits that are left of it") {
  const ExactMaterial solid = exact_solid(Solid::standard_linear_solid, one, one);
  const auto value = [&](const char* T) {
    return moving_load_normal_displacement(exact("1000"), exact(T), exact("0.5"), one, solid, 40);
  };
  const Enclosure here = value("5e-324"), at_start = value("0");
  Float difference = zero_of_bits(64), allowed = zero_of_bits(64);
  mpfr_sub(raw(difference), raw(here.value), raw(at_start.value), MPFR_RNDA);
  mpfr_add(raw(allowed), raw(here.error), raw(at_start.error), MPFR_RNDU);
  CHECK(mpfr_cmpabs(raw(difference), raw(allowed)) <= 0);
  mpfr_div(raw(allowed), raw(allowed), raw(here.value), MPFR_RNDA);
  CHECK(std::fabs(mpfr_get_d(raw(allowed), MPFR_RNDA)) < 2e-40);
}

TEST_CASE("moving load: bad arguments are refused") {
  const ExactMaterial solid = two_times();
  CHECK_THROWS_AS(moving_load_normal_displacement(exact("-1"), one, one, one, solid, 20), BadInput);
  CHECK_THROWS_AS(moving_load_normal_displacement(one, one, one, one, solid, 20), BadInput);
  CHECK_THROWS_AS(moving_load_normal_displacement(one, exact("2000"), one, one, solid, 20), BadInput);
  CHECK_THROWS_AS(moving_load_normal_displacement(one, exact("2"), exact("0"), one, solid, 20), BadInput);
  CHECK_THROWS_AS(moving_load_normal_displacement(one, exact("2"), one, exact("-1"), solid, 20), BadInput);
  CHECK_THROWS_AS(moving_load_normal_displacement(one, exact("2"), one, one, solid, 10), BadInput);
  CHECK_THROWS_AS(moving_load_steady_normal_displacement(exact("0"), one, one, solid, 20), BadInput);
  CHECK_THROWS_AS(moving_load_steady_tangential_displacement(exact("2000"), one, one, one, solid, 20),
                  BadInput);
  CHECK_THROWS_AS(exact_solid(Solid::thesis, exact("0"), one), BadInput);
  CHECK_THROWS_AS(exact_solid(Solid::thesis, one, exact("-1")), BadInput);
  ExactMaterial growing = solid;
  growing.theta1.terms[0].rate = -1;
  CHECK_THROWS_AS(moving_load_steady_normal_displacement(one, one, one, growing, 20), BadInput);
}

TEST_CASE("moving load: what a displacement changes by is bounded, and not loosely") {
  std::mt19937_64 random(3);
  const auto rational = [&](double low, double high) {
    return Exact(std::exp(std::uniform_real_distribution(std::log(low), std::log(high))(random))).value();
  };
  const auto sign = [&] { return std::uniform_int_distribution(0, 1)(random) == 0 ? -1 : 1; };
  const Exact one(1.0);
  const mpq_class small("1/1000000000");
  double loosest[2][3] = {};
  for (int i = 0; i < 400; ++i) {
    const mpq_class alpha = sign() * rational(0.01, 5), t = rational(0.1, 5),
                    eta = sign() * rational(0.01, 5);
    const int which = i % 3,
              terms = i % 4 == 3 ? i % 50 + 1 : 0;  // what is off: the place, the start, the memory
    const mpq_class amplitude = rational(0.1, 10), rate = rational(1e-2, 30);
    const auto material_with = [&](const mpq_class& share) {
      return ExactMaterial{{1, {{amplitude * (1 + share), rate * (1 - share)}}, {}},
                           {mpq_class(1, 4), {{amplitude / 3, rate * (1 + share) / 2}}, {}}};
    };
    const mpq_class off = std::min(t, mpq_class(abs(alpha))) * small;
    const PathError moved{which == 0 ? off : mpq_class(0), which == 1 ? off : mpq_class(0)};
    const MovingLoadError error{moved, moved, which == 2 ? small : mpq_class(0)};
    const ExactMaterial before = material_with(0), after = material_with(error.memory);
    // t, T and t0 from the distances now and at the start.
    const auto times = [&](const mpq_class& now, const mpq_class& start) {
      return std::pair(Exact(mpq_class(start - now)), Exact(start));
    };
    const auto [time, T] = times(alpha, alpha + t);
    const auto [new_time, new_T] = times(alpha + moved.alpha, alpha + t + moved.start);
    const Exact t0(mpq_class(time.value() + eta)), new_t0(mpq_class(new_time.value() + eta + moved.alpha));
    const auto check = [&](const Enclosure& old_value, const Enclosure& new_value, const Interval& bound,
                           double& loose) {
      Float change = zero_of_bits(200);
      mpfr_sub(raw(change), raw(new_value.value), raw(old_value.value), MPFR_RNDN);
      const double size = std::fabs(mpfr_get_d(raw(change), MPFR_RNDN)), most = mpfi_get_d(bound.get());
      CAPTURE(i);
      CHECK(size <= most);
      loose = std::max(loose, size / most);
    };
    check(moving_load_normal_displacement(time, T, one, one, before, 30, terms),
          moving_load_normal_displacement(new_time, new_T, one, one, after, 30, terms),
          moving_load_normal_change(time, T, one, one, before, error, terms), loosest[0][which]);
    check(moving_load_tangential_displacement(time, T, t0, one, one, before, 30, terms),
          moving_load_tangential_displacement(new_time, new_T, new_t0, one, one, after, 30, terms),
          moving_load_tangential_change(time, T, t0, one, one, before, error, terms), loosest[1][which]);
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
      const auto term = plain_term(n, 64);
      const double size = M_PI * mpfi_get_d(abs(term->coefficient(kernel)).get());
      sum += size;
      slope += size * mpfi_get_d(abs(term->z).get());
      CHECK(sum <= 7 * n + 1);
      CHECK(slope <= 13 * std::pow(n, 1.5));
    }
  }
}
