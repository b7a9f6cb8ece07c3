// Half-spaces under loads that move steadily: directions, hard lines, critical speeds.
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/response.hpp>

#include "support/test.hpp"

using namespace nipref;
using data::SymmetryAxis;
using data::TransverselyIsotropicSolid;
using fast::Direction;
using fast::LineResponse;
using fast::TransverselyIsotropicHalfSpace;

namespace {

using Real = boost::multiprecision::mpfr_float_100;

constexpr double rounding = std::numeric_limits<double>::epsilon();
constexpr double degree = std::numbers::pi / 180;

// In Pa; the seed's constants are in GPa.
const double unit_speed = std::sqrt(1e9 * data::seed::steel.shear / data::seed::steel.density);

constexpr TransverselyIsotropicSolid graphite_epoxy{
    1e9 * data::seed::graphite_epoxy.c11, 1e9 * data::seed::graphite_epoxy.c33,
    1e9 * data::seed::graphite_epoxy.c13, 1e9 * data::seed::graphite_epoxy.c44,
    1e9 * data::seed::graphite_epoxy.c66, data::seed::graphite_epoxy.density};

TransverselyIsotropicSolid random_solid(std::mt19937_64& generator) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto factor = [&](double octaves) { return std::exp2(octaves * (unit(generator) - 0.5)); };
  TransverselyIsotropicSolid solid{};
  solid.density = factor(2);
  solid.c44 = factor(4);
  solid.c66 = factor(4);
  solid.c11 = solid.c66 * (1 + factor(4));
  solid.c33 = solid.c11 * factor(5);
  solid.c13 = (2 * unit(generator) - 1) * 0.99 * std::sqrt((solid.c11 - solid.c66) * solid.c33);
  return solid;
}

Direction random_direction(std::mt19937_64& generator) {
  return Direction::of_angle(std::uniform_real_distribution<double>(-4, 4)(generator));
}

/// The exact stiffness. With a normal axis it is that of the sagittal plane, which determines the normal response.
ref::ExactStiffness exactly(const TransverselyIsotropicSolid& solid, SymmetryAxis axis) {
  return axis == SymmetryAxis::normal ? ref::sagittal_stiffness(solid) : ref::exact_stiffness(solid, axis);
}

ref::SurfaceDirection ref_direction(double degrees) {
  return ref::SurfaceDirection::of_degrees(ref::Exact(degrees));
}

bool near(double value, double expected, double scale, double tolerance) {
  return std::fabs(value - expected) <= tolerance * std::fabs(scale);
}

}  // namespace

TEST_CASE("directions in degrees have two words, and none near 90 loses digits") {
  for (const double degrees : {0.0, 1e-9, -30.0, 44.9, 45.1, 60.0, 89.999999999, 90.0, -135.5, 270.0, 1e6}) {
    CAPTURE(degrees);
    const Direction psi = Direction::of_degrees(degrees);
    const Real angle = Real(degrees) * boost::math::constants::pi<Real>() / 180;
    const auto close = [](double high, double low, const Real& truth) {
      CHECK(abs(Real(high) + low - truth) <= 1e-30 * abs(truth) + 1e-95);
    };
    close(psi.cosine, psi.cosine_low, cos(angle));
    close(psi.sine, psi.sine_low, sin(angle));
    const Direction back = Direction::of_degrees(-degrees).turned(psi);
    CHECK(std::fabs(back.sine + back.sine_low) < 1e-31);
    CHECK(std::fabs(back.cosine - 1 + back.cosine_low) < 1e-31);
  }
  CHECK_THROWS_AS(Direction::of_degrees(not_a_number), data::BadInput);
}

TEST_CASE("transversely isotropic half-space: the response is smooth where A6 = 0 and M with it") {
  // A6 = c44 sin^2 - density speed^2 cos^2 is zero, up to rounding errors.
  const TransverselyIsotropicSolid solid{32, 350, 14, 16, 8, 1};
  const Direction psi{12.0 / 13, 5.0 / 13}, motion{1, 0};
  const double speed = 4 * psi.sine / psi.cosine;
  const auto response = [&](double at) {
    return TransverselyIsotropicHalfSpace(solid, SymmetryAxis::in_plane, motion, at).along(psi);
  };
  const LineResponse here = response(speed);
  for (const double step : {1e-15, 1e-12, 1e-9, 1e-6}) {
    const LineResponse below = response(speed * (1 - step)), above = response(speed * (1 + step));
    CHECK(near((below.compliance + above.compliance) / 2, here.compliance, here.compliance,
               2 * rounding + 10 * step * step));
    CHECK(near((below.coupling + above.coupling) / 2, here.coupling, here.compliance,
               2 * rounding + 10 * step * step));
    CHECK(near(below.compliance, above.compliance, here.compliance, 4 * rounding + 10 * step));
  }
}

