#include <nipref/fast/nip/internal/panel_basis.hpp>
#include <nipref/fast/number/internal/double_exponential.hpp>

#include "support/test.hpp"

namespace nipref::fast {
namespace {

constexpr int degrees = 24;
const PanelBasis bases[] = {
    {false, false, 0}, {true, false, 0}, {true, false, -0.2}, {true, true, 0}, {true, true, -0.2}};

/// Nodes of the double-exponential rule on eight pieces on each side of s, which resolve polynomials of all degrees.
struct Nodes {
  Eigen::ArrayXd x, rest, weight, distance;

  explicit Nodes(double s) {
    constexpr int pieces = 8;
    const std::vector<UnitNode> rule = double_exponential_rule(1e-16);
    const auto count = static_cast<Eigen::Index>(2 * pieces * rule.size());
    for (Eigen::ArrayXd* values : {&x, &rest, &weight, &distance}) values->resize(count);
    Eigen::Index i = 0;
    for (const double length : {-s, 1 - s}) {
      for (int piece = 0; piece < pieces; ++piece) {
        for (const UnitNode& node : rule) {
          const double part = (piece + node.from_left) / pieces,
                       left = (pieces - piece - 1 + node.from_right) / pieces;
          distance(i) = length * part;
          x(i) = length < 0 ? s * left : s + distance(i);
          rest(i) = length < 0 ? 1 - s - distance(i) : length * left;
          weight(i) = std::fabs(length) / pieces * node.weight;
          ++i;
        }
      }
    }
  }
};

double largest_difference(const Eigen::RowVectorXd& weights, const Eigen::MatrixXd& values,
                          const Eigen::RowVectorXd& expected) {
  if (expected.size() == 0) return values.size() == 0 ? 0 : 1;
  return (weights * values - expected.head(values.cols())).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("integrals of a basis times a logarithm and a sign are those of a rule in pieces") {
  for (const PanelBasis& basis : bases) {
    for (const bool about_middle : {false, true}) {
      const MatchingPoints points{about_middle, 13};
      const auto singular = singular_integrals(basis, points, degrees);
      for (int number = 0; number < points.points; ++number) {
        const Nodes nodes((*points.at())(number));
        const PanelBasis::Rows values = basis.values(nodes.x, nodes.rest, degrees);
        const auto check = [&](const Eigen::ArrayXd& f, const PanelBasis::Rows& found, int row) {
          const Eigen::RowVectorXd weights = (nodes.weight * f).matrix().transpose();
          CHECK(largest_difference(weights, values.real, found.real.row(row)) < 1e-14);
          if (basis.exponent != 0)
            CHECK(largest_difference(weights, values.imaginary, found.imaginary.row(row)) < 1e-14);
        };
        check(nodes.distance.abs().log(), singular->logarithm, number);
        check(nodes.distance.sign(), singular->sign, number);
        check(Eigen::ArrayXd::Ones(nodes.x.size()), singular->one, 0);
      }
    }
  }
}

TEST_CASE("a product rule is exact for polynomials, and converges geometrically for analytic functions") {
  const Nodes nodes(0.4);
  for (const PanelBasis& basis : bases) {
    const PanelBasis::Rows values = basis.values(nodes.x, nodes.rest, degrees);
    const auto error = [&](int points, const auto& f) {
      const auto rule = product_rule(basis, points, degrees);
      const Eigen::RowVectorXd weights = (nodes.weight * f(nodes.x)).matrix().transpose(),
                               at_points = f(rule->at).matrix().transpose();
      double largest = largest_difference(weights, values.real, at_points * rule->weight.real);
      if (basis.exponent != 0)
        largest = std::max(largest,
                           largest_difference(weights, values.imaginary, at_points * rule->weight.imaginary));
      return largest;
    };
    CHECK(error(8, [](const Eigen::ArrayXd& x) { return (x - 0.3).pow(7).eval(); }) < 2e-15);
    // The logarithm is singular at x = -0.2, on the Bernstein ellipse of parameter 1.4 + sqrt(1.4^2 - 1).
    const auto logarithm = [](const Eigen::ArrayXd& x) { return (x + 0.2).log().eval(); };
    const double fall = 1.4 + std::sqrt(1.4 * 1.4 - 1);
    CHECK(error(16, logarithm) < std::pow(fall, -16));
    CHECK(error(32, logarithm) < std::pow(fall, -32));
  }
}

TEST_CASE("a product rule with a logarithm is exact for polynomials") {
  const Nodes nodes(0.4);
  for (const PanelBasis& basis : bases) {
    if (!basis.at_end || basis.exponent != 0) continue;
    const auto polynomial = [](const Eigen::ArrayXd& x) { return (x - 0.3).pow(7).eval(); };
    const auto rule = product_rule(basis, 8, degrees, RuleFor::times_logarithm);
    const Eigen::RowVectorXd weights =
        (nodes.weight * nodes.x.log() * polynomial(nodes.x)).matrix().transpose();
    CHECK(largest_difference(weights, basis.values(nodes.x, nodes.rest, degrees).real,
                             polynomial(rule->at).matrix().transpose() * rule->weight.real) < 2e-15);
  }
}

}  // namespace nipref::fast
