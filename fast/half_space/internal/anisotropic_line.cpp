#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <nipref/fast/half_space/internal/anisotropic_line.hpp>

namespace nipref::fast::internal {
namespace {

double high_word(double x) { return x; }
double high_word(Two x) { return x.high; }

template <class Number, std::size_t size>
using Square = std::array<std::array<Number, size>, size>;

/// Inverts a matrix in place by Gauss-Jordan elimination with column pivoting. Returns the base-2 logarithm of |det|,
/// or nothing if the determinant is 0 or not a number.
template <class Number, std::size_t size>
std::optional<double> invert(Square<Number, size>& a) {
  std::array<std::size_t, size> swapped{};
  double log2_determinant = 0;
  for (std::size_t k = 0; k < size; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < size; ++i)
      if (std::fabs(high_word(a[i][k])) > std::fabs(high_word(a[pivot][k]))) pivot = i;
    swapped[k] = pivot;
    if (pivot != k) std::swap(a[pivot], a[k]);
    const double magnitude = std::fabs(high_word(a[k][k]));
    if (!(magnitude > 0) || !std::isfinite(magnitude)) return std::nullopt;
    log2_determinant += std::log2(magnitude);
    const Number reciprocal = Number{1} / a[k][k];
    a[k][k] = Number{1};
    for (Number& entry : a[k]) entry = entry * reciprocal;
    for (std::size_t i = 0; i < size; ++i) {
      if (i == k) continue;
      const Number factor = a[i][k];
      a[i][k] = Number{0};
      for (std::size_t j = 0; j < size; ++j) a[i][j] = a[i][j] - factor * a[k][j];
    }
  }
  for (std::size_t k = size; k-- > 0;) {
    if (swapped[k] == k) continue;
    for (auto& row : a) std::swap(row[k], row[swapped[k]]);
  }
  return log2_determinant;
}

/// The matrix sign function, divided by i, of a real matrix without real eigenvalues; nothing if Newton's iteration
/// does not converge.
template <class Number>
std::optional<Square<Number, 6>> sign_of(Square<Number, 6> x) {
  constexpr int most = 80;
  constexpr double converged = 1e-17;  // the iteration is quadratic, and the square is below the rounding of two words
  for (int step = 0; step < most; ++step) {
    Square<Number, 6> inverse = x;
    const auto log2_determinant = invert<Number, 6>(inverse);
    if (!log2_determinant) return std::nullopt;
    // Scaling by powers of two brings the eigenvalues near 1 while they are far from it.
    const double scale = std::exp2(-std::round(*log2_determinant / 6));
    double change = 0, size = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t k = 0; k < 6; ++k) {
        const Number next = (0.5 * scale) * x[i][k] - (0.5 / scale) * inverse[i][k];
        change = std::max(change, std::fabs(high_word(next - x[i][k])));
        size = std::max(size, std::fabs(high_word(next)));
        x[i][k] = next;
      }
    }
    if (!std::isfinite(size)) return std::nullopt;
    // In double, rounding keeps the change above 1e-17.
    if (change <= std::max(converged, 0x1p-42 * (sizeof(Number) == sizeof(double))) * size) return x;
  }
  return std::nullopt;
}

template <class Number>
Number number_of(Two x) {
  if constexpr (sizeof(Number) == sizeof(double)) {
    return x.high;
  } else {
    return x;
  }
}

template <class Number>
Square<Number, 3> product(const Square<Number, 3>& a, const Square<Number, 3>& b) {
  Square<Number, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      result[i][k] = a[i][0] * b[0][k] + a[i][1] * b[1][k] + a[i][2] * b[2][k];
  }
  return result;
}

/// M = P + i W, P symmetric and W antisymmetric.
template <class Number>
struct Impedance {
  Square<Number, 3> re, im;

