#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <nipref/ref/partial_slip/internal/slip_solution.hpp>

namespace nipref::ref {
namespace {

constexpr int elements = 120;

/// A contact of equal elements, whose tractions act at their middles and whose equations hold at their edges. The sign
/// of an element is that of its shear if it slips, 0 if it sticks.
class PlainContact {
 public:
  PlainContact(const SlipProblem& problem, SheetKernels& kernels, double length)
      : problem_(problem), element_(length / elements) {
    for (int way = 0; way <= elements; ++way) {
      // U, V and S from the middle of an element to an edge, way + 1/2 elements away.
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
  }

  /// Changes signs until no element violates its condition, or no change helps.
  void settle() {
    least_creep_ = sliding(-1).minCoeff();
    most_creep_ = sliding(1).maxCoeff();
    if (problem_.creep)
      slides_to(static_cast<double>(*problem_.creep));
    else if (slides_to(0))
      meet_traction();
  }
  [[nodiscard]] int sign(int element) const { return signs_[element]; }
  /// About the length l that sticks around an element between opposite slips. q is -mu p ahead of it and mu p behind
  /// it; without it the slip would have the slope s'. In it (1/pi) int q'/(e' - e) de' = s', with q' bounded where it
  /// begins: q' = s' (x/(l - x))^(1/2) at the distance 0 < x < l from there. So l = 4 mu p/(pi s'), as int q' = 2 mu p.
  [[nodiscard]] double sticking(int element) const {
    const int from = std::max(element - 1, 0), to = std::min(element + 2, elements);
    const double slope = (slip_(to) - slip_(from)) / ((to - from) * element_);
    return std::fabs(4 * problem_.friction * pressure_(element) / (std::numbers::pi * slope));
  }

 private:
  static constexpr int leading = 2 * elements, unknowns = 2 * elements + 1;

  /// Changes signs at the present creep until none changes; false if that does not end.
  bool settles() {
    constexpr int most_changes = 20;
    for (int change = 0; change < most_changes; ++change) {
      solve();
      if (!change_signs()) return true;
    }
    return false;
  }

  /// Settles at `creep` or, if signs change there without end, at a creep nearer to the present one.
  bool settles_towards(double creep) {
    constexpr int most_halvings = 6;
    const Row<int> signs = signs_;
    const double from = creep_;
    for (int halving = 0; halving < most_halvings; ++halving) {
      creep_ = std::lerp(from, creep, std::ldexp(1, -halving));
      signs_ = signs;
      if (settles()) return true;
    }
    return false;
  }

  /// The strains if all elements slip one way. They do so at creeps beyond all of these.
  const Eigen::VectorXd& sliding(int sign) {
    std::ranges::fill(signs_, sign);
    creep_ = 0;
    solve();
    return slip_;
  }

  /// Settles at `creep`, in steps from a creep at which all elements slip one way.
  bool slides_to(double creep) {
    constexpr int most_steps = 20;
    for (const int sign : {-1, 1}) {
      std::ranges::fill(signs_, sign);
      creep_ = sign < 0 ? least_creep_ : most_creep_;
      for (int step = 0; step < most_steps && settles_towards(creep); ++step)
        if (creep_ == creep) return true;
    }
    return false;
  }

  /// Finds the creep with the wanted traction, by Newton's method in a bracket: the traction rises with the creep,
  /// linearly as long as no sign changes. If the load is given, the wanted traction is the same share of the load that
  /// is found here. If no creep has this traction, the nearest is taken.
  void meet_traction() {
    constexpr int most_steps = 40;
    constexpr double tolerance = 1e-10;
    const double share = problem_.length ? 0 : static_cast<double>(problem_.shear / problem_.load),
                 wanted = problem_.length ? static_cast<double>(problem_.shear) : 0;
    double least = least_creep_, most = most_creep_, nearest = HUGE_VAL, creep = 0;
    Row<int> signs;
    for (int step = 0; step < most_steps; ++step) {
      const Eigen::VectorXd missing = share * pressure_ - shear_,
                            by_creep = slope_shear_ - share * slope_pressure_;
      const double rest = wanted + element_ * missing.sum();
      if (std::fabs(rest) < nearest) {
        nearest = std::fabs(rest);
        signs = signs_;
        creep = creep_;
      }
      if (nearest < tolerance * problem_.friction * element_ * pressure_.sum()) break;
      (rest > 0 ? least : most) = creep_;
      const double next = creep_ + rest / (element_ * by_creep.sum());
      if (!settles_towards(next > least && next < most ? next : std::midpoint(least, most))) break;
    }
    signs_ = signs;
    creep_ = creep;
    solve();
  }

  /// Solves for the tractions with the present signs and creep, and for their derivatives by the creep.
  void solve() {
    Eigen::MatrixXd matrix(unknowns, unknowns), right = Eigen::MatrixXd::Zero(unknowns, 2);
    matrix << normal_, tangential_.topRows(elements);
    right.col(0).head(elements + 1) = Eigen::VectorXd::LinSpaced(elements + 1, 0, -2 * elements * element_);
    for (int i = 0; i < elements; ++i) {
      auto row = matrix.row(elements + 1 + i);
      right.row(elements + 1 + i) << (signs_[i] == 0 ? creep_ : 0), (signs_[i] == 0 ? 1 : 0);
      if (signs_[i] == 0) continue;
      row.setZero();
      row(elements + i) = 1;
      row(i) = -signs_[i] * problem_.friction;
    }
    const Eigen::MatrixXd solution = matrix.partialPivLu().solve(right);
    pressure_ = solution.col(0).head(elements);
    shear_ = solution.col(0).segment(elements, elements);
    slope_pressure_ = solution.col(1).head(elements);
    slope_shear_ = solution.col(1).segment(elements, elements);
    slip_ = (tangential_ * solution.col(0)).array() - creep_;
  }

  /// Changes the signs that violate their conditions. If only the last element does, returns false without a change:
  /// the last element always slips, since stick up to the trailing end is a difference of large numbers.
  bool change_signs() {
    constexpr int last = elements - 1;
    const Row<int> before = signs_;
    for (int i = 0; i < elements; ++i) {
      int& sign = signs_[i];
      if (sign == 0 && std::fabs(shear_(i)) > problem_.friction * pressure_(i))
        sign = shear_(i) > 0 ? 1 : -1;
      else if (sign * slip_(i) > 0)
        sign = i == last ? -sign : 0;
    }
    if (!std::equal(before.begin(), before.end() - 1, signs_.begin())) return true;
    signs_ = before;
    return false;
  }

  const SlipProblem& problem_;
  double element_, creep_ = 0;
  double least_creep_ = 0, most_creep_ = 0;  ///< beyond them all elements slip one way
  /// Both equations at the edges of elements, as rows for the tractions and L1.
  Eigen::MatrixXd normal_ = Eigen::MatrixXd::Zero(elements + 1, unknowns), tangential_ = normal_;
  Row<int> signs_ = Row<int>(GridIndex{elements});
  Eigen::VectorXd pressure_, shear_, slip_, slope_pressure_, slope_shear_;  ///< slopes are by creep
};

/// Puts a stick zone of the length in `sticking` between opposite slips that are adjacent or one element apart.
void stick_between_slips(Row<SlipZone>& zones, const Row<double>& sticking, double element) {
  Float left = 0;
  for (GridIndex k = 1; k + 1 < zones.count(); ++k) {
    SlipZone &before = zones[k - 1], &here = zones[k], &behind = zones[k + 1];
    left += before.length;
    if (before.sign * behind.sign >= 0 || here.length > 1.5 * element) continue;
    const Float most = std::max(here.length, Float(std::min(before.length, behind.length) / 4)),
                change = std::min(most, Float(sticking[static_cast<int>(left / element)])) - here.length;
    here.length += change;
    before.length -= change / 2;
    behind.length -= change / 2;
    left -= change / 2;
  }
}

}  // namespace

Row<SlipZone> plain_zones(const SlipProblem& problem, SheetKernels& kernels, double length) {
  PlainContact contact(problem, kernels, length);
  const double element = length / elements;
  contact.settle();
  Row<SlipZone> zones;
  Row<double> sticking(GridIndex{elements});
  for (int i = 0; i < elements; ++i) {
    // The last element takes the sign of the one before, as its own means nothing behind another slip.
    const int sign = contact.sign(std::min(i, elements - 2));
    const bool turns = !zones.empty() && zones.back().sign * sign < 0;
    if (turns) zones.push_back({0, 0});
    if (zones.empty() || zones.back().sign != sign) zones.push_back({sign, 0});
    zones.back().length += element;
    sticking[i] = contact.sticking(i);
  }
  stick_between_slips(zones, sticking, element);
  if (zones.back().sign == 0 && !problem.may_stick_all_along(zones)) {
    zones.back().length -= element / 2;
    zones.push_back({contact.sign(elements - 1), element / 2});
  }
  return zones;
}

}  // namespace nipref::ref
