#include <nipref/fast/half_space/anisotropic.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/golden/confirm/half_space.hpp>
#include <nipref/verify/golden/confirm/rational.hpp>

namespace nipref::verify::confirm {
namespace {

// The surface response of anisotropic half-spaces by Stroh's formalism: eigenvectors from the roots of the sextic
// polynomial. The method applies to solids whose roots are distinct. Its error is not proven.

using Quadratic = PolynomialOf<Float>;
using Column = std::array<Complex, 3>;

Column cross(const Column& x, const Column& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}
Complex dot(const Column& x, const Column& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }
Float size(const Column& x) { return abs(x[0]) + abs(x[1]) + abs(x[2]); }

/// A half-space, given by its stiffness in Voigt's notation and its density.
struct StrohSolid {
  std::array<std::array<Float, 6>, 6> voigt;
  Float density;

  /// Y, the inverse of the impedance, for the line n at the angle psi and a phase speed, in the axes (n, across, 3).
  [[nodiscard]] std::array<std::array<Complex, 3>, 3> admittance(const Float& psi_degrees,
                                                                 const Float& phase) const;
};

Float cosine_between(const Float& psi_degrees, const Float& theta_degrees) {
  return cosine_of(psi_degrees - theta_degrees);
}

std::array<std::array<Complex, 3>, 3> StrohSolid::admittance(const Float& psi_degrees,
                                                             const Float& phase) const {
  constexpr std::size_t place[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
  const Float psi = radians(psi_degrees), cosine = cos(psi), sine = sin(psi);
  // The stiffness in rotated axes with n = e1.
  const Float axes[3][3] = {{cosine, sine, 0}, {-sine, cosine, 0}, {0, 0, 1}};
  const auto c = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
    Float sum = 0;
    for (std::size_t n = 0; n < 81; ++n) {
      const std::size_t p = n / 27, q = n / 9 % 3, r = n / 3 % 3, s = n % 3;
      const Float& modulus = voigt[place[p][q]][place[r][s]];
      if (modulus == 0 || axes[i][p] == 0 || axes[j][q] == 0 || axes[k][r] == 0 || axes[l][s] == 0) continue;
      sum += axes[i][p] * axes[j][q] * axes[k][r] * axes[l][s] * modulus;
    }
    return sum;
  };
  Float r[3][3], t[3][3];
  Quadratic p[3][3];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      r[i][k] = c(i, 0, k, 2);
      t[i][k] = c(i, 2, k, 2);
      const Float inertia = i == k ? Float(density * phase * phase) : Float(0);
      p[i][k] = {Float(c(i, 0, k, 0) - inertia), Float(r[i][k] + c(i, 2, k, 0)), t[i][k]};
    }
  }
  Quadratic sextic;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    sextic += p[0][k] * (p[1][l] * p[2][m] - p[1][m] * p[2][l]);
  }
  std::array<Column, 3> a, b;  // one vector for each root
  std::size_t count = 0;
  for (const Complex& s : roots_of<150>(sextic)) {
    if (s.imag() < 0 || count == 3) continue;
    std::array<Column, 3> rows;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) rows[i][k] = value_at(p[i][k], s);
    a[count] = cross(rows[0], rows[1]);
    for (const auto& other : {cross(rows[1], rows[2]), cross(rows[2], rows[0])})
      if (size(other) > size(a[count])) a[count] = other;
    for (std::size_t i = 0; i < 3; ++i) {
      b[count][i] = 0;
      for (std::size_t k = 0; k < 3; ++k) b[count][i] += (r[k][i] + s * t[i][k]) * a[count][k];
    }
    ++count;
  }
  // Y = i A B^{-1}; the rows of B^{-1} are cross products of the columns of B.
  const Complex determinant = dot(b[0], cross(b[1], b[2])), unit(Float(0), Float(1));
  std::array<std::array<Complex, 3>, 3> y;
  for (auto& row : y) row.fill(Complex(0));
  for (std::size_t n = 0; n < 3; ++n) {
    const Column inverse = cross(b[(n + 1) % 3], b[(n + 2) % 3]);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) y[i][k] += unit * a[n][i] * inverse[k] / determinant;
  }
  return y;
}

/// Returns the speed at which 1/K vanishes for the line psi, by the secant method. `near` is that speed in double.
Float surface_wave(const StrohSolid& solid, const Float& psi, const Float& theta, double near) {
  const Float cosine = abs(cosine_between(psi, theta));
  const auto inverse = [&](const Float& speed) -> Float {
    return 1 / solid.admittance(psi, speed * cosine)[2][2].real();
  };
  Float last = near, speed = near * Float("0.9999999999999"), last_value = inverse(last);
  for (int step = 0; step < 20; ++step) {
    const Float value = inverse(speed), change = value * (speed - last) / (value - last_value);
    last = speed;
    last_value = value;
    speed -= change;
    if (abs(change) < Float("1e-120") * speed) break;
  }
  return speed;
}

