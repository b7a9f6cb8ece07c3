#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include <nipref/fast/nip/internal/panel_basis.hpp>
#include <nipref/fast/number/internal/cache.hpp>
#include <nipref/fast/number/internal/chebyshev.hpp>
#include <nipref/fast/number/internal/double_exponential.hpp>

namespace nipref::fast {
namespace {

using Complex = std::complex<double>;
/// Recurrences and sums that are kept are made in extended precision, so that only their last rounding counts.
using Long = long double;
using LongComplex = std::complex<Long>;

constexpr double pi = std::numbers::pi;

/// T_first, T_(first + step), ..., a column each, by T_(n + step) = 2 T_step T_n - T_|n - step|.
Eigen::MatrixXd chebyshev(const Eigen::ArrayXd& t, int first, int step, int count) {
  const Eigen::ArrayXd twice = step == 1 ? (2 * t).eval() : (4 * t.square() - 2).eval();
  Eigen::MatrixXd values(t.size(), count);
  if (first == 0)
    values.col(0).setOnes();
  else
    values.col(0) = t;
  if (count > 1)
    values.col(1) = twice * values.col(0).array() - (step == 1 ? t : first == 0 ? (twice / 2).eval() : t);
  for (int k = 2; k < count; ++k)
    values.col(k).array() = twice * values.col(k - 1).array() - values.col(k - 2).array();
  return values;
}

/// (1 + t)^left (1 - t)^right, with t = 2 x - 1, is a basis' factor but for a power of 2: the factor is size x^left (1 - x)^right.
struct Weight {
  explicit Weight(const PanelBasis& basis)
      : left(basis.at_end ? Complex(0.5, basis.exponent) : 0),
        right(basis.at_end && basis.about_middle ? std::conj(left) : 0),
        size(right != 0.0 ? 2 : 1) {}

  Complex left, right;
  double size;

  /// (left - right) f_n - (left + right + 2 + n) f_n+1/2 - (left + right + 2 - n) f_n-1/2 = -g_n is the integral of f_n = w T_n
  /// against the derivative of (1 - t^2) w T_n. From f_0 up to f_count, in place: both solutions of the equation with g = 0 decay.
  template <class Source>
  [[nodiscard]] std::vector<LongComplex> recurrence(LongComplex first, int count,
                                                    const Source& source) const {
    const LongComplex sum = LongComplex(left) + LongComplex(right) + Long(2),
                      difference = LongComplex(left - right);
    std::vector<LongComplex> f{first, (difference * first + source(0)) / sum};
    for (int n = 1; n + 1 < count; ++n) {
      const Long degree = n;
      f.push_back((Long(2) * difference * f.end()[-1] - (sum - degree) * f.end()[-2] + Long(2) * source(n)) /
                  (sum + degree));
    }
    return f;
  }
};

/// int_0^1 of the factor times T_n(2 x - 1), n < count; |Gamma(3/2 + i y)|^2 = (1/4 + y^2) pi/cosh(pi y).
std::vector<LongComplex> moments(const PanelBasis& basis, int count) {
  const Weight weight(basis);
  const Long exponent = basis.exponent, angle = std::numbers::pi_v<Long> * exponent;
  const LongComplex total = weight.right != 0.0
                                ? (0.25L + exponent * exponent) * std::numbers::pi_v<Long> / std::cosh(angle)
                                : Long(1) / (LongComplex(weight.left) + Long(1));
  return weight.recurrence(total, count, [](int) { return LongComplex(0); });
}

/// The degree of a function of the basis, and the sign of its polynomial as one of 2 x - 1.
struct Degree {
  int degree;
  double sign;
};

Degree degree_of(const PanelBasis& basis, bool odd, int k) {
  if (!basis.about_middle) return {k, 1};
  return {2 * k + (odd ? 1 : 0), odd ? -1.0 : 1.0};
}

ProductRule make_product_rule(const std::pair<PanelBasis, int>& key) {
  const auto& [basis, count] = key;
  const int highest = degree_of(basis, true, basis.count - 1).degree + count;
  const std::vector<LongComplex> moment = moments(basis, highest + 1);
  using LongMatrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;
  Eigen::Array<Long, Eigen::Dynamic, 1> angle(count);
  for (int i = 0; i < count; ++i) angle(i) = (2 * i + 1) * std::numbers::pi_v<Long> / (2 * count);
  // Of T_m, with which a function's values at the points are summed to its coefficients.
  LongMatrix interpolation(count, count);
  for (int m = 0; m < count; ++m)
    interpolation.col(m) = static_cast<Long>(m == 0 ? 1 : 2) / count * (m * angle).cos();
  const auto weights = [&](bool odd, bool imaginary) {
    LongMatrix products(count, basis.count);
    for (int k = 0; k < basis.count; ++k) {
      const auto [degree, sign] = degree_of(basis, odd, k);
      for (int m = 0; m < count; ++m) {
        const LongComplex product = static_cast<Long>(sign) / 2 *
                                    (moment[static_cast<std::size_t>(degree + m)] +
                                     moment[static_cast<std::size_t>(std::abs(degree - m))]);
        products(m, k) = imaginary ? product.imag() : product.real();
      }
    }
    return (interpolation * products).cast<double>().eval();
  };
  ProductRule rule;
  rule.at = (angle / 2).cos().square().cast<double>();
  const bool twisted = basis.at_end && basis.exponent != 0;
  rule.weight.even_real = weights(false, false);
  if (twisted) rule.weight.even_imaginary = weights(false, true);
  if (basis.is_complex) rule.weight.odd_real = weights(true, false);
  if (basis.is_complex && twisted) rule.weight.odd_imaginary = weights(true, true);
  return rule;
}

Complex expm1(Complex z) {
  const double half = std::sin(z.imag() / 2);
  return {std::expm1(z.real()) * std::cos(z.imag()) - 2 * half * half,
          std::exp(z.real()) * std::sin(z.imag())};
}

/// Integrals over [0, 1] of the factor times ln|x - s|, the sign of x - s, and 1/(x - s) as a principal value.
struct FirstIntegrals {
  LongComplex at_point;  ///< the factor at s
  LongComplex logarithm = 0, sign = 0, principal;

