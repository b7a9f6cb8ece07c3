#pragma once
#include <Eigen/Core>
#include <compare>
#include <memory>

namespace nipref::fast {

/// The functions that carry the tractions on a panel, without its scale: a factor times polynomials of x = (e - left)/width,
/// 0 <= x <= 1.
///   at the end    x^a T_k(2 x - 1), a = 1/2 + i exponent; the factor is 1 beyond
///   about the middle    T_2k(t) of the even component and T_2k+1(t) of the odd one, t = 1 - 2 x; if the panel is the
///                       whole contact, times 2 x^a (1 - x)^conj(a)
struct PanelBasis {
  bool at_end, about_middle, is_complex;
  double exponent;  ///< the imaginary part
  int count;        ///< functions of each component

  friend auto operator<=>(const PanelBasis&, const PanelBasis&) = default;

  /// A row for each node: the polynomials times the real or imaginary part of the factor. Parts that are 0 are empty, as is
  /// `odd` of real tractions.
  struct Rows {
    Eigen::MatrixXd even_real, even_imaginary, odd_real, odd_imaginary;
  };
  /// `rest` is 1 - x, so that neither end is lost in rounding.
  [[nodiscard]] Rows values(const Eigen::ArrayXd& x, const Eigen::ArrayXd& rest) const;
};

/// Integrals of a basis times a function f that is analytic about the panel: int f phi_k dx = sum_i f(at_i) weight_ik, of the
/// polynomial that interpolates f at `count` Chebyshev points. As the integrals of basis and polynomials are known in
/// closed form, only the interpolation errs, by rho^-count where f is analytic within the ellipse of the sum of half axes
/// rho about [0, 1], that of [-1, 1] scaled.
struct ProductRule {
  Eigen::ArrayXd at;
  PanelBasis::Rows weight;
};
std::shared_ptr<const ProductRule> product_rule(const PanelBasis& basis, int count);

/// Integrals of a basis times what is singular at a panel's own matching points s, the zeros of T_points or, about the
/// middle, half of those of T_2points: ln|x - s| and the sign of x - s, a row for each point. And times 1, one row.
struct SingularIntegrals {
  PanelBasis::Rows logarithm, sign, one;
};
std::shared_ptr<const SingularIntegrals> singular_integrals(const PanelBasis& basis, int points);

/// A matching point of a panel, 0 < x < 1.
double matching_point(const PanelBasis& basis, int number, int points);

}  // namespace nipref::fast
