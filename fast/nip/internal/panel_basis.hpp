#pragma once
#include <Eigen/Core>
#include <compare>
#include <memory>

namespace nipref::fast {

/// The basis functions of the tractions on a panel scaled to 0 <= x <= 1: a factor times T_n(2 x - 1).
/// With a = 1/2 + i exponent the factor is
///   at the end    x^a, or 2 x^a (1 - x)^conj(a) if the panel is the whole contact
///   elsewhere     1
struct PanelBasis {
  bool at_end, is_whole;
  double exponent;  ///< 0 on panels that are not at the end

  friend auto operator<=>(const PanelBasis&, const PanelBasis&) = default;

  /// Real and imaginary parts, a row for each node and a column for each degree n. A zero imaginary part is empty.
  struct Rows {
    Eigen::MatrixXd real, imaginary;
  };
  /// The basis functions at the places x. `rest` is 1 - x, given apart so that it is accurate next to x = 1, too.
  [[nodiscard]] Rows values(const Eigen::ArrayXd& x, const Eigen::ArrayXd& rest, int degrees) const;
};

/// The integral of a product rule: int f phi_n dx; or int f ln x phi_n dx, for bases at the end with exponent 0 alone.
enum class RuleFor { function, times_logarithm };

/// A rule int f phi_n dx = sum_i f(at_i) weight_in for a function f that is analytic about the panel. The polynomial
/// that interpolates f at Chebyshev points is integrated in closed form, so that only the interpolation has an error.
/// It is about rho^-points if f is analytic within the ellipse with foci 0 and 1 whose half axes add up to rho/2.
struct ProductRule {
  Eigen::ArrayXd at;
  PanelBasis::Rows weight;  ///< a column for each degree, at least as many as asked for
};
std::shared_ptr<const ProductRule> product_rule(const PanelBasis& basis, int points, int degrees,
                                                RuleFor integrand = RuleFor::function);

/// The matching points s of a panel, where the equations are to hold: the zeros of T_points, or on the panel about the
/// middle the zeros of T_2points up to the middle.
struct MatchingPoints {
  bool about_middle;
  int points;

  friend auto operator<=>(const MatchingPoints&, const MatchingPoints&) = default;
  [[nodiscard]] std::shared_ptr<const Eigen::ArrayXd> at() const;  ///< the points, rising
};

/// ln|x - s|, a row for each node x of a product rule with so many points and a column for each matching point s.
std::shared_ptr<const Eigen::ArrayXXd> logarithms(int points_of_rule, const MatchingPoints& points);

/// The integrals of a basis times ln|x - s| and times the sign of x - s, one row for each matching point s. `one`: the
/// integrals of the basis alone, one row.
struct SingularIntegrals {
  PanelBasis::Rows logarithm, sign, one;
};
std::shared_ptr<const SingularIntegrals> singular_integrals(const PanelBasis& basis,
                                                            const MatchingPoints& points, int degrees);

}  // namespace nipref::fast
