#pragma once
#include <array>

#include <nipref/verify/golden/confirm/rational.hpp>

/// The surface response of anisotropic half-spaces by Stroh's formalism: eigenvectors from the roots of the sextic
/// polynomial. It is for solids whose roots are distinct and has no proven error.
namespace nipref::verify::confirm {

template <unsigned digits>
class Stroh {
 public:
  using Float = Number<digits>;
  using Complex = ComplexNumber<digits>;
  using Voigt = std::array<std::array<Float, 6>, 6>;
  template <class Scalar>
  using Square = std::array<std::array<Scalar, 3>, 3>;

  /// Y, the inverse of the impedance, in the axes (n, across, 3); n = (cosine, sine) need not be normalised.
  static Square<Complex> admittance(const Voigt& stiffness, const Float& density, const Float& phase_speed,
                                    Float cosine, Float sine) {
    constexpr std::size_t voigt[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
    const Float norm = sqrt(cosine * cosine + sine * sine);
    cosine /= norm;
    sine /= norm;
    // The stiffness in rotated axes with n = e1.
    const Square<Float> axes{{{cosine, sine, 0}, {-sine, cosine, 0}, {0, 0, 1}}};
    const auto c = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
      Float sum = 0;
      for (std::size_t n = 0; n < 81; ++n) {
        const std::size_t p = n / 27, q = n / 9 % 3, r = n / 3 % 3, s = n % 3;
        const Float& modulus = stiffness[voigt[p][q]][voigt[r][s]];
        if (modulus == 0 || axes[i][p] == 0 || axes[j][q] == 0 || axes[k][r] == 0 || axes[l][s] == 0)
          continue;
        sum += axes[i][p] * axes[j][q] * axes[k][r] * axes[l][s] * modulus;
      }
      return sum;
    };
    Square<Float> r, t;
    Square<Quadratic> p;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        r[i][k] = c(i, 0, k, 2);
        t[i][k] = c(i, 2, k, 2);
        const Float inertia = i == k ? Float(density * phase_speed * phase_speed) : Float(0);
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
    for (const Complex& s : roots_of<digits>(sextic)) {
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
    const Complex determinant = dot(b[0], cross(b[1], b[2]));
    Square<Complex> y;
    for (auto& row : y) row.fill(Complex(0));
    for (std::size_t n = 0; n < 3; ++n) {
      const auto inverse = cross(b[(n + 1) % 3], b[(n + 2) % 3]);
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k)
          y[i][k] += Complex(Float(0), Float(1)) * a[n][i] * inverse[k] / determinant;
      }
    }
    return y;
  }

 private:
  using Quadratic = Polynomial<Float>;
  using Column = std::array<Complex, 3>;

  static Column cross(const Column& x, const Column& y) {
    return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
  }
  static Complex dot(const Column& x, const Column& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }
  static Float size(const Column& x) { return abs(x[0]) + abs(x[1]) + abs(x[2]); }
};

/// A half-space by its stiffness in Voigt's notation and its density.
template <unsigned digits>
struct StrohSolid {
  using Float = Number<digits>;

  typename Stroh<digits>::Voigt voigt;
  Float density;

  /// Y for lines at psi with the phase speed `phase`, in the axes (n, across, 3).
  [[nodiscard]] auto admittance(const Float& psi_degrees, const Float& phase) const {
    const Float psi = psi_degrees * pi<Float>() / 180;
    return Stroh<digits>::admittance(voigt, density, phase, cos(psi), sin(psi));
  }
};

template <unsigned digits>
Number<digits> cosine_between(const Number<digits>& psi_degrees, const Number<digits>& theta_degrees) {
  return sin((90 - abs(Number<digits>(psi_degrees - theta_degrees))) * pi<Number<digits>>() / 180);
}

/// The speed at which 1/K vanishes along psi, by the secant rule from a double near it.
template <unsigned digits>
Number<digits> surface_wave(const StrohSolid<digits>& solid, const Number<digits>& psi,
                            const Number<digits>& theta, double near) {
  using Float = Number<digits>;
  const Float cosine = abs(cosine_between<digits>(psi, theta));
  const auto inverse = [&](const Float& speed) -> Float {
    return 1 / solid.admittance(psi, speed * cosine)[2][2].real();
  };
  Float last = near, speed = near * Float("0.9999999999999"), last_value = inverse(last);
  const Float settled = pow(Float(10), 30 - static_cast<int>(digits));
  for (int step = 0; step < 20; ++step) {
    const Float value = inverse(speed), change = value * (speed - last) / (value - last_value);
    last = speed;
    last_value = value;
    speed -= change;
    if (abs(change) < settled * speed) break;
  }
  return speed;
}

using Speed = Number<130>;

inline Confirmation by_secant(const Speed& value) {
  return confirmation<Speed>("root of 1/K by Stroh's eigenproblem", value, value * Speed("1e-70"));
}

/// The minimum of this speed over all lines, by Newton's iteration for a zero of its slope, from a nearby line and
/// speed.
inline Confirmation lowest_surface_wave(const StrohSolid<130>& solid, double near_psi, double theta,
                                        double near_speed) {
  Speed psi = near_psi, value = 0;
  const Speed step("1e-22");
  for (int k = 0; k < 5; ++k) {
    const auto at = [&](const Speed& degrees) {
      return surface_wave<130>(solid, degrees, Speed(theta), near_speed);
    };
    const Speed above = at(psi + step), below = at(psi - step);
    value = at(psi);
    const Speed change = -step * (above - below) / (2 * (above - 2 * value + below));
    psi += change;
    if (abs(change) < Speed("1e-32")) break;
  }
  return by_secant(value);
}

}  // namespace nipref::verify::confirm