Confirmation by_secant(const Float& value) {
  return confirmation("root of 1/K by Stroh's eigenproblem", value, value * Float("1e-70"));
}

/// The line with the smallest critical speed: its angle in degrees, right to about 1e-7, and this speed.
struct CriticalLine {
  double psi, speed;
};

/// Returns the minimum of the critical speed over all lines, by Newton's iteration for a zero of its slope from `near`.
Confirmation lowest_surface_wave(const StrohSolid& solid, double theta, const CriticalLine& near) {
  Float psi = near.psi, value = 0;
  const Float step("1e-22");
  for (int k = 0; k < 5; ++k) {
    const auto at = [&](const Float& degrees) {
      return surface_wave(solid, degrees, Float(theta), near.speed);
    };
    const Float above = at(psi + step), below = at(psi - step);
    value = at(psi);
    const Float change = -step * (above - below) / (2 * (above - 2 * value + below));
    psi += change;
    if (abs(change) < Float("1e-32")) break;
  }
  return by_secant(value);
}

/// The transversely isotropic solid in units of the shear modulus and density of the seed's steel, exact decimals.
StrohSolid transverse_solid(Arguments x) {
  const auto axis = x["axis"] < 0.5 ? data::SymmetryAxis::normal : data::SymmetryAxis::in_plane;
  const Float shear("77.2"), c11 = x["c11"] / shear, c33 = x["c33"] / shear, c13 = x["c13"] / shear,
                             c44 = x["c44"] / shear;
  // With a normal axis c66 affects only the waves polarised across the lines, which are decoupled from the others.
  const Float c66 = axis == data::SymmetryAxis::normal ? c11 : Float(x["c66"] / shear);
  StrohSolid solid{{}, Float(x["density"]) / 7860};
  data::set_transversely_isotropic(solid.voigt, axis, c11, c33, c13, c44, c66);
  return solid;
}

/// The solid whose stiffness is in the arguments from c11 on: the upper triangle of Voigt's matrix, row by row.
StrohSolid any_solid(Arguments x) {
  StrohSolid solid{{}, x["density"]};
  data::set_symmetric(solid.voigt, x.from("c11").begin());
  return solid;
}

Confirmation by_stroh(const Float& value, const Float& scale) {
  return confirmation("Stroh's eigenproblem", value, abs(scale) * Float("1e-80"));
}

enum class Part { re, minus_im };

/// Returns the method that computes an entry of Y for the solid of the arguments.
Confirm entry_of(StrohSolid (*solid)(Arguments), std::size_t row, std::size_t column, Part part) {
  return [=](Arguments x) {
    const Float phase = Float(x["speed"]) * cosine_between(x["psi_deg"], x["theta_deg"]);
    const auto y = solid(x).admittance(x["psi_deg"], phase);
    const Float value(part == Part::re ? Float(y[row][column].real()) : Float(-y[row][column].imag()));
    return by_stroh(value, std::max({abs(Float(y[0][0].real())), abs(Float(y[1][1].real())),
                                     abs(Float(y[2][2].real()))}));
  };
}

Confirmation condition(Arguments x) {
  const StrohSolid solid = transverse_solid(x);
  const Float speed = Float(x["speed"]) * cosine_between(x["psi_deg"], x["theta_deg"]);
  return condition_by_difference("Stroh's eigenproblem", [&](const Float& factor) -> Float {
    return solid.admittance(x["psi_deg"], factor * speed)[2][2].real();
  });
}

Confirmation rayleigh(Arguments x) {
  const double near = find_quantity("ti.rayleigh").by_fast(x.from("theta_deg"), {});
  return by_secant(surface_wave(transverse_solid(x), x["psi_deg"], x["theta_deg"], near));
}

CriticalLine critical_line(Arguments x) {
  const auto found =
      fast::critical_speed({x["c11"], x["c33"], x["c13"], x["c44"], x["c66"], x["density"]},
                           x["axis"] < 0.5 ? data::SymmetryAxis::normal : data::SymmetryAxis::in_plane,
                           fast::Direction::of_degrees(x["theta_deg"]));
  return {found.psi * 180 / std::numbers::pi, found.speed * std::sqrt(7860 / 77.2)};
}

Confirmation critical_of_any(Arguments x) {
  data::Stiffness solid{{}, x["density"]};
  data::set_symmetric(solid.voigt, x.from("c11").begin());
  const auto near = fast::critical_speed(solid, fast::Direction::of_degrees(x["theta_deg"]));
  return lowest_surface_wave(any_solid(x), x["theta_deg"], {near.psi * 180 / std::numbers::pi, near.speed});
}