  struct Complex {
    Number re, im;
  };
  /// Of adj(M), which is Hermitian.
  [[nodiscard]] Complex adjugate(std::size_t i, std::size_t k) const {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
    // The minor without row k and column i.
    return {
        re[k1][i1] * re[k2][i2] - im[k1][i1] * im[k2][i2] - re[k1][i2] * re[k2][i1] + im[k1][i2] * im[k2][i1],
        re[k1][i1] * im[k2][i2] + im[k1][i1] * re[k2][i2] - re[k1][i2] * im[k2][i1] -
            im[k1][i2] * re[k2][i1]};
  }
  [[nodiscard]] Number determinant() const {
    Number sum = re[0][0] * adjugate(0, 0).re;
    for (const std::size_t k : {1UL, 2UL}) {
      const Complex minor = adjugate(k, 0);
      sum = sum + re[0][k] * minor.re - im[0][k] * minor.im;
    }
    return sum;
  }
};

/// The impedance of a line whose X is the stress density; nothing unless the load is slower than the limiting speed.
template <class Number>
std::optional<Impedance<Number>> impedance(const AnisotropicLine::Block& rest,
                                           const AnisotropicLine::Block& coupled,
                                           const AnisotropicLine::Block& t_inverse, Number X) {
  Square<Number, 3> q, r, t;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      q[i][k] = number_of<Number>(rest[i][k]);
      r[i][k] = number_of<Number>(coupled[i][k]);
      t[i][k] = number_of<Number>(t_inverse[i][k]);
    }
    q[i][i] = q[i][i] - X;
  }
  Square<Number, 3> transposed{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) transposed[i][k] = r[k][i];
  const Square<Number, 3> tr = product(t, transposed), rtr = product(r, tr);  // T^-1 R^T, R T^-1 R^T
  Square<Number, 6> n{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      n[i][k] = -tr[i][k];
      n[i][k + 3] = t[i][k];
      n[i + 3][k] = rtr[i][k] - q[i][k];
      n[i + 3][k + 3] = -tr[k][i];
    }
  }
  const auto sign = sign_of<Number>(n);
  if (!sign) return std::nullopt;
  Square<Number, 3> s, h;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      s[i][k] = (*sign)[i][k];
      h[i][k] = (*sign)[i][k + 3];
    }
  }
  if (!invert<Number, 3>(h)) return std::nullopt;
  return Impedance<Number>{h, product(h, s)};
}

/// The root of a decreasing function between low, where it is positive, and high, where it is not, by the Illinois
/// variant of regula falsi.
template <class Function>
Two root_between(const Function& f, Two low, Two high) {
  constexpr int most = 60;
  Two at_low = f(low), at_high = f(high);
  int stayed = 0;
  Two x = low;
  for (int step = 0; step < most; ++step) {
    const Two last = x;
    x = (low * at_high - high * at_low) / (at_high - at_low);
    if (std::fabs((x - last).high) <= 0x1p-100 * high.high) break;
    const Two value = f(x);
    const bool is_below = value.high > 0;
    (is_below ? low : high) = x;
    (is_below ? at_low : at_high) = value;
    stayed = is_below ? std::max(stayed, 0) + 1 : std::min(stayed, 0) - 1;
    if (stayed > 1) at_high = at_high / 2;
    if (stayed < -1) at_low = at_low / 2;
  }
  return x;
}

AnisotropicLine::Block block(const data::Stiffness::Voigt& voigt, std::size_t j, std::size_t l, double unit) {
  constexpr std::size_t index[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
  AnisotropicLine::Block result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) result[i][k] = Two{voigt[index[i][j]][index[k][l]] * unit};
  return result;
}

/// C_i1k2 + C_i2k1
AnisotropicLine::Block mixed_block(const data::Stiffness::Voigt& voigt, double unit) {
  const AnisotropicLine::Block c12 = block(voigt, 0, 1, unit), c21 = block(voigt, 1, 0, unit);
  AnisotropicLine::Block result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) result[i][k] = c12[i][k] + c21[i][k];
  return result;
}

AnisotropicLine::Block inverse(AnisotropicLine::Block matrix) {
  invert<Two, 3>(matrix);
  return matrix;
}

}  // namespace

AnisotropicLine::AnisotropicLine(const data::Stiffness& solid)
    : inverse_unit_(1 / std::scalbn(1.0, std::ilogb(solid.voigt[2][2]))),
      density_(solid.density * inverse_unit_),
      c11_(block(solid.voigt, 0, 0, inverse_unit_)),
      c12_(mixed_block(solid.voigt, inverse_unit_)),
      c22_(block(solid.voigt, 1, 1, inverse_unit_)),
      c13_(block(solid.voigt, 0, 2, inverse_unit_)),
      c23_(block(solid.voigt, 1, 2, inverse_unit_)),
      t_inverse_(inverse(block(solid.voigt, 2, 2, inverse_unit_))) {}

