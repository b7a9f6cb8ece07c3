#include <nipref/verify/golden/confirm/stroh.hpp>

namespace nipref::verify::confirm {
namespace {

using Quadratic = PolynomialOf<Float>;
using Column = std::array<Complex, 3>;

Column cross(const Column& x, const Column& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}
Complex dot(const Column& x, const Column& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }
Float size(const Column& x) { return abs(x[0]) + abs(x[1]) + abs(x[2]); }

}  // namespace

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
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) rows[i][k] = value_at(p[i][k], s);
    }
    a[count] = cross(rows[0], rows[1]);
    for (const auto& other : {cross(rows[1], rows[2]), cross(rows[2], rows[0])}) {
      if (size(other) > size(a[count])) a[count] = other;
    }
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
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) y[i][k] += unit * a[n][i] * inverse[k] / determinant;
    }
  }
  return y;
}

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

Confirmation lowest_surface_wave(const StrohSolid& solid, double near_psi, double theta, double near_speed) {
  Float psi = near_psi, value = 0;
  const Float step("1e-22");
  for (int k = 0; k < 5; ++k) {
    const auto at = [&](const Float& degrees) {
      return surface_wave(solid, degrees, Float(theta), near_speed);
    };
    const Float above = at(psi + step), below = at(psi - step);
    value = at(psi);
    const Float change = -step * (above - below) / (2 * (above - 2 * value + below));
    psi += change;
    if (abs(change) < Float("1e-32")) break;
  }
  return by_secant(value);
}

}  // namespace nipref::verify::confirm
