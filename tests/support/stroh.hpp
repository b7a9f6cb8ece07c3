#pragma once
#include <array>
#include <boost/multiprecision/mpc.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <vector>

#include <nipref/ref/half_space/stiffness.hpp>

// A second route to the surface response: Stroh's eigenvectors from the roots of his sextic, 80 digits,
// unproven, for solids whose roots are distinct.

namespace stroh {

using Float = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<80>,
                                            boost::multiprecision::et_off>;
using Complex = boost::multiprecision::number<boost::multiprecision::mpc_complex_backend<80>,
                                              boost::multiprecision::et_off>;
template <class Scalar>
using Square = std::array<std::array<Scalar, 3>, 3>;
using Polynomial = std::vector<Float>;

inline Float to_float(const mpq_class& x) {
  Float value;
  mpfr_set_q(value.backend().data(), x.get_mpq_t(), MPFR_RNDN);
  return value;
}

inline Polynomial times(const Polynomial& x, const Polynomial& y) {
  Polynomial result(x.size() + y.size() - 1, Float(0));
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t k = 0; k < y.size(); ++k) result[i + k] += x[i] * y[k];
  }
  return result;
}

inline void add(Polynomial& sum, const Polynomial& x, int sign) {
  sum.resize(std::max(sum.size(), x.size()), Float(0));
  for (std::size_t i = 0; i < x.size(); ++i) sum[i] += sign * x[i];
}

/// All roots at once, by Durand and Kerner.
inline std::vector<Complex> roots_of(const Polynomial& p) {
  const std::size_t degree = p.size() - 1;
  std::vector<Complex> roots;
  for (std::size_t k = 0; k < degree; ++k) roots.push_back(pow(Complex(Float("0.4"), Float("0.9")), int(k)));
  for (int step = 0; step < 500; ++step) {
    Float largest = 0;
    for (std::size_t i = 0; i < degree; ++i) {
      Complex value = p[degree];
      for (std::size_t k = degree; k-- > 0;) value = value * roots[i] + p[k];
      Complex product = p[degree];
      for (std::size_t k = 0; k < degree; ++k) {
        if (k != i) product *= roots[i] - roots[k];
      }
      const Complex change = value / product;
      roots[i] -= change;
      largest = std::max<Float>(largest, abs(change) / (1 + abs(roots[i])));
    }
    if (largest < Float("1e-72")) break;
  }
  return roots;
}

inline std::array<Complex, 3> cross(const std::array<Complex, 3>& x, const std::array<Complex, 3>& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

inline Complex dot(const std::array<Complex, 3>& x, const std::array<Complex, 3>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

inline Float size(const std::array<Complex, 3>& x) { return abs(x[0]) + abs(x[1]) + abs(x[2]); }

/// Y, the inverse of the impedance, in the axes (n, across, 3); n = (cosine, sine) need not be normalised.
inline Square<Complex> admittance(const nipref::ref::ExactStiffness& solid, const Float& phase_speed,
                                  Float cosine, Float sine) {
  constexpr std::size_t voigt[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
  const Float norm = sqrt(cosine * cosine + sine * sine);
  cosine /= norm;
  sine /= norm;
  // Tensor in the rotated axes, so that n = e1.
  const Square<Float> axes{{{cosine, sine, 0}, {-sine, cosine, 0}, {0, 0, 1}}};
  std::array<std::array<Float, 6>, 6> given;
  for (std::size_t a = 0; a < 6; ++a) {
    for (std::size_t b = 0; b < 6; ++b) given[a][b] = to_float(solid.voigt[a][b]);
  }
  const auto c = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
    Float sum = 0;
    for (std::size_t n = 0; n < 81; ++n) {
      const std::size_t p = n / 27, q = n / 9 % 3, r = n / 3 % 3, s = n % 3;
      const Float weight = axes[i][p] * axes[j][q] * axes[k][r] * axes[l][s];
      if (weight != 0) sum += weight * given[voigt[p][q]][voigt[r][s]];
    }
    return sum;
  };
  Square<Float> r, t;
  Square<Polynomial> p;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      r[i][k] = c(i, 0, k, 2);
      t[i][k] = c(i, 2, k, 2);
      const Float inertia = i == k ? Float(to_float(solid.density) * phase_speed * phase_speed) : Float(0);
      p[i][k] = {c(i, 0, k, 0) - inertia, r[i][k] + c(i, 2, k, 0), t[i][k]};
    }
  }
  Polynomial sextic;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    add(sextic, times(p[0][k], times(p[1][l], p[2][m])), 1);
    add(sextic, times(p[0][k], times(p[1][m], p[2][l])), -1);
  }
  std::array<std::array<Complex, 3>, 3> a, b;  // one vector for each root
  std::size_t count = 0;
  for (const Complex& s : roots_of(sextic)) {
    if (s.imag() < 0 || count == 3) continue;
    std::array<std::array<Complex, 3>, 3> rows;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) rows[i][k] = p[i][k][0] + s * (p[i][k][1] + s * p[i][k][2]);
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
      for (std::size_t k = 0; k < 3; ++k) {
        y[i][k] += Complex(Float(0), Float(1)) * a[n][i] * inverse[k] / determinant;
      }
    }
  }
  return y;
}

}  // namespace stroh
