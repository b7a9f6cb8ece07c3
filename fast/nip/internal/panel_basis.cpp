#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <tuple>
#include <vector>

#include <nipref/fast/nip/internal/panel_basis.hpp>
#include <nipref/fast/number/internal/cache.hpp>
#include <nipref/fast/number/internal/chebyshev.hpp>
#include <nipref/fast/number/internal/double_exponential.hpp>

namespace nipref::fast {
namespace {

using Complex = std::complex<double>;
/// Cached numbers are computed in extended precision, so that only their last rounding counts.
using Long = long double;
using LongComplex = std::complex<Long>;

constexpr Long pi = std::numbers::pi_v<Long>, ln2 = std::numbers::ln2_v<Long>;

/// The factor w of a basis, w = size x^left (1 - x)^right.
struct Weight {
  explicit Weight(const PanelBasis& basis)
      : left(basis.at_end ? Complex(0.5, basis.exponent) : 0),
        right(basis.is_whole ? std::conj(left) : 0),
        size(basis.is_whole ? 2 : 1) {}

  Complex left, right;
  double size;

  /// The integrals f_n of w T_n h, n < count, from f_0, h a function of t = 2 x - 1. That of h d/dt[(1 - t^2) w T_n] is
  ///     (left - right) f_n - (left + right + 2 + n) f_(n+1)/2 - (left + right + 2 - n) f_(n-1)/2 = -source(n).
  /// Both homogeneous solutions decay with n.
  template <class Source>
  [[nodiscard]] std::vector<LongComplex> recurrence(LongComplex first, int count,
                                                    const Source& source) const {
    const LongComplex sum = LongComplex(left + right) + Long(2), difference(left - right);
    std::vector<LongComplex> f{first, (difference * first + source(0)) / sum};
    for (int n = 1; n + 1 < count; ++n) {
      const Long degree = n;
      f.push_back((Long(2) * difference * f.end()[-1] - (sum - degree) * f.end()[-2] + Long(2) * source(n)) /
                  (sum + degree));
    }
    return f;
  }
};

/// The integrals over [0, 1] of w T_n, n < count. Of a whole contact the first one is
/// |Gamma(3/2 + i y)|^2 = (1/4 + y^2) pi/cosh(pi y).
std::vector<LongComplex> moments(const PanelBasis& basis, int count) {
  const Weight weight(basis);
  const Long y = basis.exponent;
  const LongComplex total = basis.is_whole ? (0.25L + y * y) * pi / std::cosh(pi * y)
                                           : Long(1) / (LongComplex(weight.left) + Long(1));
  return weight.recurrence(total, count, [](int) { return LongComplex(0); });
}

Complex expm1(Complex z) {
  const double half = std::sin(z.imag() / 2);
  return {std::expm1(z.real()) * std::cos(z.imag()) - 2 * half * half,
          std::exp(z.real()) * std::sin(z.imag())};
}

/// The integrals over [0, 1] of w times ln|x - s|, the sign of x - s, and 1/(x - s) as a principal value.
struct FirstIntegrals {
  LongComplex at_point = 0;  ///< w at s
  LongComplex logarithm = 0, sign = 0, principal;

  FirstIntegrals(const PanelBasis& basis, double point) {
    const Weight weight(basis);
    const Long s = point, log_left = std::log(s), log_right = std::log1p(-s);
    if (s > 0)
      at_point = static_cast<Long>(weight.size) *
                 std::exp(LongComplex(weight.left) * log_left + LongComplex(weight.right) * log_right);
    principal = at_point * (log_right - log_left);
    if (basis.exponent != 0)
      integrate(weight, point);
    else if (basis.is_whole)
      of_circle(2 * s - 1);
    else if (basis.at_end)
      of_root(s, log_right);
    else
      of_one(s, log_left, log_right);
  }

