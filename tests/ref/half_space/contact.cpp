// Contacts of the half-space in multiprecision, from the response of an isotropic half-space written out
// here.
#include <doctest/doctest.h>

#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <cmath>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/contact.hpp>
#include <nipref/ref/number/internal/float.hpp>

using namespace nipref;
using ref::Exact;
using ref::Float;

namespace {

/// mu = 1. (brock2012 18a and its counterpart for the shear)
ref::SurfaceAnswer isotropic(double poisson, double speed) {
  return [=](const Exact& degrees, int digits) -> ref::LineAnswer {
    const ref::WorkingDigits working(2 * digits + 20);
    const mpq_class from_90 = 90 - abs(degrees.value());
    const Float cosine = sin(ref::to_float(Exact(from_90)) * ref::pi() / 180);
    const Float nu = poisson,
                X = std::max(Float(speed * cosine * speed * cosine), Float(pow(Float(10), -digits)));
    const Float wS = sqrt(1 - X), wD = sqrt(1 - X * (1 - 2 * nu) / (2 - 2 * nu));
    const Float R = 4 * wS * wD - (2 - X) * (2 - X), minus_N = 2 - X - 2 * wS * wD;
    return {ref::to_real(X * wD / R), ref::to_real(minus_N / R), ref::to_real(Float(0)),
            ref::to_real(X * wS / R)};
  };
}

}  // namespace

TEST_CASE("the reference's sliding contact at rest without friction is a circle of known force") {
  const auto surface = isotropic(0.25, 1e-30);
  CHECK(ref::sliding_exponent(surface, Exact(0.0), Exact(30.0), 25).to_double() == -0.5);
  CHECK(ref::sliding_span_ratio(surface, Exact(0.0), Exact(70.0), 20).to_double() ==
        doctest::Approx(1).epsilon(1e-15));
  // The pressure (C/K) sqrt(L^2/4 - x^2) over a disc: (2 pi/3)(L/2)^3 C/K, K = 1 - nu.
  CHECK(ref::sliding_force(surface, Exact(0.0), 20).to_double() ==
        doctest::Approx(2 * std::numbers::pi / 3 / 8 / 0.75).epsilon(1e-14));
  CHECK(ref::elliptic_axis_ratio(surface, Exact(1.0), 20).to_double() == doctest::Approx(1).epsilon(1e-15));
  CHECK(ref::elliptic_stiffness(surface, Exact(1.0), 20).to_double() ==
        doctest::Approx(8 / (3 * 0.75)).epsilon(1e-14));
}

TEST_CASE("the reference's die at rest is Hertz's ellipse") {
  // (Johnson, Contact Mechanics, 4.26-4.28) by Carlson's integrals, for axes a = 1 and b = ratio, p0 = E*.
  const auto surface = isotropic(0.25, 1e-30);
  for (const double ratio : {0.9, 0.4, 0.15}) {
    const double square = ratio * ratio;
    const double flat = 2 * ratio * boost::math::ellint_rd(0, square, 1) / 3;
    const double sharp = 2 * ratio * boost::math::ellint_rd(0, 1, square) / 3;
    const double approach = ratio * boost::math::ellint_rf(0, square, 1), modulus = 2 / 0.75;
    const double force = 2 * std::numbers::pi / 3 * ratio * modulus;
    const double stiffness = force / std::pow(approach, 1.5) * std::sqrt((flat + sharp) / 2);
    for (const double curvature_ratio : {sharp / flat, flat / sharp}) {
      CHECK(ref::elliptic_axis_ratio(surface, Exact(curvature_ratio), 18).to_double() ==
            doctest::Approx(ratio).epsilon(1e-13));
      CHECK(ref::elliptic_stiffness(surface, Exact(curvature_ratio), 18).to_double() ==
            doctest::Approx(stiffness).epsilon(1e-13));
    }
  }
  CHECK_THROWS_AS((void)ref::elliptic_axis_ratio(surface, Exact(0.0), 18), data::BadInput);
}

TEST_CASE("moving contacts have the shapes found before") {
  const auto surface = isotropic(1.0 / 3, 0.6);
  CHECK(ref::elliptic_axis_ratio(surface, Exact(1.0), 18).to_double() ==
        doctest::Approx(0.8905).epsilon(1e-4));
  // Table 2 of brock2012, last cell; and with cD^2 = 4 what its Table 1 should have for c = 0.6, gamma = 0.
  CHECK(ref::rolling_span_ratio(surface, Exact(90.0), 18).to_double() ==
        doctest::Approx(0.7318).epsilon(1e-4));
  CHECK(ref::sliding_span_ratio(surface, Exact(0.0), Exact(90.0), 18).to_double() ==
        doctest::Approx(0.7047).epsilon(1e-4));
}

TEST_CASE("the rolling index near rest is that of Dundurs' constant for a rigid body") {
  const double nu = 0.3, q = (1 - 2 * nu) / (2 - 2 * nu);
  CHECK(ref::rolling_index(isotropic(nu, 1e-20), Exact(10.0), 18).to_double() ==
        doctest::Approx(std::atanh(q) / std::numbers::pi).epsilon(1e-14));
}

TEST_CASE("friction moves the peak back and leaves the cross direction alone") {
  const auto surface = isotropic(0.25, 0.3);
  const Exact friction(0.5);
  CHECK(ref::sliding_exponent(surface, friction, Exact(0.0), 20).to_double() > -0.5);
  CHECK(ref::sliding_exponent(surface, friction, Exact(90.0), 20).to_double() == -0.5);
  const double with = ref::sliding_force(surface, friction, 18).to_double();
  const double without = ref::sliding_force(surface, Exact(0.0), 18).to_double();
  CHECK(std::fabs(with - without) > 1e-3 * without);
  CHECK_THROWS_AS((void)ref::sliding_force(surface, friction, 15), data::BadInput);
}