  FirstIntegrals(const Weight& weight, double s) {
    static const std::vector<UnitNode> rule = double_exponential_rule(1e-18);
    const Long log_left = std::log(static_cast<Long>(s)), log_right = std::log1p(-static_cast<Long>(s));
    at_point = static_cast<Long>(weight.size) *
               std::exp(LongComplex(weight.left) * log_left + LongComplex(weight.right) * log_right);
    principal = at_point * (log_right - log_left);
    for (const UnitNode& node : rule) {
      // Of x between 0 and s, and between s and 1.
      add(node.weight * s, -s * node.from_right,
          expm1(weight.left * log_of_part(node.from_left, node.from_right) +
                weight.right * std::log1p(s * node.from_right / (1 - s))));
      add(node.weight * (1 - s), (1 - s) * node.from_left,
          expm1(weight.left * std::log1p((1 - s) * node.from_left / s) +
                weight.right * log_of_part(node.from_right, node.from_left)));
    }
  }

 private:
  static double log_of_part(double part, double rest) {
    return part < 0.5 ? std::log(part) : std::log1p(-rest);
  }
  void add(double weight, double distance, Complex relative_change) {
    const LongComplex change = at_point * LongComplex(relative_change);
    const LongComplex value = static_cast<Long>(weight) * (at_point + change);
    logarithm += static_cast<Long>(std::log(std::fabs(distance))) * value;
    sign += std::copysign(Long(1), distance) * value;
    principal += static_cast<Long>(weight / distance) * change;
  }
};

/// Of T_n(2 x - 1), n < count, from the first ones.
struct SingularMoments {
  std::vector<LongComplex> logarithm, sign;