AnisotropicLine::Blocks AnisotropicLine::blocks(Direction psi) const {
  const Two length2 = squared_length(psi), length = sqrt(length2);
  const Two c = cosine_of(psi), s = sine_of(psi);
  const Two cc = square(c) / length2, ss = square(s) / length2, cs = c * s / length2;
  const Two c1 = c / length, s1 = s / length;
  Blocks result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      result.q[i][k] = cc * c11_[i][k] + cs * c12_[i][k] + ss * c22_[i][k];
      result.r[i][k] = c1 * c13_[i][k] + s1 * c23_[i][k];
    }
  }
  return result;
}

std::optional<AnisotropicAnswers> AnisotropicLine::at(Direction psi, const Motion& motion) const {
  const auto [q, r] = blocks(psi);
  const Two length2 = squared_length(psi), length = sqrt(length2);
  const auto m = impedance<Two>(q, r, t_inverse_, stress_density(density_, psi, motion) / length2);
  if (!m) return std::nullopt;
  const Two determinant = m->determinant();
  if (!(determinant.high > 0)) return std::nullopt;
  const Two c = cosine_of(psi) / length, s = sine_of(psi) / length;
  const auto answer = [&](Two minor) { return minor.high / determinant.high * inverse_unit_; };
  const auto y31 = m->adjugate(2, 0), y32 = m->adjugate(2, 1);
  const Two y11 = m->adjugate(0, 0).re, y22 = m->adjugate(1, 1).re, y12 = m->adjugate(0, 1).re;
  const Two turned = twice(c * s * y12), cc = square(c), ss = square(s);
  return AnisotropicAnswers{answer(m->adjugate(2, 2).re),        answer(-(c * y31.im + s * y32.im)),
                            answer(-(c * y32.im - s * y31.im)),  answer(c * y31.re + s * y32.re),
                            answer(c * y32.re - s * y31.re),     answer(cc * y11 + ss * y22 + turned),
                            answer(ss * y11 + cc * y22 - turned)};
}

double AnisotropicLine::limit(Direction psi) const {
  const Two limit = limit_within(psi, 0x1p-56);
  return limit.low < 0 ? std::nextafter(limit.high, 0) : limit.high;
}

Two AnisotropicLine::limit_in_two_words(Direction psi) const { return limit_within(psi, 0x1p-100); }

// Bisection, until a speed between that of the surface wave and the limiting speed is found; if there is no such
// speed, up to the limiting speed. It starts in double and goes on in two words once the rounding of double matters.
Two AnisotropicLine::limit_within(Direction psi, double share) const {
  const auto [q, r] = blocks(psi);
  const Two length = sqrt(squared_length(psi));
  const auto impedance_at = [&]<class Number>(Number speed) {
    return impedance<Number>(q, r, t_inverse_, density_ * (speed * speed));
  };
  const auto determinant = [&](Two speed) {
    const auto m = impedance_at(speed);
    return m ? m->determinant() : Two{-1};
  };
  const double bound = 1.001 * std::sqrt(std::min({q[0][0].high, q[1][1].high, q[2][2].high}) / density_);
  double below = 0, beyond = bound;
  constexpr int coarse = 40;
  for (int step = 0; step < coarse; ++step) {
    const double middle = below + (beyond - below) / 2;
    const auto m = impedance_at(middle);
    const bool is_slow = m && m->determinant() > 0;
    (is_slow ? below : beyond) = middle;
    if (m && !is_slow) break;
  }
  Two low = determinant(Two{below}).high > 0 ? Two{below} : Two{0}, high{bound};
  for (Two middle{beyond}; (high - low).high > share * high.high; middle = low + (high - low) / 2) {
    const auto m = impedance_at(middle);
    const bool is_slow = m && m->determinant().high > 0;
    (is_slow ? low : high) = middle;
    if (m && !is_slow) return length * root_between(determinant, low, high);
  }
  return length * low;
}

}  // namespace nipref::fast::internal
