#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <nipref/ref/partial_slip/internal/slip_solution.hpp>

namespace nipref::ref {
namespace {

constexpr int elements = 120, most_changes = 200, most_lengths = 12;

class PlainContact {
 public:
  PlainContact(const SlipProblem& problem, SheetKernels& kernels, double length)
      : problem_(problem), element_(length / elements) {
    for (int way = 0; way <= elements; ++way) {
      // U, V and S from the middle of an element to an edge beside it, or so many elements away.
      const Float alpha = (way + 0.5) * element_, normal = kernels.smooth_normal_slope(alpha) - 1 / alpha;
      const double over_pi = element_ / std::numbers::pi, u = over_pi * static_cast<double>(normal),
                   v = over_pi * static_cast<double>(kernels.coupling_slope(alpha)),
                   s = u - over_pi * static_cast<double>(kernels.coupling(alpha));
      const double beta = way == 0 ? static_cast<double>(problem.beta) / 2 : 0;
      for (int edge = 0; edge <= elements; ++edge) {
        for (const auto& [i, sign] : {std::pair(edge - way - 1, 1), std::pair(edge + way, -1)}) {
          if (i < 0 || i >= elements) continue;
          normal_(edge, i) = sign * u;
          normal_(edge, elements + i) = beta - v;
          tangential_(edge, i) = v - beta;
          tangential_(edge, elements + i) = sign * s;
        }
      }
    }
    normal_.col(leading).setConstant(-2);
    tangential_.col(creep).setConstant(-1);
  }

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
  static constexpr int leading = 2 * elements, creep = 2 * elements + 1, unknowns = 2 * elements + 2;

  void solve(const Row<int>& signs) {
    Eigen::MatrixXd matrix(unknowns, unknowns);
    matrix << normal_, tangential_;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
    right.head(elements + 1) = Eigen::VectorXd::LinSpaced(elements + 1, 0, -2 * elements * element_);
    for (int i = 0; i < elements; ++i) {
      if (signs[i] == 0) continue;
      auto row = matrix.row(elements + 1 + i);
      row.setZero();
      row(elements + i) = 1;
      row(i) = -signs[i] * problem_.friction;
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
    slip_ = tangential_ * solution;
  }

  bool is_changed(Row<int>& signs) const {
    const Row<int> before = signs;
    int nearest = 0;
    double least = HUGE_VAL;
    for (int i = 0; i < elements; ++i) {
      int& sign = signs[i];
      const double excess = std::fabs(shear_(i)) - problem_.friction * pressure_(i);
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
  /// Both equations at the edges of elements, by their tractions, L1 and creep.
  Eigen::MatrixXd normal_ = Eigen::MatrixXd::Zero(elements + 1, unknowns), tangential_ = normal_;
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
  for (int sign : signs) add_zone(zones, sign, length / elements);
  if (zones.back().sign == 0 && !problem.may_stick_all_along(zones)) {
    zones.back().length -= length / (2 * elements);
    zones.push_back({trailing, length / (2 * elements)});
  }
  return zones;
}

}  // namespace nipref::ref
