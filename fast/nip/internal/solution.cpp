#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <nipref/fast/nip/internal/panels.hpp>
#include <nipref/fast/nip/internal/solution.hpp>

namespace nipref::fast {
namespace {

constexpr double unit_roundoff = 0x1p-53;
/// The error of numbers below the least normal one, which have lost digits, in up to 16 operations.
constexpr double underflow = 16 * std::numeric_limits<double>::min();

}  // namespace

Solution::Solution(Tractions tractions, const Equations& equations)
    : tractions_(std::move(tractions)), integrals_(tractions_.integrals()), layers_(equations.layers) {
  for (std::vector<int>* columns : {&solved_, &left_out_})
    columns->reserve(static_cast<std::size_t>(tractions_.columns()));
  for (std::size_t p = 0; p < tractions_.panels().size(); ++p) {
    const int terms = tractions_.panels()[p].terms;
    for (int component = 0; component < tractions_.components(); ++component) {
      for (int k = 0; k < terms + Tractions::left_out; ++k)
        (k < terms ? solved_ : left_out_).push_back(tractions_.column(p, component) + k);
    }
  }
  const auto of_layers = equations.on_tractions.rightCols(layers_.rows());
  const Eigen::Index unknowns = equations.on_unknowns.cols(),
                     terms = static_cast<Eigen::Index>(solved_.size());
  Eigen::MatrixXd matrix(equations.right.size(), terms + unknowns);
  matrix.leftCols(terms) = equations.on_tractions(Eigen::all, solved_);
  matrix.rightCols(unknowns) = equations.on_unknowns;
  Eigen::VectorXd right = equations.right;
  if (layers_.size() > 0) {
    matrix.rightCols(unknowns) += of_layers * layers_.leftCols(unknowns);
    right -= of_layers * layers_.col(unknowns);
  }
  left_out_columns_ = equations.on_tractions(Eigen::all, left_out_);
  elimination_ = Elimination(matrix);
  Eigen::VectorXd solution = elimination_.solve(right);
  solution += elimination_.solve(right - matrix * solution);
  unknowns_ = solution.tail(unknowns);
  coefficients_ = Eigen::VectorXd::Zero(tractions_.columns());
  coefficients_(solved_) = solution.head(terms);
  if (layers_.size() > 0)
    coefficients_.tail(layers_.rows()) = layers_.leftCols(unknowns) * unknowns_ + layers_.col(unknowns);
  unit_ = (equations.memories > 0 ? 2 : 1) * unit_roundoff;
  matrix.leftCols(terms) =
      matrix.leftCols(terms).cwiseAbs().cwiseMax(equations.size_on_tractions(Eigen::all, solved_));
  matrix.rightCols(unknowns) = matrix.rightCols(unknowns).cwiseAbs().cwiseMax(equations.size_on_unknowns);
  right = right.cwiseAbs().cwiseMax(equations.size_right);
  equation_errors_ = 8 * unit_ *
                     (matrix.array().square().matrix() * solution.array().square().matrix() +
                      right.array().square().matrix())
                         .cwiseSqrt();
  equation_errors_.tail(equations.memories) *= 2;
  take_tails();
}

void Solution::take_tails() {
  tails_.resize(static_cast<Eigen::Index>(left_out_.size()));
  Eigen::Index next_column = 0;
  for (std::size_t p = 0; p < tractions_.panels().size(); ++p) {
    const Panel& panel = tractions_.panels()[p];
    const int terms = panel.terms;
    for (int component = 0; component < tractions_.components();
         ++component, next_column += Tractions::left_out) {
      double next = 0;
      for (int k = 1; k <= 3; ++k)
        next = std::max(next, std::fabs(coefficients_(tractions_.column(p, component) + terms - k)) /
                                  std::pow(least_fall, k));
      tails_.segment(next_column, Tractions::left_out).setConstant(2 * next);
    }
  }
}

double Solution::traction_bound() const {
  const std::vector<std::complex<double>> rates = tractions_.layer_rates();
  constexpr double largest_dawson = 1.2;
  double bound = coefficients_.head(coefficients_.size() - layers_.rows()).cwiseAbs().sum();
  for (std::size_t j = 0; j < rates.size(); ++j) {
    const auto of_layer = coefficients_.tail(layers_.rows()).segment(static_cast<Eigen::Index>(2 * j), 2);
    bound += 2 * std::numbers::inv_sqrtpi * largest_dawson * std::abs(rates[j]) * of_layer.cwiseAbs().sum();
  }
  return bound;
}

Functional Solution::of_unknown(int number) const {
  return {Eigen::RowVectorXd::Zero(tractions_.columns()), Eigen::RowVectorXd::Unit(unknowns_.size(), number),
          0};
}

Functional Solution::of_tractions(Eigen::RowVectorXd row) const {
  return {std::move(row), Eigen::RowVectorXd::Zero(unknowns_.size()), 0};
}

double Solution::value(const Functional& f) const {
  return f.constant + f.on_tractions.dot(coefficients_) + f.on_unknowns.dot(unknowns_);
}

Eigen::VectorXd Solution::adjoint(const Functional& f) const {
  const auto terms = static_cast<Eigen::Index>(solved_.size());
  Eigen::VectorXd right(elimination_.size());
  right.head(terms) = f.on_tractions(solved_).transpose();
  right.tail(unknowns_.size()) = f.on_unknowns.transpose();
  if (layers_.size() > 0)
    right.tail(unknowns_.size()) +=
        (f.on_tractions.tail(layers_.rows()) * layers_.leftCols(unknowns_.size())).transpose();
  return elimination_.solve_transposed(std::move(right));
}

Solution::Parts Solution::parts(const Functional& f) const {
  const Eigen::VectorXd z = adjoint(f);
  const Eigen::RowVectorXd of_left_out = f.on_tractions(left_out_) - z.transpose() * left_out_columns_;
  const double of_terms = std::fabs(f.constant) + f.on_tractions.cwiseAbs().dot(coefficients_.cwiseAbs()) +
                          f.on_unknowns.cwiseAbs().dot(unknowns_.cwiseAbs());
  // Kernels may underflow far away, on tractions over the whole contact.
  const double underflown = underflow * (1 + 2 * half_length() * traction_bound());
  // The norm is scaled, because the squares of z underflow long before z does.
  return {value(f), tails_.dot(of_left_out.cwiseAbs()),
          equation_errors_.cwiseProduct(z).stableNorm() + 16 * unit_ * (of_terms + f.cancelled) + underflown};
}

}  // namespace nipref::fast
