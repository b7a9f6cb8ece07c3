// Half-spaces of any anisotropy: special solids, turned axes, critical speeds.
#include <nipref/data/material/seed_solids.hpp>
#include <nipref/fast/half_space/anisotropic.hpp>
#include <nipref/fast/half_space/isotropic.hpp>

#include "support/test.hpp"

using namespace nipref;
using fast::AnisotropicHalfSpace;
using fast::Direction;

namespace {

constexpr data::TransverselyIsotropicSolid epoxy = data::seed::graphite_epoxy;

double off(double value, double expected, double size) { return std::fabs(value - expected) / size * 0x1p52; }

/// A solid without any symmetry.
data::Stiffness triclinic() {
  data::Stiffness solid{{}, 2};
  constexpr double upper[] = {20, 7,   6, 1,    -2, 0.5, 31,  8, -1,   1.5, 2,
                              25, 0.7, 1, -1.2, 9,  0.4, 0.9, 7, -0.8, 11};
  data::set_symmetric(solid.voigt, std::begin(upper));
  return solid;
}

}  // namespace

TEST_CASE("anisotropic half-space: isotropic moduli, whose roots are equal, answer isotropically") {
  const data::IsotropicSolid solid{2, 0.25, 3};  // Lame's constants are doubles
  const double limit = std::sqrt(2. / 3) * fast::isotropic_rayleigh_speed(0.25);
  for (const double share : {0.0, 0.5, 0.99, 1 - 1e-6}) {
    const double speed = share * limit;
    const Direction motion = Direction::of_degrees(20);
    const AnisotropicHalfSpace surface(data::Stiffness::of(solid), motion, speed);
    for (const double degrees : {0.0, 3.0, 40.0, 90.0}) {
      const Direction from_motion = Direction::of_degrees(degrees), psi = from_motion.turned(motion);
      const fast::LineResponse found = surface.along(psi),
                               right = fast::isotropic_response(solid, speed, from_motion);
      const auto [in_line, across] = surface.shear_along(psi);
      const auto [right_in_line, right_across] = fast::isotropic_shear_response(solid, speed, from_motion);
      CHECK(off(found.compliance, right.compliance, right.compliance) < 8);
      CHECK(off(found.coupling, right.coupling, right.compliance) < 8);
      CHECK(off(in_line, right_in_line, right_in_line) < 8);
      CHECK(off(across, right_across, right_across) < 8);
      for (const double none : {found.coupling_across, found.shear_compliance, found.shear_compliance_across})
        CHECK(std::fabs(none) < 1e-15 * right.compliance);
    }
  }
}

TEST_CASE("anisotropic half-space: no line is faster than the one that is critical first") {
  const Direction motion = Direction::of_degrees(-30);
  const auto critical = fast::critical_speed(triclinic(), motion);
  for (int degrees = -120; degrees <= 59; degrees += 3)
    CHECK(fast::rayleigh_speed(triclinic(), motion, Direction::of_degrees(degrees)) >= critical.speed);
  const Direction psi = Direction::of_angle(critical.psi);
  CHECK(AnisotropicHalfSpace(triclinic(), motion, (1 - 1e-9) * critical.speed).along(psi).compliance > 0);
  CHECK_THROWS_AS((void)AnisotropicHalfSpace(triclinic(), motion, (1 + 1e-9) * critical.speed).along(psi),
                  data::BadInput);
}

TEST_CASE("anisotropic half-spaces refuse what they cannot answer") {
  data::Stiffness indefinite = triclinic();
  indefinite.voigt[0][1] = indefinite.voigt[1][0] = 40;
  CHECK_THROWS_AS(AnisotropicHalfSpace(indefinite, {1, 0}, 0), data::BadInput);
  CHECK_THROWS_AS(AnisotropicHalfSpace(triclinic(), {1, 1}, 0), data::BadInput);
  CHECK_THROWS_AS(AnisotropicHalfSpace(triclinic(), {1, 0}, not_a_number), data::BadInput);
  CHECK_THROWS_AS(AnisotropicHalfSpace(triclinic(), {1, 0}, -1), data::BadInput);
  CHECK_THROWS_AS((void)AnisotropicHalfSpace(triclinic(), {1, 0}, 1).along({1, 1}), data::BadInput);
  CHECK_THROWS_AS((void)fast::critical_speed(indefinite, {1, 0}), data::BadInput);
}