 private:
  void of_one(Long s, Long log_left, Long log_right) {
    logarithm = s * log_left + (1 - s) * log_right - 1;
    sign = 1 - 2 * s;
  }
  void of_root(Long s, Long log_right) {
    const Long root = std::sqrt(s);
    principal = 2 - 2 * root * std::atanh(root);
    logarithm = (log_right - Long(2) / 3 - s * principal) * (Long(2) / 3);
    sign = (1 - 2 * s * root) * (Long(2) / 3);
  }
  void of_circle(Long t) {
    principal = -pi * t;
    logarithm = pi / 4 * (t * t - 0.5L - 2 * ln2);
    sign = -(t * std::sqrt(1 - t * t) + std::asin(t)) / 2;
  }
  /// Integrates over [0, s] and over [s, 1]. For the principal value w is replaced by w - w(s); that of w(s) is known.
  void integrate(const Weight& weight, double s) {
    static const std::vector<UnitNode> rule = double_exponential_rule(1e-17);
    const auto log_of_part = [](double part, double rest) {
      return part < 0.5 ? std::log(part) : std::log1p(-rest);
    };
    for (const UnitNode& node : rule) {
      add(node.weight * s, -s * node.from_right,
          expm1(weight.left * log_of_part(node.from_left, node.from_right) +
                weight.right * std::log1p(s * node.from_right / (1 - s))));
      add(node.weight * (1 - s), (1 - s) * node.from_left,
          expm1(weight.left * std::log1p((1 - s) * node.from_left / s) +
                weight.right * log_of_part(node.from_right, node.from_left)));
    }
  }
  void add(double weight, double distance, Complex relative_change) {
    const LongComplex change = at_point * LongComplex(relative_change);
    const LongComplex value = static_cast<Long>(weight) * (at_point + change);
    logarithm += static_cast<Long>(std::log(std::fabs(distance))) * value;
    sign += std::copysign(Long(1), distance) * value;
    principal += static_cast<Long>(weight / distance) * change;
  }
};

/// The integrals over [0, 1] of w T_n times ln|x - s| and times the sign of x - s, n < degrees.
struct PointIntegrals {
  std::vector<LongComplex> logarithm, sign;

