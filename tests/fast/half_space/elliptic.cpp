// The exact frictionless contact: Hertz, its displacements by the point load, symmetry, slender ellipses,
// critical lines.
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/number/internal/jacobi_amplitude.hpp>
#include <nipref/ref/half_space/elliptic.hpp>

#include "support/half_space.hpp"
#include "support/test.hpp"

using namespace nipref;
using fast::Direction;
using fast::EllipticContact;
using fast::EllipticLoad;
using fast::Indenter;
using fast::LineResponse;
using fast::SurfaceResponse;
using std::numbers::pi;
using test::any_poisson;
using test::isotropic;

namespace {

/// A compliance without any symmetry but that of a line.
LineResponse skew_line(Direction psi) {
  const double c = psi.cosine, s = psi.sine;
  return {1 + 0.6 * c * c + 0.5 * c * s + 0.3 * c * c * s * s - 0.2 * c * c * c * s, 0};
}

/// Displacement at (x1, x2) in the contact of `load`: the point load's K(phi + 90 degrees)/(2 pi r), summed
/// along the chords through the point, on which the pressure is half an ellipse.
double displacement(const EllipticContact& contact, const EllipticLoad& load, const SurfaceResponse& response,
                    double x1, double x2) {
  const Direction major = contact.major_axis();
  const double a = load.semi_major.value, b = load.semi_minor.value;
  const double u = (major.cosine * x1 + major.sine * x2) / a, v = (major.cosine * x2 - major.sine * x1) / b;
  constexpr int chords = 1000, nodes = 8;
  double sum = 0;
  for (int i = 0; i < chords; ++i) {
    const double phi = pi * i / chords;
    const double du = std::cos(phi) / a, dv = std::sin(phi) / b;
    const Direction across{-(major.cosine * std::sin(phi) + major.sine * std::cos(phi)),
                           major.cosine * std::cos(phi) - major.sine * std::sin(phi)};
    // 1 - (u + r du)^2 - (v + r dv)^2 = square (half^2 - (r - middle)^2)
    const double square = du * du + dv * dv, middle = -(u * du + v * dv) / square;
    const double half = std::sqrt((1 - u * u - v * v) / square + middle * middle);
    double chord = 0;  // Gauss-Chebyshev of the second kind, on the pressure as it is
    for (int node = 1; node <= nodes; ++node) {
      const double angle = pi * node / (nodes + 1), r = middle + half * std::cos(angle);
      const double pressure = std::sqrt(1 - std::pow(u + r * du, 2) - std::pow(v + r * dv, 2));
      chord += pressure * half * std::sin(angle) * pi / (nodes + 1);
    }
    sum += response(across).compliance * chord / (2 * pi) * pi / chords;
  }
  return sum * load.peak_pressure.value;
}

void check(const fast::Estimate& found, double truth, double epsilon) {
  CHECK(found.value == approx(truth, epsilon));
  CHECK(std::fabs(found.value - truth) <= found.error + 1e-15 * std::fabs(truth));
  CHECK(found.error < 1e-10 * std::fabs(truth));
}

}  // namespace

TEST_CASE("elliptic: a sphere at rest is Hertz's") {
  const double radius = 7, force = 0.3, modulus = 2 / (1 - any_poisson);
  const EllipticContact contact(isotropic(any_poisson, 0), Indenter::sphere(radius));
  const EllipticLoad load = contact.for_force(force);
  const double a = std::cbrt(3 * force * radius / (4 * modulus));
  check(contact.axis_ratio(), 1, 1e-14);
  check(load.semi_major, a, 1e-14);
  check(load.semi_minor, a, 1e-14);
  check(load.approach, a * a / radius, 1e-14);
  check(load.peak_pressure, 3 * force / (2 * pi * a * a), 1e-14);
  const EllipticLoad back = contact.for_approach(load.approach.value);
  check(back.force, force, 1e-14);
  check(back.semi_major, a, 1e-14);
}