/// The speed of a bulk wave along theta: its square times the density is an eigenvalue of Christoffel's matrix.
Confirmation branch(Arguments x) {
  const Float cosine = cosine_of(x["theta_deg"]), sine = sine_of(x["theta_deg"]), cc = cosine * cosine,
              ss = sine * sine;
  const Float c11 = x["c11"], c33 = x["c33"], c13 = x["c13"], c44 = x["c44"], c66 = x["c66"],
              density = x["density"];
  const Float g11 = c11 * cc + c44 * ss, g22 = c44 * cc + c33 * ss, g12 = (c13 + c44) * cosine * sine;
  const Float root = sqrt((g11 - g22) * (g11 - g22) + 4 * g12 * g12);
  const Float larger = (g11 + g22 + root) / 2;
  const Float modulus = x["which"] == 0   ? Float(c66 * cc + c44 * ss)
                        : x["which"] == 1 ? larger
                                          : Float((g11 * g22 - g12 * g12) / larger);
  const Float speed = sqrt(modulus / density * 7860 / Float("77.2"));
  return confirmation("eigenvalue in closed form", speed, speed * Float("1e-80"));
}

/// The response of the solid and of a steel sphere together.
LineAnswers joint_answers(Arguments x) {
  return [solid = transverse_solid(x), x](const Float& degrees) -> LineAnswerByFormula {
    const Float speed = x["speed"] * cosine_of(degrees), along = x["patch"] * speed;
    const auto y = solid.admittance(degrees + x["theta_deg"], speed);
    const LineAnswerByFormula steel = isotropic_answer(Float("0.29529"), along * along);
    return {Float(y[2][2].real()) + steel.compliance, Float(-y[2][0].imag()) - steel.coupling,
            Float(-y[2][1].imag()), 0};
  };
}
SlidingBody sphere(Arguments x) { return {joint_answers(x), x["friction"]}; }

/// Lines on panels about the line with the smallest critical speed, where K may have a peak.
std::vector<WeightedLine> lines_about_critical(Arguments x, bool coarse) {
  const CriticalLine critical = critical_line(x);
  const double width = 0.3 * std::min(1.0, std::sqrt(std::max(1e-9, 1 - x["speed"] / critical.speed)));
  return lines_about(Float(critical.psi) - x["theta_deg"], width, 0.3, coarse);
}

Float sphere_axis_ratio(Arguments x, bool coarse) {
  return exp(-ContactEllipse(joint_answers(x), lines_about_critical(x, coarse), 1).eta);
}

Float sphere_force(Arguments x, bool coarse) { return sphere(x).force(lines_about_critical(x, coarse)); }

}  // namespace

Methods anisotropic_methods() {
  return {{"ti.compliance", entry_of(transverse_solid, 2, 2, Part::re)},
          {"ti.coupling", entry_of(transverse_solid, 2, 0, Part::minus_im)},
          {"ti.coupling_across", entry_of(transverse_solid, 2, 1, Part::minus_im)},
          {"ti.condition", condition},
          {"ti.rayleigh", rayleigh},
          {"ti.branch", branch},
          {"ti.critical",
           [](Arguments x) {
             return lowest_surface_wave(transverse_solid(x), x["theta_deg"], critical_line(x));
           }},
          {"ti.span_ratio",
           [](Arguments x) {
             const Float ratio = sphere(x).span_ratio(x["phi_deg"]);
             return by_stroh(ratio, ratio);
           }},
          {"ti.axis_ratio", by_gauss_rule(sphere_axis_ratio)},
          {"ti.exponent", [](Arguments x) { return by_stroh(-sphere(x).line(x["phi_deg"]).ahead, 1); }},
          {"ti.force", by_gauss_rule(sphere_force)},
          {"anisotropic.compliance", entry_of(any_solid, 2, 2, Part::re)},
          {"anisotropic.coupling", entry_of(any_solid, 2, 0, Part::minus_im)},
          {"anisotropic.coupling_across", entry_of(any_solid, 2, 1, Part::minus_im)},
          {"anisotropic.shear_compliance", entry_of(any_solid, 2, 0, Part::re)},
          {"anisotropic.shear_compliance_across", entry_of(any_solid, 2, 1, Part::re)},
          {"anisotropic.in_line", entry_of(any_solid, 0, 0, Part::re)},
          {"anisotropic.across", entry_of(any_solid, 1, 1, Part::re)},
          {"anisotropic.critical", critical_of_any}};
}

}  // namespace nipref::verify::confirm