  SingularMoments(const PanelBasis& basis, double s, int count) {
    constexpr Long ln2 = std::numbers::ln2_v<Long>;
    const Weight weight(basis);
    const FirstIntegrals first(weight, s);
    const std::vector<LongComplex> moment = moments(basis, count + 2);
    const Long t = 2 * static_cast<Long>(s) - 1, end_factor = 4 * static_cast<Long>(s) * (1 - s);  // 1 - t^2
    const LongComplex half_principal = first.principal / Long(2);
    std::vector<LongComplex> principal{half_principal, t * half_principal + moment[0]};
    for (std::size_t n = 1; principal.size() < static_cast<std::size_t>(count); ++n)
      principal.push_back(2 * t * principal[n] - principal[n - 1] + Long(2) * moment[n]);
    const auto of_logarithm = [&](int degree) {
      const auto n = static_cast<std::size_t>(degree);
      return end_factor * principal[n] - (moment[n + 1] + moment[n == 0 ? 1 : n - 1]) / Long(2) -
             t * moment[n];
    };
    const auto of_sign = [&](int degree) {
      return end_factor * std::cos(degree * std::acos(t)) * first.at_point;
    };
    // ln|x - s| = ln|2 x - 1 - t| - ln 2
    logarithm = weight.recurrence(first.logarithm + ln2 * moment[0], count, of_logarithm);
    sign = weight.recurrence(first.sign, count, of_sign);
    for (std::size_t n = 0; n < logarithm.size(); ++n) logarithm[n] -= ln2 * moment[n];
  }
};

SingularIntegrals make_singular_integrals(const std::pair<PanelBasis, int>& key) {
  const auto& [basis, points] = key;
  const int degrees = std::max(degree_of(basis, true, basis.count - 1).degree + 1, 2);
  const auto fill = [&](PanelBasis::Rows& rows, int row, int count, const std::vector<LongComplex>& values) {
    const auto set = [&](Eigen::MatrixXd& part, bool odd, bool imaginary) {
      part.conservativeResize(count, basis.count);
      for (int k = 0; k < basis.count; ++k) {
        const auto [degree, sign] = degree_of(basis, odd, k);
        const LongComplex& value = values[static_cast<std::size_t>(degree)];
        part(row, k) = sign * static_cast<double>(imaginary ? value.imag() : value.real());
      }
    };
    const bool twisted = basis.at_end && basis.exponent != 0;
    set(rows.even_real, false, false);
    if (twisted) set(rows.even_imaginary, false, true);
    if (basis.is_complex) set(rows.odd_real, true, false);
    if (basis.is_complex && twisted) set(rows.odd_imaginary, true, true);
  };
  SingularIntegrals result;
  fill(result.one, 0, 1, moments(basis, degrees));
  for (int number = 0; number < points; ++number) {
    const SingularMoments here(basis, matching_point(basis, number, points), degrees);
    fill(result.logarithm, number, points, here.logarithm);
    fill(result.sign, number, points, here.sign);
  }
  return result;
}

}  // namespace

PanelBasis::Rows PanelBasis::values(const Eigen::ArrayXd& x, const Eigen::ArrayXd& rest) const {
  Rows result;
  Eigen::MatrixXd even, odd;
  if (about_middle) {
    const Eigen::ArrayXd t = rest - x;
    even = chebyshev(t, 0, 2, count);
    if (is_complex) odd = chebyshev(t, 1, 2, count);
  } else {
    even = chebyshev(2 * x - 1, 0, 1, count);
  }
  const Eigen::MatrixXd& odd_polynomials = about_middle ? odd : even;
  if (!at_end) {
    result.even_real = even;
    if (is_complex) result.odd_real = odd_polynomials;
    return result;
  }
  Eigen::ArrayXd factor = about_middle ? (2 * (x * rest).sqrt()).eval() : x.sqrt();
  if (exponent != 0) {
    const Eigen::ArrayXd ratio = about_middle ? (x / rest).eval() : x;
    const Eigen::ArrayXd angle = (ratio > 0).select(exponent * ratio.max(1e-300).log(), 0.0);
    const Eigen::ArrayXd imaginary = factor * angle.sin();
    factor *= angle.cos();
    result.even_imaginary = imaginary.matrix().asDiagonal() * even;
    if (is_complex) result.odd_imaginary = imaginary.matrix().asDiagonal() * odd_polynomials;
  }
  result.even_real = factor.matrix().asDiagonal() * even;
  if (is_complex) result.odd_real = factor.matrix().asDiagonal() * odd_polynomials;
  return result;
}

double matching_point(const PanelBasis& basis, int number, int points) {
  return internal::shifted_chebyshev_zero(number, basis.about_middle ? 2 * points : points);
}

std::shared_ptr<const ProductRule> product_rule(const PanelBasis& basis, int count) {
  static Cache<std::pair<PanelBasis, int>, ProductRule> rules(make_product_rule, 4096);
  return rules.at({basis, count});
}

std::shared_ptr<const SingularIntegrals> singular_integrals(const PanelBasis& basis, int points) {
  static Cache<std::pair<PanelBasis, int>, SingularIntegrals> kept(make_singular_integrals);
  return kept.at({basis, points});
}

}  // namespace nipref::fast
