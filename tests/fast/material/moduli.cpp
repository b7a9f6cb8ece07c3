#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/fast/material/functions.hpp>
#include <nipref/fast/material/moduli.hpp>

#include "support/test.hpp"

using namespace nipref;
using data::SpringModel;
using fast::Modulus;

namespace {

constexpr Modulus moduli[] = {{SpringModel::elastic, 2, 0, 0},
                              {SpringModel::standard_linear, 2, 3, 5},
                              {SpringModel::standard_linear, 2e3, 3e-2, 50},
                              {SpringModel::maxwell, 2, 0, 5}};

double integral(const std::function<double(double)>& f, double to) {
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(f, 0.0, to, 12, 1e-13);
}

}  // namespace

TEST_CASE("relaxation and creep undo each other: their convolution is t") {
  for (const Modulus& modulus : moduli) {
    for (const double t : {0.1, 2.0, 30.0}) {
      const double both = integral(
          [&](double s) { return fast::relaxation(modulus, t - s).value * fast::creep(modulus, s); }, t);
      CHECK(both == doctest::Approx(t).epsilon(1e-11));
    }
  }
  // A dashpot beside the spring answers a step with an impulse of its viscosity besides.
  const Modulus kelvin{SpringModel::kelvin_voigt, 2, 0, 5};
  for (const double t : {0.1, 2.0, 30.0}) {
    const double springs =
        integral([&](double s) { return fast::relaxation(kelvin, t - s).value * fast::creep(kelvin, s); }, t);
    CHECK(springs + 5 * fast::creep(kelvin, t) == doctest::Approx(t).epsilon(1e-11));
  }
}

TEST_CASE("at a frequency a modulus is what its relaxation makes of a swing") {
  for (const Modulus& modulus : moduli) {
    const double held = fast::relaxation(modulus, 1e6).value, omega = 0.7;
    const auto fading = [&](double t) { return fast::relaxation(modulus, t).value - held; };
    const double real =
        held + omega * integral([&](double t) { return fading(t) * std::sin(omega * t); }, 200);
    const double imaginary = omega * integral([&](double t) { return fading(t) * std::cos(omega * t); }, 200);
    CHECK(fast::storage(modulus, omega) == doctest::Approx(real).epsilon(1e-9));
    CHECK(fast::loss(modulus, omega) == doctest::Approx(imaginary).epsilon(1e-9));
  }
  CHECK(fast::loss({SpringModel::kelvin_voigt, 2, 0, 5}, 0.5) == 2.5);
}

TEST_CASE("theta1 and theta2 are those of the material that a scene has, term by term") {
  const auto at = [](const data::MaterialFunction& function, double t) {
    double sum = 0;
    for (const data::RelaxationTerm& term : function.terms)
      sum += (term.amplitude * std::exp(-term.rate * t)).real();
    return sum;
  };
  const Modulus shear{SpringModel::standard_linear, 2, 3, 5}, bulk{SpringModel::standard_linear, 7, 4, 0.6};
  const auto material = fast::material_functions(data::standard_linear_solid({2, 3, 7, 4, 5, 0.6}));
  for (const double t : {0.0, 1e-3, 0.3, 4.0, 60.0}) {
    CHECK(fast::theta1(shear, t).value == doctest::Approx(at(material.theta1, t)).epsilon(1e-12));
    CHECK(fast::theta2(shear, bulk, t).value == doctest::Approx(at(material.theta2, t)).epsilon(1e-12));
  }
  // The thesis's solid, theta2 a third of theta1: 4/(9 K tau) e^(-t/tau). (AIII.10, AIII.11)
  const Modulus G{SpringModel::standard_linear, 0.375, 0.375, 0.375 * 0.1},
      K{SpringModel::standard_linear, 1, 1, 0.1};
  CHECK(fast::theta1(G, 0.05).value == doctest::Approx(4.0 / 3 / 0.1 * std::exp(-0.5)).epsilon(1e-14));
  CHECK(fast::theta2(G, K, 0.05).value == doctest::Approx(4.0 / 9 / 0.1 * std::exp(-0.5)).epsilon(1e-14));
}

TEST_CASE("what gives way for ever, or not at once, has its functions of time: Maxwell, Kelvin and Voigt") {
  const Modulus shear{SpringModel::maxwell, 2, 0, 5}, bulk{SpringModel::maxwell, 3, 0, 4};
  // After long it is a fluid: 3/(6 x 4 + 2 x 5) of an impulse stay, and 1/(2 x 5).
  CHECK(fast::theta1(shear, 1e300).value == 0.1);
  CHECK(fast::theta2(shear, bulk, 1e3).value == doctest::Approx(3.0 / 34).epsilon(1e-14));
  CHECK(fast::creep(shear, 1e10) == doctest::Approx(2e9).epsilon(1e-9));
  const Modulus soft{SpringModel::kelvin_voigt, 2, 0, 5}, stiff{SpringModel::kelvin_voigt, 3, 0, 4};
  CHECK(fast::theta1(soft, 0).value == 0.1);
  CHECK(fast::theta2(soft, stiff, 0).value == doctest::Approx(3.0 / 34).epsilon(1e-15));
  CHECK(fast::creep(soft, 0) == 0);
  CHECK(fast::creep(soft, 1e-300) == 1e-300 / 5);
}

TEST_CASE("moduli: what is out of the domain is named") {
  CHECK_THROWS_WITH_AS(fast::relaxation(moduli[1], -1), "t = -1: must be finite and >= 0", data::BadInput);
  CHECK_THROWS_WITH_AS(fast::loss(moduli[1], INFINITY), "omega = inf: must be finite and >= 0",
                       data::BadInput);
  const Modulus wrong{SpringModel::standard_linear, 1, -1, 1};
  CHECK_THROWS_WITH_AS(wrong.check("shear"), doctest::Contains("shear_2 = -1"), data::BadInput);
}
