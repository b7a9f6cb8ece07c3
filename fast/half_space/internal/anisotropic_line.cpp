#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/internal/anisotropic_line.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast::internal {
namespace {

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

Square<Two, 3> block(const data::Stiffness::Voigt& voigt, std::size_t j, std::size_t l, double unit) {
  constexpr std::size_t index[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
  return matrix_of<Two>(
      [&](std::size_t i, std::size_t k) { return Two{voigt[index[i][j]][index[k][l]] * unit}; });
}

/// C_i1k2 + C_i2k1
Square<Two, 3> mixed_block(const data::Stiffness::Voigt& voigt, double unit) {
  const Square<Two, 3> c12 = block(voigt, 0, 1, unit), c21 = block(voigt, 1, 0, unit);
  return matrix_of<Two>([&](std::size_t i, std::size_t k) { return c12[i][k] + c21[i][k]; });
}

}  // namespace

void check_moduli(const data::Stiffness& solid) {
  constexpr double farthest = 1e12;
  // The matrix is symmetric, so that it may be read by columns.
  if (condition_number(Eigen::Map<const Eigen::Matrix<double, 6, 6>>(solid.voigt.front().data())) <= farthest)
    return;
  throw data::BadInput(
      "solid", "(as given)",
      fmt::format(
          "must have moduli nearer to each other: the condition number of its matrix must be at most {:g}",
          farthest));
}

AnisotropicLine::AnisotropicLine(const data::Stiffness& solid)
    : inverse_unit_(1 / std::scalbn(1.0, std::ilogb(solid.voigt[2][2]))),
      density_(solid.density * inverse_unit_),
      c11_(block(solid.voigt, 0, 0, inverse_unit_)),
      c12_(mixed_block(solid.voigt, inverse_unit_)),
      c22_(block(solid.voigt, 1, 1, inverse_unit_)),
      c13_(block(solid.voigt, 0, 2, inverse_unit_)),
      c23_(block(solid.voigt, 1, 2, inverse_unit_)),
      t_inverse_(inverse(block(solid.voigt, 2, 2, inverse_unit_))) {}

StrohBlocks AnisotropicLine::blocks(Direction psi) const {
  const Two length2 = squared_length(psi), length = sqrt(length2);
  const Two c = cosine_of(psi), s = sine_of(psi);
  const Two cc = square(c) / length2, ss = square(s) / length2, cs = c * s / length2;
  const Two c1 = c / length, s1 = s / length;
  return {matrix_of<Two>([&](std::size_t i, std::size_t k) {
            return cc * c11_[i][k] + cs * c12_[i][k] + ss * c22_[i][k];
          }),
          matrix_of<Two>([&](std::size_t i, std::size_t k) { return c1 * c13_[i][k] + s1 * c23_[i][k]; }),
          t_inverse_};
}

std::optional<AnisotropicAnswers> AnisotropicLine::at(Direction psi, const Motion& motion) const {
  const Two length2 = squared_length(psi), length = sqrt(length2);
  const auto m = impedance(blocks(psi), stress_density(density_, psi, motion) / length2);
  if (!m) return std::nullopt;
  const Two determinant = m->determinant();
  if (!(determinant.high > 0)) return std::nullopt;
  const Two c = cosine_of(psi) / length, s = sine_of(psi) / length;
  const auto answer = [&](Two minor) { return minor.high / determinant.high * inverse_unit_; };
  const auto y31 = m->adjugate(2, 0), y32 = m->adjugate(2, 1);
  const Two y11 = m->adjugate(0, 0).re, y22 = m->adjugate(1, 1).re, y12 = m->adjugate(0, 1).re;
  const Two turned = twice(c * s * y12), cc = square(c), ss = square(s);
  return AnisotropicAnswers{
      {answer(m->adjugate(2, 2).re), answer(-(c * y31.im + s * y32.im)), answer(-(c * y32.im - s * y31.im)),
       answer(c * y31.re + s * y32.re), answer(c * y32.re - s * y31.re)},
      {answer(cc * y11 + ss * y22 + turned), answer(ss * y11 + cc * y22 - turned)}};
}

// G = T^-1 (M + i R^T), as the traction of the wave on planes of depth is -k M u = -(T G - i R^T) k u.
std::optional<Square<std::complex<double>, 3>> AnisotropicLine::decay(Direction psi,
                                                                      const Motion& motion) const {
  const StrohBlocks line = blocks(psi);
  const auto m = impedance(line, stress_density(density_, psi, motion) / squared_length(psi));
  if (!m) return std::nullopt;
  const double c = psi.cosine, s = psi.sine;
  const Square<double, 3> axes{{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}};
  Square<std::complex<double>, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      Two re{}, im{};
      for (std::size_t j = 0; j < 3; ++j) {
        re = re + line.t_inverse[i][j] * m->re[j][k];
        im = im + line.t_inverse[i][j] * (m->im[j][k] + line.r[k][j]);
      }
      for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
          result[row][column] += axes[row][i] * axes[column][k] * std::complex(re.high, im.high);
    }
  }
  return result;
}

double AnisotropicLine::wave_bound(Direction psi) const {
  const double cc = psi.cosine * psi.cosine, ss = psi.sine * psi.sine, cs = psi.cosine * psi.sine;
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k)
      sum += std::fabs(cc * c11_[i][k].high + cs * c12_[i][k].high + ss * c22_[i][k].high);
    largest = std::max(largest, sum);
  }
  return std::sqrt(largest / density_);
}

double AnisotropicLine::limit(Direction psi) const {
  const Two limit = limit_within(psi, 0x1p-56);
  return limit.low < 0 ? std::nextafter(limit.high, 0) : limit.high;
}

Two AnisotropicLine::limit_in_two_words(Direction psi) const { return limit_within(psi, 0x1p-100); }

// Bisects until a speed between that of the surface wave and the limiting speed is found; if there is none, bisection
// converges to the limiting speed. It starts in double and goes on in two words once the rounding of double matters.
Two AnisotropicLine::limit_within(Direction psi, double share) const {
  const StrohBlocks blocks = this->blocks(psi);
  const Two length = sqrt(squared_length(psi));
  const auto impedance_at = [&](auto speed) { return impedance(blocks, density_ * (speed * speed)); };
  const auto determinant = [&](Two speed) {
    const auto m = impedance_at(speed);
    return m ? m->determinant() : Two{-1};
  };
  const double bound =
      1.001 * std::sqrt(std::min({blocks.q[0][0].high, blocks.q[1][1].high, blocks.q[2][2].high}) / density_);
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
