#pragma once
#include <Eigen/Core>
#include <compare>
#include <memory>

namespace nipref::fast {

/// The functions that carry the tractions on a panel, without its scale: a factor times T_n(2 x - 1), 0 <= x <= 1. With
/// a = 1/2 + i exponent the factor is
///   at the end    x^a, or 2 x^a (1 - x)^conj(a) if the panel is the whole contact
///   elsewhere     1
struct PanelBasis {
  bool at_end, is_whole;
  double exponent;  ///< 0 beyond the end

  friend auto operator<=>(const PanelBasis&, const PanelBasis&) = default;

  /// Real and imaginary parts, a row for each node and a column for each degree n; the imaginary part is empty where it is 0.
  struct Rows {
    Eigen::MatrixXd real, imaginary;
  };
  /// `rest` is 1 - x, so that neither end is lost in rounding.
  [[nodiscard]] Rows values(const Eigen::ArrayXd& x, const Eigen::ArrayXd& rest, int degrees) const;
};

/// What a product rule is for: int f phi_n dx, or int f ln x phi_n dx, this for a basis at the end without exponent.
enum class RuleFor { function, times_logarithm };

/// A rule for the integrals of a function f, analytic about the panel, times a basis: int f phi_n dx = sum_i f(at_i) weight_in.
/// It integrates the polynomial that interpolates f at Chebyshev points, in closed form, so that only the interpolation errs:
/// by rho^-points where f is analytic within the ellipse with foci 0 and 1 whose half axes add up to rho/2.
struct ProductRule {
  Eigen::ArrayXd at;
  PanelBasis::Rows weight;  ///< of so many degrees at least
};
std::shared_ptr<const ProductRule> product_rule(const PanelBasis& basis, int points, int degrees,
                                                RuleFor integrand = RuleFor::function);

/// The points s of a panel where its tractions meet their equations: the zeros of T_points, or about the middle those of
/// T_2points up to the middle.
struct MatchingPoints {
  bool about_middle;
  int points;

  friend auto operator<=>(const MatchingPoints&, const MatchingPoints&) = default;
  [[nodiscard]] std::shared_ptr<const Eigen::ArrayXd> at() const;  ///< rising
};

/// ln|x - s|, a row for each node x of a product rule with so many points and a column for each matching point s.
std::shared_ptr<const Eigen::ArrayXXd> logarithms(int points_of_rule, const MatchingPoints& points);

/// The integrals of a basis times ln|x - s| and times the sign of x - s, one row for each matching point s; and those of the
/// basis alone, one row.
struct SingularIntegrals {
  PanelBasis::Rows logarithm, sign, one;
};
std::shared_ptr<const SingularIntegrals> singular_integrals(const PanelBasis& basis,
                                                            const MatchingPoints& points, int degrees);

}  // namespace nipref::fast
