// Half-spaces of any anisotropy: special solids, turned axes, critical speeds.
#include <nipref/data/material/seed_solids.hpp>
#include <nipref/fast/half_space/anisotropic.hpp>

#include "support/test.hpp"

using namespace nipref;
using fast::AnisotropicHalfSpace;
using fast::Direction;

namespace {

constexpr data::TransverselyIsotropicSolid epoxy = data::seed::graphite_epoxy;

double off(double value, double expected, double size) { return std::fabs(value - expected) / size * 0x1p52; }

/// No symmetry at all.
data::Stiffness triclinic() {
  data::Stiffness solid{{}, 2};
  constexpr double upper[] = {20, 7,   6, 1,    -2, 0.5, 31,  8, -1,   1.5, 2,
                              25, 0.7, 1, -1.2, 9,  0.4, 0.9, 7, -0.8, 11};
  std::size_t at = 0;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = i; k < 6; ++k) solid.voigt[i][k] = solid.voigt[k][i] = upper[at++];
  return solid;
}

/// Its axes x1, x2 turned by an angle.
data::Stiffness turned(const data::Stiffness& solid, double angle) {
  constexpr std::size_t index[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
  const double c = std::cos(angle), s = std::sin(angle);
  const double axes[3][3] = {{c, -s, 0}, {s, c, 0}, {0, 0, 1}};
  data::Stiffness result{{}, solid.density};
  for (std::size_t m = 0; m < 6; ++m) {
    for (std::size_t n = 0; n <= m; ++n) {
      std::size_t i = 0, j = 0, k = 0, l = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = a; b < 3; ++b) {
          if (index[a][b] == m) i = a, j = b;
          if (index[a][b] == n) k = a, l = b;
        }
      }
      double sum = 0;
      for (std::size_t p = 0; p < 81; ++p) {
        const std::size_t p1 = p / 27, p2 = p / 9 % 3, p3 = p / 3 % 3, p4 = p % 3;
        sum +=
            axes[i][p1] * axes[j][p2] * axes[k][p3] * axes[l][p4] * solid.voigt[index[p1][p2]][index[p3][p4]];
      }
      result.voigt[m][n] = result.voigt[n][m] = sum;
    }
  }
  return result;
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

TEST_CASE("anisotropic half-space: an axis of symmetry in the surface, by the closed form") {
  const data::Stiffness solid = data::Stiffness::of(epoxy, data::SymmetryAxis::in_plane);
  const Direction motion = Direction::of_degrees(45);
  const auto critical = fast::critical_speed(epoxy, data::SymmetryAxis::in_plane, motion);
  const auto found = fast::critical_speed(solid, motion);
  // c12 of the matrix is rounded, that of the closed form is not.
  CHECK(off(found.speed, critical.speed, critical.speed) < 16);
  CHECK(found.psi == doctest::Approx(critical.psi).epsilon(1e-6));
  const double speed = 0.999 * critical.speed;
  const fast::TransverselyIsotropicHalfSpace closed(epoxy, data::SymmetryAxis::in_plane, motion, speed);
  const AnisotropicHalfSpace any(solid, motion, speed);
  for (const double degrees : {-80.0, -20.0, 0.0, 24.56, 45.0, 90.0}) {
    const Direction psi = Direction::of_degrees(degrees);
    const fast::LineResponse right = closed.along(psi), answers = any.along(psi);
    CHECK(off(answers.compliance, right.compliance, right.compliance) < 5000);
    CHECK(off(answers.coupling, right.coupling, right.compliance) < 5000);
    CHECK(off(answers.coupling_across, right.coupling_across, right.compliance) < 5000);
  }
}

TEST_CASE(
    "anisotropic half-space: a solid that is turned answers as it did, turned, and opposite lines are the same") {
  const double angle = 0.7, speed = 1;
  const Direction motion = Direction::of_angle(0.2), turned_motion = Direction::of_angle(0.2 + angle);
  const AnisotropicHalfSpace before(triclinic(), motion, speed),
      after(turned(triclinic(), angle), turned_motion, speed);
  for (const double psi : {-1.5, -0.4, 0.0, 0.9}) {
    const auto line = before.along(Direction::of_angle(psi)),
               same = after.along(Direction::of_angle(psi + angle));
    CHECK(same.compliance == approx(line.compliance, 1e-13));
    CHECK(same.coupling == doctest::Approx(line.coupling).epsilon(1e-14));
    CHECK(same.coupling_across == doctest::Approx(line.coupling_across).epsilon(1e-14));
    CHECK(same.shear_compliance == doctest::Approx(line.shear_compliance).epsilon(1e-14));
    CHECK(same.shear_compliance_across == doctest::Approx(line.shear_compliance_across).epsilon(1e-14));
    CHECK(std::fabs(line.shear_compliance) > 1e-4);
    const auto back = before.along(Direction::of_angle(psi + std::acos(-1.)));
    CHECK(back.coupling == doctest::Approx(line.coupling).epsilon(1e-14));
    CHECK(back.shear_compliance == doctest::Approx(-line.shear_compliance).epsilon(1e-14));
  }
  CHECK(fast::critical_speed(turned(triclinic(), angle), turned_motion).speed ==
        approx(fast::critical_speed(triclinic(), motion).speed, 1e-13));
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
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  data::Stiffness indefinite = triclinic();
  indefinite.voigt[0][1] = indefinite.voigt[1][0] = 40;
  CHECK_THROWS_AS(AnisotropicHalfSpace(indefinite, {1, 0}, 0), data::BadInput);
  CHECK_THROWS_AS(AnisotropicHalfSpace(triclinic(), {1, 1}, 0), data::BadInput);
  CHECK_THROWS_AS(AnisotropicHalfSpace(triclinic(), {1, 0}, nan), data::BadInput);
  CHECK_THROWS_AS(AnisotropicHalfSpace(triclinic(), {1, 0}, -1), data::BadInput);
  CHECK_THROWS_AS((void)AnisotropicHalfSpace(triclinic(), {1, 0}, 1).along({1, 1}), data::BadInput);
  CHECK_THROWS_AS((void)fast::critical_speed(indefinite, {1, 0}), data::BadInput);
}