  PointIntegrals(const PanelBasis& basis, double s, int degrees) {
    const Weight weight(basis);
    const FirstIntegrals first(basis, s);
    const std::vector<LongComplex> moment = moments(basis, degrees + 2);
    const Long t = 2 * static_cast<Long>(s) - 1, end_factor = 4 * static_cast<Long>(s) * (1 - s);  // 1 - t^2
    // The integrals of w T_n/(2 x - 1 - t), by T_(n+1) = 2 (2 x - 1) T_n - T_(n-1).
    std::vector<LongComplex> principal{first.principal / Long(2), t * first.principal / Long(2) + moment[0]};
    std::vector<Long> chebyshev{1, t};
    for (std::size_t n = 1; principal.size() < static_cast<std::size_t>(degrees); ++n) {
      principal.push_back(2 * t * principal[n] - principal[n - 1] + Long(2) * moment[n]);
      chebyshev.push_back(2 * t * chebyshev[n] - chebyshev[n - 1]);
    }
    const auto of_logarithm = [&](int degree) {
      const auto n = static_cast<std::size_t>(degree);
      return end_factor * principal[n] - (moment[n + 1] + moment[n == 0 ? 1 : n - 1]) / Long(2) -
             t * moment[n];
    };
    const auto of_sign = [&](int degree) {
      return end_factor * chebyshev[static_cast<std::size_t>(degree)] * first.at_point;
    };
    // ln|x - s| = ln|2 x - 1 - t| - ln 2
    logarithm = weight.recurrence(first.logarithm + ln2 * moment[0], degrees, of_logarithm);
    sign = weight.recurrence(first.sign, degrees, of_sign);
    for (std::size_t n = 0; n < logarithm.size(); ++n) logarithm[n] -= ln2 * moment[n];
  }
};

Eigen::ArrayXd nodes_of_rule(int points) {
  return Eigen::ArrayXd::NullaryExpr(points, [&](Eigen::Index number) {
    return internal::shifted_chebyshev_zero(points - 1 - static_cast<int>(number), points);
  });
}

ProductRule make_product_rule(const std::tuple<PanelBasis, int, int, RuleFor>& key) {
  const auto& [basis, points, degrees, integrand] = key;
  const int count = degrees + points;
  const std::vector<LongComplex> moment = integrand == RuleFor::times_logarithm
                                              ? PointIntegrals(basis, 0, count).logarithm
                                              : moments(basis, count);
  std::vector<double> cosines;
  for (int k = 0; k < 4 * points; ++k)
    cosines.push_back(static_cast<double>(std::cos(k * pi / (2 * points))));
  Eigen::MatrixXd coefficients(points, points);  // of T_m in the interpolating polynomial of f, per f(at_i)
  for (int i = 0; i < points; ++i) {
    for (int m = 0; m < points; ++m)
      coefficients(i, m) =
          (m == 0 ? 1.0 : 2.0) / points * cosines[static_cast<std::size_t>(m * (2 * i + 1) % (4 * points))];
  }
  Eigen::MatrixXd real(points, degrees), imaginary(points, degrees);
  for (int n = 0; n < degrees; ++n) {
    for (int m = 0; m < points; ++m) {
      const LongComplex product =
          moment[static_cast<std::size_t>(n + m)] + moment[static_cast<std::size_t>(std::abs(n - m))];
      real(m, n) = static_cast<double>(product.real() / 2);
      imaginary(m, n) = static_cast<double>(product.imag() / 2);
    }
  }
  ProductRule rule;
  rule.at = nodes_of_rule(points);
  rule.weight.real = coefficients * real;
  if (basis.exponent != 0) rule.weight.imaginary = coefficients * imaginary;
  return rule;
}

SingularIntegrals make_singular_integrals(const std::tuple<PanelBasis, MatchingPoints, int>& key) {
  const auto& [basis, points, degrees] = key;
  const auto set = [&](PanelBasis::Rows& rows, int row, int count, const std::vector<LongComplex>& values) {
    rows.real.conservativeResize(count, degrees);
    if (basis.exponent != 0) rows.imaginary.conservativeResize(count, degrees);
    for (int n = 0; n < degrees; ++n) {
      rows.real(row, n) = static_cast<double>(values[static_cast<std::size_t>(n)].real());
      if (basis.exponent != 0)
        rows.imaginary(row, n) = static_cast<double>(values[static_cast<std::size_t>(n)].imag());
    }
  };
  SingularIntegrals result;
  set(result.one, 0, 1, moments(basis, degrees));
  const auto at = points.at();
  for (int number = 0; number < points.points; ++number) {
    const PointIntegrals here(basis, (*at)(number), degrees);
    set(result.logarithm, number, points.points, here.logarithm);
    set(result.sign, number, points.points, here.sign);
  }
  return result;
}

}  // namespace

PanelBasis::Rows PanelBasis::values(const Eigen::ArrayXd& x, const Eigen::ArrayXd& rest, int degrees) const {
  Rows result;
  Eigen::MatrixXd& polynomials = result.real;
  const Eigen::ArrayXd t = x - rest;
  polynomials.resize(x.size(), std::max(degrees, 2));
  polynomials.col(0).setOnes();
  polynomials.col(1) = t;
  for (int n = 2; n < degrees; ++n)
    polynomials.col(n).array() = 2 * t * polynomials.col(n - 1).array() - polynomials.col(n - 2).array();
  if (!at_end) return result;
  Eigen::ArrayXd factor = is_whole ? (2 * (x * rest).sqrt()).eval() : x.sqrt();
  if (exponent != 0) {
    const Eigen::ArrayXd ratio = is_whole ? (x / rest).eval() : x;
    const Eigen::ArrayXd angle = (ratio > 0).select(exponent * ratio.max(1e-300).log(), 0.0);
    const Eigen::VectorXd sine = factor * angle.sin();  // evaluated once, not for each polynomial
    result.imaginary = sine.asDiagonal() * polynomials;
    factor *= angle.cos();
  }
  polynomials.array().colwise() *= factor;
  return result;
}

std::shared_ptr<const Eigen::ArrayXd> MatchingPoints::at() const {
  static Cache<MatchingPoints, Eigen::ArrayXd> kept([](const MatchingPoints& of) -> Eigen::ArrayXd {
    return Eigen::ArrayXd::NullaryExpr(of.points, [&](Eigen::Index number) {
      return internal::shifted_chebyshev_zero(static_cast<int>(number),
                                              of.about_middle ? 2 * of.points : of.points);
    });
  });
  return kept.at(*this);
}

std::shared_ptr<const Eigen::ArrayXXd> logarithms(int points_of_rule, const MatchingPoints& points) {
  static Cache<std::pair<int, MatchingPoints>, Eigen::ArrayXXd> kept(
      [](const std::pair<int, MatchingPoints>& key) -> Eigen::ArrayXXd {
        const Eigen::ArrayXd nodes = nodes_of_rule(key.first), places = *key.second.at();
        return (nodes.replicate(1, places.size()).rowwise() - places.transpose()).abs().log();
      });
  return kept.at({points_of_rule, points});
}

std::shared_ptr<const ProductRule> product_rule(const PanelBasis& basis, int points, int degrees,
                                                RuleFor integrand) {
  static Cache<std::tuple<PanelBasis, int, int, RuleFor>, ProductRule> rules(make_product_rule, 1024);
  constexpr int step = 32;  // so that few rules are cached
  return rules.at({basis, points, (degrees + step - 1) / step * step, integrand});
}

std::shared_ptr<const SingularIntegrals> singular_integrals(const PanelBasis& basis,
                                                            const MatchingPoints& points, int degrees) {
  static Cache<std::tuple<PanelBasis, MatchingPoints, int>, SingularIntegrals> kept(make_singular_integrals);
  return kept.at({basis, points, std::max(degrees, 2)});
}

}  // namespace nipref::fast
