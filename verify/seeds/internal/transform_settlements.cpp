#include <cmath>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/verify/seeds/internal/settled_row.hpp>
#include <nipref/verify/seeds/internal/settlements.hpp>

namespace nipref::verify {
namespace {

/// C11 over the sphere's shear modulus, as sections 3 and 4 print it.
Settlement scaled_modulus() {
  const Propagated right = data::seed::graphite_epoxy.c11 / Propagated(data::seed::steel.shear);
  return {"d1 = 13.9 GPa/77.2 GPa", Propagated::exact(0.1803), right, 13.9 / Propagated(77.2)};
}

/// A solid whose axis lies along x3, d5 = 3, d6 = 2, in the direction psi = 60 degrees at c_X^2 = 0.5: the motion
/// across the line. Its equation is d5 u'' = omega6^2 u with omega6^2 = d6 - c_X^2; u = e^(-Omega6 x3).
Settlement transverse_root() {
  const Propagated d5 = 3, d6 = 2, cx2 = 0.5, omega6_squared = d6 - cx2;
  // Its acoustic tensor from the shear of both planes: stiffness C_ijkl m_i n_j m_k n_l with m across the line n.
  const Propagated c = 0.5, s = sqrt(0.75);
  const Propagated in_plane = d6 * square(c * c - s * s) + 4 * d6 * square(c * s);
  const Propagated through = d5 * (c * c + s * s);
  return {"Omega6^2, d5 = 3, d6 = 2, c_X^2 = 0.5", -omega6_squared, -omega6_squared / d5,
          -(in_plane - cx2) / through};
}

/// The sphere of (14b) at c_X0 = 0.5 with p = 2: M0 grows like p^3 and N0 like p, or (14b) would not be of the dimension
/// 1/p. What the isotropic half-space answers by ref is their truth.
struct SphereAtTwo {
  static inline const Propagated d = 4, cx2 = 0.25, p = 2;  // c_D^2 at nu = 1/3
  static constexpr const char* place = ", c_D = 2, c_X0 = 0.5, p = 2";
  Propagated a = sqrt(1 - cx2 / d), b = sqrt(1 - cx2);
  SettledRow compliance{"halfspace.compliance",
                        {{"poisson", "0.3333333333333333333333333"}, {"speed", "0.5"}}};
  SettledRow coupling{"halfspace.coupling", {{"poisson", "0.3333333333333333333333333"}, {"speed", "0.5"}}};

  /// From K of (25b).
  [[nodiscard]] Propagated m() const { return p * p * p * d * a * (a + b) / compliance.by_ref; }
};

Settlement sphere_determinant() {
  const SphereAtTwo sphere;
  const Propagated p = SphereAtTwo::p, d = SphereAtTwo::d;
  const auto m = [&](const Propagated& power) {
    return 4 * (d - 1) * sphere.b * power - d * (sphere.a + sphere.b) * SphereAtTwo::cx2 * p * p * p;
  };
  return {std::string("M0 of (14c)") + SphereAtTwo::place, m(p), m(p * p * p), sphere.m()};
}

Settlement sphere_coupling() {
  const SphereAtTwo sphere;
  const Propagated p = SphereAtTwo::p, d = SphereAtTwo::d;
  const Propagated n = d * sphere.a + (2 - d) * sphere.b;
  // S = p N0/M0
  const Propagated truth = sphere.coupling.by_ref * sphere.m() / (p * p);
  return {std::string("N0 of (20a)") + SphereAtTwo::place, n * p * p, n * p, truth};
}

/// 4 omega_D omega - T^2 with P = 1, of which (B.7a) is another form.
Settlement isotropic_rayleigh_function() {
  const Propagated d = 4, cx2 = 0.25;
  const Propagated dilatation = sqrt(1 - cx2 / d), shear = sqrt(1 - cx2);
  const auto factored = [&](const Propagated& share) {
    return (dilatation - shear) / (d - 1) *
           (shear * (d * d * square(dilatation) - share) - dilatation * d * cx2);
  };
  return {"(B.7a), c_D = 2, c_X0 = 0.5, P = 1", factored(square(d - 1)), factored(square(d - 2)),
          4 * dilatation * shear - square(2 - cx2)};
}

/// The solid of section 4 in round numbers, its axis along x2, on the line at psi = 60 degrees at c_X^2 = 0.25.
struct InPlaneLine {
  static inline const Propagated d1 = 3, d2 = 10, d5 = 1, d6 = 2, d12 = 0.5, d13 = d1 - 2 * d5, cx2 = 0.25;
  static constexpr const char* place =
      ", d1 = 3, d2 = 10, d5 = 1, d6 = 2, d12 = 0.5, c_X^2 = 0.25, psi = 60 degrees";
  Propagated p1 = 0.5, p2 = sqrt(0.75), a6 = d6 * p2 * p2 - cx2, sum = d6 + d12;

