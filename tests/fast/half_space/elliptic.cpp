// The exact frictionless contact: its work, slender ellipses, compliances with peaks and kinks.
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include <nipref/fast/half_space/anisotropic.hpp>
#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/fast/number/internal/jacobi_amplitude.hpp>
#include <nipref/ref/half_space/elliptic.hpp>

#include "support/half_space.hpp"

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

/// A compliance whose only symmetry is that of a line: opposite directions are equal.
LineResponse skew_line(Direction psi) {
  const double c = psi.cosine, s = psi.sine;
  return {1 + 0.6 * c * c + 0.5 * c * s + 0.3 * c * c * s * s - 0.2 * c * c * c * s, 0};
}

}  // namespace

TEST_CASE("elliptic: Jacobi's functions are accurate whatever the modulus") {
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
  // cn(K/2) = sqrt(k'/(1 + k')) is accurate relative to itself, even if it is small, up to the rounding error of K.
  for (const double complement : {1., 0.9, 0.1, 1e-4, 1e-12}) {
    const fast::JacobiAmplitude jacobi(complement);
    CHECK(jacobi(jacobi.quarter_period() / 2).cn == approx(std::sqrt(complement / (1 + complement)), 5e-14));
  }
}

TEST_CASE("elliptic: the axis ratio of a slender body across a sharp peak of the compliance has 12 digits") {
  const double poisson = 0.43968265359691439;
  const double speed = (1 - 3.64e-8) * fast::isotropic_rayleigh_speed(poisson);
  const SurfaceResponse response = [&](Direction psi) {
    return fast::isotropic_response({1, poisson, 1}, speed, psi);
  };
  const auto [value, error] = EllipticContact(response, {1, 5e-4}).axis_ratio();
  CHECK(error < 1e-12 * value);
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

TEST_CASE("elliptic: a slender body on a skew solid makes the line contact across it") {
  for (const double ratio : {1e-10, 1e-5, 1e5, 1e10}) {
    const EllipticContact contact(skew_line, {ratio, 1});
    const auto [value, error] = contact.axis_ratio();
    CHECK(value > 0);
    CHECK(error < 1e-11 * value);
    // The major axis is close to the flat direction. A slender contact is a line contact across it: p0 = b/(R K).
    const EllipticLoad load = contact.for_force(1);
    const double across = std::fmax(ratio, 1), b = load.semi_minor.value;
    const double compliance = skew_line(ratio < 1 ? Direction{0, 1} : Direction{1, 0}).compliance;
    CHECK(load.peak_pressure.value * compliance / (across * b) == doctest::Approx(1).epsilon(50 * value));
  }
}

TEST_CASE("elliptic: the stated error covers what a kink in the compliance costs") {
  const SurfaceResponse kinked = [](Direction psi) { return LineResponse{1 + std::fabs(psi.cosine), 0}; };
  const auto [value, error] = EllipticContact(kinked, {1, 1}).axis_ratio();
  // The integrand (1 + |cos|) cos(2 psi)/w^3 has its kink where panels always end. The turned one has it elsewhere.
  const SurfaceResponse turned = [](Direction psi) {
    return LineResponse{1 + std::fabs(psi.cosine * std::cos(0.3) + psi.sine * std::sin(0.3)), 0};
  };
  const auto other = EllipticContact(turned, {1, 1}).axis_ratio();
  CHECK(std::fabs(value - other.value) <= error + other.error);
  CHECK(other.error < 1e-12);
}

TEST_CASE("elliptic: bad input is refused") {
  CHECK_THROWS_AS(EllipticContact(isotropic(any_poisson, 0.95), {1, 1}), data::BadInput);
  CHECK_THROWS_AS(EllipticContact(skew_line, {1, not_a_number}), data::BadInput);
  CHECK_THROWS_AS(EllipticContact(skew_line, {1, -1}), data::BadInput);
  CHECK_THROWS_AS(EllipticContact(skew_line, {1, 1e11}), data::BadInput);
  const EllipticContact contact(skew_line, {1, 1});
  CHECK_THROWS_AS(static_cast<void>(contact.for_force(0)), data::BadInput);
  CHECK_THROWS_AS(static_cast<void>(contact.for_approach(not_a_number)), data::BadInput);
  CHECK_THROWS_AS(static_cast<void>(contact.radius_ratio({not_a_number, 1})), data::BadInput);
}

TEST_CASE("elliptic: under a sphere at rest the surface is displaced as Hertz and Johnson have it") {
  // Johnson, Contact Mechanics, (3.41) to (3.42), with mu = 1; r is divided by a.
  const SurfaceResponse response = isotropic(any_poisson, 0);
  const EllipticContact contact(response, Indenter::sphere(7));
  const EllipticLoad load = contact.for_force(0.3);
  const double unit = load.peak_pressure.value * load.semi_major.value;
  for (const double r : {0., 1e-8, 0.4, 0.999999, 1., 1.000001, 2.5, 1e7}) {
    CAPTURE(r);
    const double near =
        r <= 1 ? pi * (2 - r * r) / 8 : ((2 - r * r) * std::asin(1 / r) + std::sqrt((r - 1) * (r + 1))) / 4;
    const double into = r < 100 ? near : 1 / (3 * r);  // as under a point load
    const double inward = r == 0 ? 0 : (r < 1 ? -std::expm1(1.5 * std::log1p(-r * r)) : 1) / (6 * r);
    const auto [along, across, normal] =
        contact.displacement(load, response, Direction::of_degrees(120), r * load.semi_major.value);
    const double shift = -(1 - 2 * any_poisson) * unit * inward;
    CHECK(normal.value == approx((1 - any_poisson) * unit * into, 1e-11));
    CHECK(std::fabs(along.value + shift / 2) <= along.error + 1e-12 * std::fabs(shift));
    CHECK(std::fabs(across.value - shift * std::sqrt(0.75)) <= across.error + 1e-12 * std::fabs(shift));
    CHECK(normal.error < 2e-13 * normal.value);
    CHECK(along.error < 2e-12 * normal.value);
  }
  CHECK_REFUSED(contact.displacement(load, response, {1, 0}, INFINITY), "x = inf");
}

TEST_CASE("elliptic: the surface across the motion is displaced alike on both sides") {
  const SurfaceResponse response = isotropic(any_poisson, 0);
  // The computed major axis of some of these circles is exactly along the motion. On one side the place then has the
  // coordinate -0.
  for (int radius = 1; radius <= 40; ++radius) {
    const EllipticContact contact(response, Indenter::sphere(radius));
    const EllipticLoad load = contact.for_force(0.3);
    const auto normal = [&](double side) {
      return contact.displacement(load, response, Direction::of_degrees(90), side * load.semi_major.value)[2];
    };
    CHECK(std::fabs(normal(0.9).value - normal(-0.9).value) <= normal(0.9).error + normal(-0.9).error);
  }
}

TEST_CASE("elliptic: a slender body's surface has its shape in the contact, next to the critical speed too") {
  for (const double gap : {1., 1e-2, 1e-6}) {
    const double speed = (1 - gap) * fast::isotropic_rayleigh_speed(any_poisson);
    const SurfaceResponse response = [speed](Direction psi) {
      return fast::isotropic_response({1, any_poisson, 1}, speed, psi);
    };
    for (const Indenter body : {Indenter{1, 1}, Indenter{1, 1e-4}, Indenter{1e-4, 1}}) {
      const EllipticContact contact(response, body);
      const EllipticLoad load = contact.for_force(1e-4);
      for (const double degrees : {0., 0.1, 35., 90.}) {
        const Direction psi = Direction::of_degrees(degrees);
        const double x = 0.9 * contact.radius_ratio(psi).value * load.semi_major.value;
        const auto normal = contact.displacement(load, response, psi, x)[2];
        const double truth = load.approach.value - body.curvature(psi) * x * x / 2;
        CHECK(std::fabs(normal.value - truth) <= normal.error + load.approach.error);
        CHECK(normal.error < 1e-12 * load.approach.value);
      }
    }
  }
}

TEST_CASE("elliptic: both paths displace a surface without any symmetry alike") {
  const auto entries = [](auto c, auto s, auto line) {
    line.compliance = 2 + c * c + c * s / 2;
    line.coupling = c * c / 2 - c * s / 3 - s * s / 4;
    line.coupling_across = c * s + s * s / 5;
    line.shear_compliance = c / 3 - s * s * s / 2;
    line.shear_compliance_across = c * c * c / 4 + s / 6;
    return line;
  };
  const SurfaceResponse in_double = [&](Direction psi) {
    return entries(psi.cosine, psi.sine, LineResponse{});
  };
  const ref::SurfaceAnswer exactly = [&](const ref::Exact& degrees, int digits) {
    const ref::WorkingDigits working(digits + 20);
    const ref::Float angle = ref::to_float(degrees) * ref::pi() / 180, none = 0;
    return entries(ref::Float(cos(angle)), ref::Float(sin(angle)), ref::LineAnswer{none, none, none, none});
  };
  const EllipticContact fast_contact(in_double, {3, 1});
  const EllipticLoad load = fast_contact.for_force(1);
  const ref::EllipticContact contact(exactly, {ref::Exact(3.0), ref::Exact(1.0)}, data::GivenNormalForce{1},
                                     18);
  const auto displacement = contact.displacement(exactly, ref::Exact(0.0));
  for (const auto& [degrees, share] : {std::pair(0., 0.5), std::pair(70., 0.999), std::pair(-40., 1.01),
                                       std::pair(10., -300.), std::pair(0., 0.)}) {
    CAPTURE(degrees);
    const double x = share * load.semi_major.value;
    const auto found = fast_contact.displacement(load, in_double, Direction::of_degrees(degrees), x);
    const auto truth = displacement(ref::Exact(degrees), ref::Exact(x));
    for (std::size_t i = 0; i < found.size(); ++i) {
      CAPTURE(i);
      CHECK(mpfr_get_d(ref::raw(truth[i].error), MPFR_RNDU) < 1e-16 * std::fabs(found[2].value));
      CHECK(std::fabs(truth[i].error_of(found[i].value)) <= found[i].error);
      CHECK(found[i].error < 1e-12 * std::fabs(found[2].value));
    }
  }
}

TEST_CASE("elliptic: below a sphere at rest a solid of any name is displaced as Boussinesq has it") {
  // Sums over the pressure of the displacements by point loads, at r = sin(angle) from the centre, with mu = 1.
  const data::IsotropicSolid solid{1, any_poisson, 1};
  const SurfaceResponse response = isotropic(any_poisson, 0);
  const EllipticContact contact(response, Indenter::sphere(7));
  const EllipticLoad load = contact.for_force(0.3);
  const double a = load.semi_major.value;
  const fast::AnisotropicHalfSpace anisotropic(data::Stiffness::of(solid), {1, 0}, 0);
  const double lame = 2 * any_poisson / (1 - 2 * any_poisson);
  const fast::TransverselyIsotropicHalfSpace transverse({lame + 2, lame + 2, lame, 1, 1, 1},
                                                        data::SymmetryAxis::normal, {1, 0}, 0);
  for (const auto& [x, z] :
       {std::pair(0.0, 0.7), std::pair(0.8, 0.4), std::pair(3.0, 0.9), std::pair(0.3, 30.0)}) {
    CAPTURE(x);
    double into = 0, outward = 0;
    constexpr int rings = 200, parts = 400;
    for (int i = 0; i < rings; ++i) {
      const double angle = pi / 2 * (i + 0.5) / rings, r = std::sin(angle),
                   p = std::pow(std::cos(angle), 2) * r;
      for (int k = 0; k < parts; ++k) {
        const double psi = 2 * pi * k / parts, dx = x - r * std::cos(psi),
                     far = std::hypot(dx, r * std::sin(psi), z);
        into += p * (2 * (1 - any_poisson) / far + z * z / (far * far * far));
        outward += p * dx * (z / (far * far * far) - (1 - 2 * any_poisson) / (far * (far + z)));
      }
    }
    const double unit = load.peak_pressure.value * a / (4 * pi) * (pi / 2 / rings) * (2 * pi / parts);
    const fast::PressureWaves isotropic_waves = [&](Direction psi) {
      return fast::isotropic_pressure_wave(solid, 0, psi);
    };
    const auto first = contact.displacement(load, isotropic_waves, {1, 0}, x * a, z * a);
    for (const auto& waves :
         {isotropic_waves, fast::PressureWaves([&](Direction psi) { return anisotropic.inside(psi); }),
          fast::PressureWaves([&](Direction psi) { return transverse.inside(psi); })}) {
      const auto found = contact.displacement(load, waves, {1, 0}, x * a, z * a);
      // The midpoint rule over the rings has the error h^2/24 times the integrand's slope in the middle.
      CHECK(std::fabs(found[0].value - unit * outward) <= 2e-5 * unit * into);
      CHECK(found[2].value == approx(unit * into, 2e-5));
      CHECK(found[2].error < 1e-12 * found[2].value);
      for (std::size_t i = 0; i < 3; ++i)
        CHECK(std::fabs(found[i].value - first[i].value) <= found[i].error + first[i].error);
    }
  }
  CHECK_REFUSED(contact.displacement(load, response, {1, 0}, 0, -1), "depth = -1");
}