TEST_CASE("elliptic: Jacobi's functions, whatever the modulus") {
  double worst = 0;
  for (int i = 0; i < 400; ++i) {
    const double complement = std::pow(10., -0.01 * i), modulus = std::sqrt(1 - complement * complement);
    const fast::JacobiAmplitude jacobi(complement);
    for (const double share : {0.1, 0.31, 0.5}) {
      const double u = share * jacobi.quarter_period();
      const auto [sn, cn, dn] = jacobi(u);
      double cn_truth, dn_truth;
      const double sn_truth = boost::math::jacobi_elliptic(modulus, u, &cn_truth, &dn_truth);
      worst = std::max({worst, std::fabs(sn - sn_truth), std::fabs(cn - cn_truth), std::fabs(dn - dn_truth)});
    }
  }
  CHECK(worst < 1e-14);
  // cn(K/2) = sqrt(k'/(1 + k')), small against 1 and yet to its own digits but for those of K.
  for (const double complement : {1., 0.9, 0.1, 1e-4, 1e-12}) {
    const fast::JacobiAmplitude jacobi(complement);
    CHECK(jacobi(jacobi.quarter_period() / 2).cn == approx(std::sqrt(complement / (1 + complement)), 5e-14));
  }
}

TEST_CASE("elliptic: a slender body across the motion, next to the critical speed") {
  // Where the compliance has its peak, the amplitude is near 90 degrees.
  const double poisson = 0x1.556be6b69a274p-2, limit = fast::isotropic_rayleigh_speed(poisson);
  const ref::Exact unit(1.0), nu(poisson), ratio(3e-10);
  const auto solid = ref::sagittal_stiffness(ref::ExactTransverse::isotropic(unit, nu, unit));
  for (const double gap : {1e-4, 1e-6}) {
    const double speed = (1 - gap) * limit;
    const auto motion = ref::SurfaceDirection::of_degrees(ref::Exact(0.0));
    const ref::SurfaceAnswer exactly = [&](const ref::Exact& degrees, int digits) -> ref::LineAnswer {
      const auto answer = ref::line_response(solid, ref::Exact(speed), motion,
                                             ref::SurfaceDirection::of_degrees(degrees), digits);
      return {answer.compliance.value, answer.coupling.value, answer.coupling_across.value,
              answer.in_line.value};
    };
    const SurfaceResponse in_double = [&](Direction psi) {
      return fast::isotropic_response({1, poisson, 1}, speed, psi);
    };
    const auto [value, error] = EllipticContact(in_double, {1, 3e-10}).axis_ratio();
    CHECK(std::fabs(ref::elliptic_axis_ratio(exactly, ratio, 18).error_of(value)) <= error);
    CHECK(error < 2e-14 * value);
  }
}

TEST_CASE(
    "elliptic: a body that is slender across a sharply peaked compliance, which makes it long along that") {
  const double poisson = 0.43968265359691439;
  const double speed = (1 - 3.64e-8) * fast::isotropic_rayleigh_speed(poisson);
  const SurfaceResponse response = [&](Direction psi) {
    return fast::isotropic_response({1, poisson, 1}, speed, psi);
  };
  const auto [value, error] = EllipticContact(response, {1, 5e-4}).axis_ratio();
  CHECK(error < 1e-12 * value);
}