  /// P_+ of (41b) with this A6.
  [[nodiscard]] Propagated p_plus(const Propagated& the_a6) const {
    const Propagated a2 = d2 * p2 * p2 - cx2, half = d1 * a2 + d6 * the_a6 - square(sum * p2);
    return half + sqrt(half * half - 4 * d1 * d6 * a2 * the_a6);
  }
  /// Omega_+^2 of (41a).
  [[nodiscard]] Propagated root(const Propagated& the_a6) const {
    return -(p1 * p1 + p_plus(the_a6) / (2 * d1 * d6));
  }

  /// The determinant of (38a) over that of the motion across, at Omega^2 = `square_of`, derivatives by x3 being -Omega.
  [[nodiscard]] Propagated determinant(const Propagated& square_of) const {
    const Propagated x1 = d1 * p1 * p1 + d6 * p2 * p2 - cx2, x2 = d6 * p1 * p1 + d2 * p2 * p2 - cx2,
                     x3 = d5 * p1 * p1 + d6 * p2 * p2 - cx2;
    const Propagated m11 = d5 * square_of + x1, m22 = d6 * square_of + x2, m33 = d1 * square_of + x3;
    const Propagated m12 = sum * p1 * p2, other = d5 + d13;
    // Of the entries with Omega itself only products of two occur.
    return m11 * (m22 * m33 - square(sum * p2) * square_of) -
           m12 * (m12 * m33 - sum * p2 * other * p1 * square_of) +
           other * p1 * square_of * (m12 * sum * p2 - m22 * other * p1);
  }

  // u of (39b) for U_+ = 1, u3 over Omega; u2 from the first of (38a).
  [[nodiscard]] Propagated u1() const { return -sum * p1 * p2; }
  [[nodiscard]] Propagated u2() const {
    return (d5 + (d5 + d13)) * root(a6) + d1 * p1 * p1 + d6 * p2 * p2 - cx2;
  }
  [[nodiscard]] Propagated u3() const { return sum * p2; }
};

std::string in_the_plane(const char* what) { return std::string(what) + InPlaneLine::place; }

Settlement shear_radicand() {
  const InPlaneLine line;
  const Propagated printed = square(line.p2) - InPlaneLine::cx2;
  return {in_the_plane("determinant of (38a) at Omega_+"), line.determinant(line.root(printed)),
          line.determinant(line.root(line.a6)), Propagated::exact(0)};
}

Settlement second_component() {
  const InPlaneLine line;
  const Propagated p = line.p_plus(line.a6);
  return {in_the_plane("U2 of (39b)"), line.a6 - InPlaneLine::d1 * p / 2, line.a6 - p / (2 * InPlaneLine::d6),
          line.u2()};
}

Settlement normal_stress() {
  const InPlaneLine line;
  const Propagated first = line.sum * (line.a6 + 2 * InPlaneLine::d5 * square(line.p1));
  const Propagated root = line.root(line.a6), rest = InPlaneLine::d1 * (root + square(line.p1)) + line.a6;
  const Propagated stress = InPlaneLine::d13 * line.p1 * line.u1() + InPlaneLine::d12 * line.p2 * line.u2() -
                            InPlaneLine::d1 * root * line.u3();
  return {in_the_plane("C3 of (40a)"), first - rest, first - InPlaneLine::d6 * rest, stress / line.p2};
}

Settlement shear_stress() {
  const InPlaneLine line;
  const Propagated d32 =
      line.sum * square(line.p2) - InPlaneLine::d1 * (line.root(line.a6) + square(line.p1)) - line.a6;
  const Propagated stress = InPlaneLine::d6 * (line.p2 * line.u3() - line.u2());
  return {in_the_plane("sigma32/Omega of (39d)"), d32, InPlaneLine::d6 * d32, stress};
}

}  // namespace

Settlements transform_settlements() {
  return {{"brock2013-6a", scaled_modulus},
          {"brock2013-10a", transverse_root},
          {"brock2013-14c", sphere_determinant},
          {"brock2013-20a", sphere_coupling},
          {"brock2013-39b", second_component},
          {"brock2013-39d", shear_stress},
          {"brock2013-40a", normal_stress},
          {"brock2013-41c", shear_radicand},
          {"brock2013-B.7", isotropic_rayleigh_function}};
}

}  // namespace nipref::verify