TEST_CASE("critical speed: at it the first line is critical, and below it none is") {
  std::mt19937_64 generator(11);
  for (const SymmetryAxis axis : {SymmetryAxis::normal, SymmetryAxis::in_plane}) {
    for (int sample = 0; sample < 6; ++sample) {
      const TransverselyIsotropicSolid solid = random_solid(generator);
      const double theta = std::uniform_real_distribution<double>(-200, 200)(generator);
      const Direction motion = Direction::of_degrees(theta);
      const auto [speed, psi] = fast::critical_speed(solid, axis, motion);
      const auto check_line = [&](double share) {
        ref::check_subcritical(exactly(solid, axis), ref::Exact(share * speed), ref_direction(theta),
                               ref_direction(psi / degree));
      };
      CHECK_NOTHROW(check_line(1 - 1e-6));
      CHECK_THROWS_AS(check_line(1 + 1e-6), data::BadInput);

      const TransverselyIsotropicHalfSpace surface(solid, axis, motion, (1 - 1e-9) * speed);
      for (int line = 0; line < 20; ++line) {
        const Direction other = random_direction(generator);
        CHECK(fast::rayleigh_speed(solid, axis, motion, other) >= speed * (1 - 4 * rounding));
        const LineResponse response = surface.along(other);
        CHECK(response.compliance > 0);
        CHECK(std::isfinite(response.compliance));
        CHECK(std::isfinite(response.coupling));
      }
    }
  }
}

TEST_CASE("critical speed: it is found in valleys of two bottoms and in those narrower than a degree") {
  const auto check = [](const TransverselyIsotropicSolid& solid, double theta, double shallow_psi) {
    const Direction motion = Direction::of_degrees(theta);
    const double speed = fast::critical_speed(solid, SymmetryAxis::in_plane, motion).speed;
    const auto truth =
        ref::critical_speed(ref::exact_stiffness(solid, SymmetryAxis::in_plane), ref_direction(theta), 17);
    CHECK(std::fabs(truth.speed.error_of(speed)) <= 4 * rounding * speed);
    // In the direction in which a coarser search ends, the speed is higher.
    CHECK(fast::rayleigh_speed(solid, SymmetryAxis::in_plane, motion, Direction::of_degrees(shallow_psi)) >
          (1 + 1e-10) * speed);
  };
  // Two minima 0.03 degrees from the axis, on both sides of a maximum.
  check({8732.615966221072, 5.206161640027693, -186.282880027052, 1.252853292229777, 96.63621997752217,
         1218.5079266280632},
        90, 90);
  // The motion is a little to one side. The minimum on this side is the lower one.
  check({220132.35025845337, 7092.6140465015633, -22778.492806939132, 6.5980425342776119, 24.175487831893292,
         1.7000442657209416},
        90.00029295089729, 89.86824728);
  // A minimum 0.3 degrees wide and 6 degrees off the axis, where a surface wave passes from one bulk wave to another.
  check({639.57693616129563, 0.2194159096995234, 6.9861913661117745, 43.742275887327871, 2.7515726557945337,
         2.1816122195484344},
        90, 90);
  // A minimum 2e-3 degrees off the isotropic plane, which no line shows that is a degree from the plane.
  check({39.245, 11.428, 17, 1633.193, 0.013, 1}, 75.8, 17.889);
}

TEST_CASE("critical speed: it is refused where moduli are too far apart for lines or the search of them") {
  const auto critical = [](const TransverselyIsotropicSolid& solid) {
    return fast::critical_speed(solid, SymmetryAxis::in_plane, Direction::of_degrees(50));
  };
  CHECK_REFUSED(critical({1, 1, 0, 1e7, 1e-3, 1}), "to search its lines");
  CHECK_REFUSED(critical({1, 1, 0, 1e13, 0.5, 1}),
                "the condition number of its matrix must be at most 1e+12");
  CHECK_NOTHROW((void)critical({1, 1, 0, 1e3, 1e-1, 1}));
  CHECK_THROWS_AS((void)fast::rayleigh_speed({1, 1, 0, 1e13, 0.5, 1}, SymmetryAxis::normal, {1, 0}, {1, 0}),
                  data::BadInput);
}

TEST_CASE("transversely isotropic half-space: just below the critical speed an answer is large or refused") {
  std::mt19937_64 generator(12);
  for (const SymmetryAxis axis : {SymmetryAxis::normal, SymmetryAxis::in_plane}) {
    const TransverselyIsotropicSolid solid = random_solid(generator);
    const Direction motion = random_direction(generator);
    const fast::CriticalSpeed limit = fast::critical_speed(solid, axis, motion);
    const TransverselyIsotropicHalfSpace last(solid, axis, motion, std::nextafter(limit.speed, 0));
    double found = 0;
    const bool refused = refusal_of([&] {
                           return found = last.condition(Direction::of_angle(limit.psi));
                         }).starts_with("speed = ");
    CHECK(refused != (found > 1e3));
  }
}

TEST_CASE("half-spaces refuse what they cannot answer") {
  CHECK_REFUSED(fast::isotropic_response({1, 0.3, 1}, not_a_number, {1, 0}), "speed = nan");
  CHECK_REFUSED(fast::isotropic_response({1, 0.3, 1}, 0.1, {not_a_number, 0}), "psi = (nan, 0)");
  CHECK_THROWS_AS(fast::isotropic_rayleigh_speed(not_a_number), data::BadInput);

  const Direction motion = Direction::of_angle(45 * degree);
  const auto surface = [&](Direction along, double speed) {
    return TransverselyIsotropicHalfSpace(graphite_epoxy, SymmetryAxis::in_plane, along, speed * unit_speed);
  };
  CHECK_NOTHROW((void)surface(motion, 0.498));
  CHECK_REFUSED(surface(motion, not_a_number), "speed = nan");
  CHECK_REFUSED(surface({1, 1}, 0.1), "motion = (1, 1)");
  CHECK_REFUSED(surface({not_a_number, 1}, 0.1), "motion = ");
  const TransverselyIsotropicHalfSpace good(graphite_epoxy, SymmetryAxis::normal, motion, 0.1 * unit_speed);
  CHECK_REFUSED(good.along({not_a_number, 0}), "psi = ");
}