TEST_CASE("elliptic: Hertz's ellipse by complete elliptic integrals, slender to 1e-5") {
  // (Johnson, Contact Mechanics, 4.26-4.28) for a = 1 and p0 = E*, in Carlson's integrals, which keep their
  // digits for circle and line alike: (K - E)/k^2 = R_D(0, k'^2, 1)/3, (E/k'^2 - K)/k^2 = R_D(0, 1, k'^2)/3.
  for (const double ratio : {1., 0.999, 0.9, 0.5, 0.1, 1e-2, 1e-3, 1e-5}) {
    const double square = ratio * ratio;
    const double curvature_1 = 2 * ratio * boost::math::ellint_rd(0, square, 1) / 3;
    const double curvature_2 = 2 * ratio * boost::math::ellint_rd(0, 1, square) / 3;
    const SurfaceResponse unit = [](Direction) { return LineResponse{2, 0}; };
    for (const bool turned : {false, true}) {
      const Indenter body = turned ? Indenter{curvature_2, curvature_1} : Indenter{curvature_1, curvature_2};
      const EllipticContact contact(unit, body);
      CHECK(contact.axis_ratio().value == approx(ratio, 1e-13));
      const auto [angle, angle_error] = contact.orientation();
      CHECK(std::fabs(std::fabs(angle) - (turned && ratio < 1 ? pi / 2 : 0)) < 1e-12 + angle_error);
      const EllipticLoad load = contact.for_force(2 * pi / 3 * ratio);
      CHECK(load.peak_pressure.value == doctest::Approx(1).epsilon(1e-13));
      CHECK(load.semi_major.value == doctest::Approx(1).epsilon(1e-13));
      CHECK(load.approach.value == approx(ratio * boost::math::ellint_rf(0, square, 1), 1e-13));
    }
  }
}

TEST_CASE("elliptic: the displacement under the pressure is the body, by the point load") {
  struct Case {
    SurfaceResponse response;
    Indenter body;
  };
  const std::array cases{Case{isotropic(any_poisson, 0.8), {1, 0.4}},
                         Case{isotropic(any_poisson, 0.925), {1, 1}}, Case{skew_line, {1, 1}},
                         Case{skew_line, {0.2, 1.3}}};
  for (const auto& [response, body] : cases) {
    const EllipticContact contact(response, body);
    const EllipticLoad load = contact.for_force(0.01);
    const double delta = load.approach.value;
    CHECK(displacement(contact, load, response, 0, 0) == approx(delta, 1e-12));
    for (int i = 0; i < 12; ++i) {
      const Direction psi = Direction::of_angle(0.55 * i);
      const double r = 0.95 * load.semi_major.value * contact.radius_ratio(psi).value;
      const double found = displacement(contact, load, response, r * psi.cosine, r * psi.sine);
      CHECK(found == approx(delta - body.curvature(psi) * r * r / 2, 1e-12));
    }
  }
}

TEST_CASE("elliptic: a moving sphere, the axis ratios of the notes") {
  const auto ratio = [](double speed) {
    const EllipticContact contact(isotropic(any_poisson, speed), Indenter::sphere(1));
    CHECK(std::fabs(contact.orientation().value) < 1e-12);  // longer along the motion
    return contact.axis_ratio().value;
  };
  CHECK(std::fabs(ratio(0.6) - 0.8905) < 5e-5);
  CHECK(std::fabs(ratio(0.3) - 0.9770) < 5e-5);
  double before = 1;
  for (const double speed : {0.5, 0.9, 0.93, 0.932, 0.9324}) {  // up to the Rayleigh speed 0.93253
    const double now = ratio(speed);
    CHECK(now < before);
    before = now;
  }
}

