#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <nipref/ref/partial_slip/internal/plain_zones.hpp>

namespace nipref::ref {
namespace {

constexpr int elements = 120, most_changes = 200, most_lengths = 12;

/// Slopes of the kernels over the distances between nodes, in the middles of elements, and edges.
struct PlainKernels {
  Eigen::VectorXd normal{elements + 1}, coupling{elements + 1}, tangential{elements + 1};

  PlainKernels(SheetKernels& kernels, double element) {
    for (int i = 0; i <= elements; ++i) {
      const double alpha = (i + 0.5) * element;
      const auto of = [&](const Float& x) { return static_cast<double>(x) / std::numbers::pi; };
      normal(i) = of(kernels.smooth_normal_slope(alpha)) - 1 / (std::numbers::pi * alpha);
      coupling(i) = of(kernels.coupling_slope(alpha));
      tangential(i) = normal(i) - of(kernels.coupling(alpha));
    }
  }
};

class PlainContact {
 public:
  PlainContact(const SlipProblem& problem, SheetKernels& kernels, double length)
      : problem_(problem), element_(length / elements), kernels_(kernels, element_) {}

  /// Signs of the elements' slip, from a guess at them; 0 where they stick.
  void settle(Row<int>& signs) {
    for (int change = 0; change < most_changes; ++change) {
      solve(signs);
      if (!is_changed(signs)) return;
    }
  }
  [[nodiscard]] double load() const { return element_ * pressure_.sum(); }
  /// Of the shear at the trailing end, where no sheet sticks.
  [[nodiscard]] int trailing_sign() const { return shear_(elements - 1) < 0 ? -1 : 1; }

 private:
  using Rows = Eigen::MatrixXd;

  static constexpr int leading = 2 * elements, creep = 2 * elements + 1, unknowns = 2 * elements + 2;

  /// The rows of both equations at the edge of elements `edge` - 1 and `edge`.
  [[nodiscard]] Eigen::RowVectorXd row(int edge, bool is_normal) const {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(unknowns);
    const auto beta = static_cast<double>(problem_.beta);
    for (int i = 0; i < elements; ++i) {
      const int way = i < edge ? edge - i - 1 : i - edge;
      const double sign = i < edge ? 1 : -1;
      const double local = i == edge || i == edge - 1 ? beta / 2 : 0;
      row(i) = element_ * (is_normal ? sign * kernels_.normal(way) : kernels_.coupling(way)) -
               (is_normal ? 0 : local);
      row(elements + i) = element_ * (is_normal ? -kernels_.coupling(way) : sign * kernels_.tangential(way)) +
                          (is_normal ? local : 0);
    }
    row(is_normal ? leading : creep) = is_normal ? -2 : -1;
    return row;
  }

  void solve(const Row<int>& signs) {
    Rows matrix(unknowns, unknowns);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
    const auto friction = static_cast<double>(problem_.friction);
    for (int edge = 0; edge <= elements; ++edge) {
      matrix.row(edge) = row(edge, true);
      right(edge) = -2 * edge * element_;
    }
    for (int i = 0; i < elements; ++i) {
      auto at = matrix.row(elements + 1 + i);
      at = row(i, false);
      if (signs[i] == 0) continue;
      at.setZero();
      at(elements + i) = 1;
      at(i) = -signs[i] * friction;
    }
    auto last = matrix.row(unknowns - 1);
    last.setZero();
    if (problem_.creep) {
      last(creep) = 1;
      right(unknowns - 1) = static_cast<double>(*problem_.creep);
    } else {
      last.segment(elements, elements).setConstant(element_);
      right(unknowns - 1) = static_cast<double>(problem_.shear);
    }
    const Eigen::VectorXd solution = matrix.partialPivLu().solve(right);
    pressure_ = solution.head(elements);
    shear_ = solution.segment(elements, elements);
    slip_.resize(elements);
    for (int i = 0; i < elements; ++i) slip_(i) = row(i, false) * solution;
  }

  bool is_changed(Row<int>& signs) const {
    const auto friction = static_cast<double>(problem_.friction);
    const Row<int> before = signs;
    int nearest = 0;
    double least = HUGE_VAL;
    for (int i = 0; i < elements; ++i) {
      int& sign = signs[i];
      const double excess = std::fabs(shear_(i)) - friction * pressure_(i);
      if (sign == 0 && excess > 0)
        sign = shear_(i) > 0 ? 1 : -1;
      else if (sign * slip_(i) > 0)
        sign = 0;
      if (excess < least) least = excess, nearest = i;
    }
    // A traction that is given needs a place that sticks.
    if (!problem_.creep && std::ranges::count(signs, 0) == 0) signs[nearest] = 0;
    return signs != before;
  }

  const SlipProblem& problem_;
  double element_;
  PlainKernels kernels_;
  Eigen::VectorXd pressure_, shear_, slip_;
};

}  // namespace

Row<SlipZone> plain_zones(const SlipProblem& problem, SheetKernels& kernels, double length) {
  Row<int> signs(GridIndex{elements});
  int trailing = 0;
  for (int i = 0; i < most_lengths; ++i) {
    PlainContact contact(problem, kernels, length);
    contact.settle(signs);
    trailing = contact.trailing_sign();
    if (problem.length) break;
    // Loads grow like the second to third power of the length.
    const double change = std::pow(static_cast<double>(problem.load) / contact.load(), 0.4);
    length *= std::clamp(change, 0.5, 2.0);
    if (std::fabs(change - 1) < 1e-4) break;
  }
  Row<SlipZone> zones;
  for (int sign : signs) {
    if (!zones.empty() && sign * zones.back().sign < 0) zones.push_back({0, length / elements});
    if (zones.empty() || zones.back().sign != sign) zones.push_back({sign, 0});
    zones.back().length += length / elements;
  }
  if (zones.back().sign == 0) {
    zones.back().length -= length / (2 * elements);
    zones.push_back({trailing, length / (2 * elements)});
  }
  return zones;
}

}  // namespace nipref::ref
