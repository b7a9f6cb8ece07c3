#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

#include <nipref/ref/half_space/elliptic.hpp>

#include "support/isotropic_surface.hpp"
#include "support/test.hpp"

using namespace nipref;
using ref::Exact;

TEST_CASE("the reference's sphere at rest is Hertz's") {
  const auto surface = isotropic_surface(0.25, 1e-30);
  CHECK(ref::elliptic_axis_ratio(surface, Exact(1.0), 20).to_double() == doctest::Approx(1).epsilon(1e-15));
  CHECK(ref::elliptic_stiffness(surface, Exact(1.0), 20).to_double() ==
        doctest::Approx(8 / (3 * 0.75)).epsilon(1e-14));
}

TEST_CASE("the reference's die at rest is Hertz's ellipse") {
  // (Johnson, Contact Mechanics, 4.26-4.28) by Carlson's integrals, for axes a = 1 and b = ratio, p0 = E*.
  const auto surface = isotropic_surface(0.25, 1e-30);
  for (const double ratio : {0.9, 0.4, 1e-3, 1e-6}) {
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
}

TEST_CASE("the reference's ellipse under a compliance with a narrow peak, wherever that lies") {
  // K = 1 + 1/(gap + sin^2(psi - peak)) turns with its peak, and a sphere's ellipse with it.
  const auto peaked = [](double gap, const Exact& peak) -> ref::SurfaceAnswer {
    return [=](const Exact& degrees, int digits) -> ref::LineAnswer {
      const ref::WorkingDigits working(digits + 20);
      const ref::Float off = ref::to_float(Exact(mpq_class(degrees.value() - peak.value())));
      const ref::Float s = sin(off * ref::pi() / 180), none = 0;
      const ref::Float compliance = 1 + 1 / (gap + s * s);
      return {compliance, none, none, none};
    };
  };
  for (const double gap : {1e-2, 1e-6, 1e-9}) {
    const auto along = ref::elliptic_axis_ratio(peaked(gap, Exact(0.0)), Exact(1.0), 20);
    const auto askew = ref::elliptic_axis_ratio(peaked(gap, Exact::parse("33.3")), Exact(1.0), 20);
    CHECK(along.to_double() < 1);
    CHECK(along.to_double() == doctest::Approx(askew.to_double()).epsilon(1e-15));
  }
}

TEST_CASE("a sphere on a moving half-space has the shape found before") {
  CHECK(ref::elliptic_axis_ratio(isotropic_surface(1.0 / 3, 0.6), Exact(1.0), 18).to_double() ==
        doctest::Approx(0.8905).epsilon(1e-4));
}

TEST_CASE("the reference's search for an ellipse asks for no more lines than it did") {
  struct Scene {
    double speed, curvature_ratio;
    int most;
  };
  for (const auto& [speed, curvature_ratio, most] :
       {Scene{1e-30, 1, 120}, Scene{1e-30, 1e-6, 350}, Scene{0.8, 1, 210}, Scene{0.8, 1e4, 670}}) {
    CAPTURE(speed);
    CAPTURE(curvature_ratio);
    int lines = 0;
    const ref::SurfaceAnswer surface = isotropic_surface(0.25, speed);
    const ref::SurfaceAnswer counted = [&](const Exact& degrees, int digits) {
      ++lines;
      return surface(degrees, digits);
    };
    static_cast<void>(ref::elliptic_axis_ratio(counted, Exact(curvature_ratio), 20));
    CHECK(lines <= most);
  }
}

TEST_CASE("what the reference cannot make an ellipse of is refused by name") {
  const auto surface = isotropic_surface(0.25, 1e-30);
  const auto refused = [](const ref::SurfaceAnswer& answer, const Exact& ratio, const char* name) {
    CHECK_THROWS_WITH_AS((void)ref::elliptic_axis_ratio(answer, ratio, 18), doctest::Contains(name),
                         data::BadInput);
    CHECK_THROWS_WITH_AS((void)ref::elliptic_stiffness(answer, ratio, 18), doctest::Contains(name),
                         data::BadInput);
  };
  refused(surface, Exact(0.0), "curvature_ratio = 0");
  refused(surface, Exact::parse("1.1e12"), "curvature_ratio = 1100000000000");
  refused(surface, Exact::parse("1e-5000"), "curvature_ratio = 1e-5000");
  const ref::SurfaceAnswer no_number = [&](const Exact& degrees, int digits) {
    ref::LineAnswer line = surface(degrees, digits);
    mpfr_set_nan(ref::raw(line.compliance));
    return line;
  };
  refused(no_number, Exact(1.0), "surface = nan");
}

TEST_CASE("the reference's contact of a sphere at rest is Hertz's, the force given or the span") {
  // K = 1 - nu = 3/4: F = 8/(3 K) sqrt(R) approach^(3/2), a^2 = R approach, peak = 3 F/(2 pi a^2).
  const double radius = 2, force = 0.01, K = 0.75;
  const auto body = ref::Indenter::of_radii(radius, radius);
  const ref::EllipticContact contact(isotropic_surface(0.25, 1e-30), body, data::GivenNormalForce{force}, 20);
  const double approach = std::pow(3 * K * force / (8 * std::sqrt(radius)), 2.0 / 3);
  const double a = std::sqrt(radius * approach);
  CHECK(contact.approach().to_double() == doctest::Approx(approach).epsilon(1e-14));
  CHECK(contact.span(Exact(33.0)).to_double() == doctest::Approx(2 * a).epsilon(1e-14));
  CHECK(contact.peak_pressure().to_double() ==
        doctest::Approx(3 * force / (2 * std::numbers::pi * a * a)).epsilon(1e-14));
  CHECK(mpfr_get_d(ref::raw(contact.orientation().error), MPFR_RNDN) == 90);
  const ref::EllipticContact back(isotropic_surface(0.25, 1e-30), body, data::GivenSpan{2 * a}, 20);
  CHECK(back.force().to_double() == doctest::Approx(force).epsilon(1e-14));
}