TEST_CASE("elliptic: turning solid and body together turns the ellipse") {
  const Indenter body{0.3, 1};
  const EllipticContact still(skew_line, body);
  const SurfaceResponse quarter = [](Direction psi) { return skew_line({psi.sine, -psi.cosine}); };
  const EllipticContact turned(quarter, {body.curvature_2, body.curvature_1});
  CHECK(turned.axis_ratio().value == doctest::Approx(still.axis_ratio().value).epsilon(1e-14));
  CHECK(std::fabs(std::remainder(turned.orientation().value - still.orientation().value - pi / 2, pi)) <
        1e-13);
  // A sphere may turn by any angle.
  const EllipticContact sphere(skew_line, Indenter::sphere(1));
  for (const double angle : {0.1, 0.7, 1.4, 2.9}) {
    const Direction by = Direction::of_angle(angle);
    const SurfaceResponse response = [by](Direction psi) {
      return skew_line(
          {psi.cosine * by.cosine + psi.sine * by.sine, psi.sine * by.cosine - psi.cosine * by.sine});
    };
    const EllipticContact other(response, Indenter::sphere(1));
    check(other.axis_ratio(), sphere.axis_ratio().value, 1e-13);
    CHECK(std::fabs(std::remainder(other.orientation().value - sphere.orientation().value - angle, pi)) <
          1e-12);
    check(other.for_force(1).approach, sphere.for_force(1).approach.value, 1e-13);
  }
}

TEST_CASE("elliptic: force is the work of the approach") {
  // dW/d delta = F with F ~ delta^(3/2): a stiffer half-space carries more; scaling laws.
  const EllipticContact contact(skew_line, {0.3, 1});
  const EllipticLoad one = contact.for_approach(1e-3), four = contact.for_approach(4e-3);
  check(four.force, 8 * one.force.value, 1e-14);
  check(four.semi_minor, 2 * one.semi_minor.value, 1e-14);
  check(one.force, 2 * pi / 3 * one.semi_major.value * one.semi_minor.value * one.peak_pressure.value, 1e-13);
  const SurfaceResponse softer = [](Direction psi) { return LineResponse{3 * skew_line(psi).compliance, 0}; };
  check(EllipticContact(softer, {0.3, 1}).for_approach(1e-3).force, one.force.value / 3, 1e-14);
}

TEST_CASE("elliptic: a radius leads to the force that makes it, with an error") {
  const EllipticContact contact(skew_line, {0.3, 1});
  const EllipticLoad load = contact.for_force(0.02);
  for (const double angle : {0.0, 0.7, 2.0}) {
    const Direction psi = Direction::of_angle(angle);
    const auto [ratio, error] = contact.radius_ratio(psi);
    const EllipticLoad back = contact.for_radius(psi, ratio * load.semi_major.value);
    CHECK(back.force.error > 0);
    CHECK(std::fabs(back.force.value - 0.02) <= 2 * back.force.error);
    CHECK(back.force.error < 1e-12 * 0.02);
  }
  CHECK_THROWS_AS(static_cast<void>(contact.for_radius({1, 0}, 0)), data::BadInput);
}

TEST_CASE("elliptic: the search for an ellipse asks for no more lines than it did") {
  struct Scene {
    const char* what;
    SurfaceResponse surface;
    double curvature_ratio;
    int most;
  };
  const double rayleigh = fast::isotropic_rayleigh_speed(any_poisson);
  const SurfaceResponse close = [rayleigh](Direction psi) {
    return fast::isotropic_response({1, any_poisson, 1}, (1 - 1e-9) * rayleigh, psi);
  };
  for (const auto& [what, surface, curvature_ratio, most] :
       {Scene{"a sphere at rest", isotropic(any_poisson, 0), 1, 300},
        Scene{"a slender body at rest", isotropic(any_poisson, 0), 1e-6, 1000},
        Scene{"a moving sphere", isotropic(any_poisson, 0.9 * rayleigh), 1, 1050},
        Scene{"a moving slender body", isotropic(any_poisson, 0.9 * rayleigh), 1e4, 1500},
        Scene{"a sphere close to the Rayleigh speed", close, 1, 10000},
        Scene{"a skew solid under a slender body", skew_line, 1e-6, 1200}}) {
    CAPTURE(what);
    int lines = 0;
    const SurfaceResponse counted = [&](Direction psi) {
      ++lines;
      return surface(psi);
    };
    const EllipticContact contact(counted, {1, curvature_ratio});
    CHECK(contact.axis_ratio().error < 1e-9);
    CHECK(lines <= most);
  }
}

TEST_CASE("elliptic: skew solids under slender bodies") {
  for (const double ratio : {1e-10, 1e-5, 1e5, 1e10}) {
    const EllipticContact contact(skew_line, {ratio, 1});
    const auto [value, error] = contact.axis_ratio();
    CHECK(value > 0);
    CHECK(error < 1e-11 * value);
    // The major axis is close to the flat direction; slender: line contact across it, p0 = 2 delta... b/R K.
    const EllipticLoad load = contact.for_force(1);
    const double across = std::fmax(ratio, 1), b = load.semi_minor.value;
    const double compliance = skew_line(ratio < 1 ? Direction{0, 1} : Direction{1, 0}).compliance;
    CHECK(load.peak_pressure.value * compliance / (across * b) == doctest::Approx(1).epsilon(50 * value));
  }
}

TEST_CASE("elliptic: towards a critical line the contact keeps its digits") {
  // A peak of K along the motion, as narrow as sqrt(gap): for a sphere int K (cos^2 - sin^2)/w^3 dpsi = 0,
  // here by a double-exponential rule, which crowds at 0 and 90 degrees.
  boost::math::quadrature::tanh_sinh<double> rule;
  for (const double gap : {1e-4, 1e-8, 1e-12}) {
    const SurfaceResponse peaked = [gap](Direction psi) {
      const double c = psi.cosine * psi.cosine, s = psi.sine * psi.sine;
      return LineResponse{1 + c / (gap * c + s), 0};
    };
    const EllipticContact contact(peaked, {1, 1});
    const auto [ratio, error] = contact.axis_ratio();
    CHECK(error < 1e-12 * ratio);
    CHECK(std::fabs(contact.orientation().value) < 1e-13);
    const auto moment = [&](double cosines, double sines) {
      return rule.integrate(
          [&](double psi) {
            const Direction n = Direction::of_angle(psi);
            const double c = n.cosine * n.cosine, s = n.sine * n.sine;
            return peaked(n).compliance * (cosines * c + sines * s) / std::pow(c + ratio * ratio * s, 1.5);
          },
          0., pi / 2, 1e-14);
    };
    CHECK(std::fabs(moment(1, -1)) < 1e-11 * moment(1, 0));
  }
}

TEST_CASE("elliptic: a kinked compliance has an honest error") {
  const SurfaceResponse kinked = [](Direction psi) { return LineResponse{1 + std::fabs(psi.cosine), 0}; };
  const auto [value, error] = EllipticContact(kinked, {1, 1}).axis_ratio();
  // int (1 + |cos|) cos(2 psi)/w^3 has the kink where panels always end; turned it has not.
  const SurfaceResponse turned = [](Direction psi) {
    return LineResponse{1 + std::fabs(psi.cosine * std::cos(0.3) + psi.sine * std::sin(0.3)), 0};
  };
  const auto other = EllipticContact(turned, {1, 1}).axis_ratio();
  CHECK(std::fabs(value - other.value) <= error + other.error);
  CHECK(other.error < 1e-12);
}

TEST_CASE("elliptic: bad input is one line that names it") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(EllipticContact(isotropic(any_poisson, 0.95), {1, 1}), data::BadInput);
  CHECK_THROWS_AS(EllipticContact(skew_line, {1, nan}), data::BadInput);
  CHECK_THROWS_AS(EllipticContact(skew_line, {1, -1}), data::BadInput);
  CHECK_THROWS_AS(EllipticContact(skew_line, {1, 1e11}), data::BadInput);
  const EllipticContact contact(skew_line, {1, 1});
  CHECK_THROWS_AS(static_cast<void>(contact.for_force(0)), data::BadInput);
  CHECK_THROWS_AS(static_cast<void>(contact.for_approach(nan)), data::BadInput);
  CHECK_THROWS_AS(static_cast<void>(contact.radius_ratio({nan, 1})), data::BadInput);
}
