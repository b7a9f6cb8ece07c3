#include <Eigen/LU>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <utility>

#include <nipref/ref/nip/internal/length_search.hpp>
#include <nipref/ref/partial_slip/internal/slip_solution.hpp>

namespace nipref::ref {
namespace {

constexpr int elements = 120, most_changes = 40;

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
  }

  /// Signs of the elements' slip, from a guess at them; 0 where they stick.
  void settle(Row<int>& signs) {
    if (problem_.creep) {
      settle_at(static_cast<double>(*problem_.creep), signs);
      return;
    }
    // The traction grows with creep. Of a load that is not yet met it is to be the same share.
    const auto excess = [&](double creep) {
      settle_at(creep, signs);
      const double share = problem_.length ? 1 : load() / static_cast<double>(problem_.load);
      return element_ * shear_.sum() - static_cast<double>(problem_.shear) * share;
    };
    // So much creep that all elements slip one way.
    const double most = 8 * (1 + problem_.friction) * element_ * elements;
    const auto sliding = [&](int sign) {
      std::ranges::fill(signs, sign);
      return excess(sign * most);
    };
    const double before = sliding(-1), after = sliding(1);
    if (!(before * after < 0)) return;
    constexpr int bits = 40;
    std::uintmax_t most_calls = 100;
    const auto found = boost::math::tools::toms748_solve(
        excess, -most, most, before, after, boost::math::tools::eps_tolerance<double>(bits), most_calls);
    excess(found.second);
  }
  [[nodiscard]] double load() const { return element_ * pressure_.sum(); }
  /// About the length that sticks around an element between opposite slips. With q = -mu p in front of it, mu p behind it and a slip
  /// that grows by s' without it, (1/pi) int q'/(e' - e) de' = s' where it sticks, and q' is bounded where that begins: so
  /// q' = 2 mu p/pi (x/(l - x))^(1/2)/l at the distance 0 < x < l from there, with l = 4 mu p/(pi s').
  [[nodiscard]] double sticking(int element) const {
    const int from = std::max(element - 1, 0), to = std::min(element + 2, elements);
    const double slope = (slip_(to) - slip_(from)) / ((to - from) * element_);
    return std::fabs(4 * problem_.friction * pressure_(element) / (std::numbers::pi * slope));
  }
  /// Of the shear at the trailing end, where no sheet sticks.
  [[nodiscard]] int trailing_sign() const { return shear_(elements - 1) < 0 ? -1 : 1; }

 private:
  static constexpr int leading = 2 * elements, unknowns = 2 * elements + 1;

  void settle_at(double creep, Row<int>& signs) {
    for (int change = 0; change < most_changes; ++change) {
      solve(creep, signs);
      if (!is_changed(signs, change < most_changes / 2)) return;
    }
  }

  void solve(double creep, const Row<int>& signs) {
    Eigen::MatrixXd matrix(unknowns, unknowns);
    matrix << normal_, tangential_.topRows(elements);
    Eigen::VectorXd right = Eigen::VectorXd::Constant(unknowns, creep);
    right.head(elements + 1) = Eigen::VectorXd::LinSpaced(elements + 1, 0, -2 * elements * element_);
    for (int i = 0; i < elements; ++i) {
      if (signs[i] == 0) continue;
      auto row = matrix.row(elements + 1 + i);
      row.setZero();
      row(elements + i) = 1;
      row(i) = -signs[i] * problem_.friction;
      right(elements + 1 + i) = 0;
    }
    const Eigen::VectorXd solution = matrix.partialPivLu().solve(right);
    pressure_ = solution.head(elements);
    shear_ = solution.segment(elements, elements);
    slip_ = (tangential_ * solution).array() - creep;
  }

  /// Changes the signs that violate their conditions: all of them, or the first.
  bool is_changed(Row<int>& signs, bool all) const {
    const Row<int> before = signs;
    for (int i = 0; i < elements && (all || signs == before); ++i) {
      int& sign = signs[i];
      if (sign == 0 && std::fabs(shear_(i)) > problem_.friction * pressure_(i))
        sign = shear_(i) > 0 ? 1 : -1;
      else if (sign * slip_(i) > 0)
        sign = 0;
    }
    return signs != before;
  }

  const SlipProblem& problem_;
  double element_;
  /// Both equations at the edges of elements, by their tractions and L1.
  Eigen::MatrixXd normal_ = Eigen::MatrixXd::Zero(elements + 1, unknowns), tangential_ = normal_;
  Eigen::VectorXd pressure_, shear_, slip_;
};

/// Where opposite slips are next to each other, or one element apart, it sticks for the length of that element in `sticking`.
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
  constexpr int digits_of_length = 4;
  Row<int> signs(GridIndex{elements});
  Row<double> sticking(GridIndex{elements});
  int trailing = 0;
  const auto contact_of = [&](const Lengths& lengths) {
    std::optional<PlainContact> contact(std::in_place, problem, kernels, static_cast<double>(lengths.length));
    contact->settle(signs);
    trailing = contact->trailing_sign();
    for (int i = 0; i < elements; ++i) sticking[i] = contact->sticking(i);
    return contact;
  };
  if (problem.length) {
    contact_of({*problem.length});
  } else {
    LengthSearch search{Exact(static_cast<double>(problem.load)), length};
    search.seek(digits_of_length, contact_of);
    length = static_cast<double>(search.length);
  }
  Row<SlipZone> zones;
  for (int sign : signs) {
    const bool turns = !zones.empty() && zones.back().sign * sign < 0;
    if (turns) zones.push_back({0, 0});
    if (zones.empty() || zones.back().sign != sign) zones.push_back({sign, 0});
    zones.back().length += length / elements;
  }
  stick_between_slips(zones, sticking, length / elements);
  if (zones.back().sign == 0 && !problem.may_stick_all_along(zones)) {
    zones.back().length -= length / (2 * elements);
    zones.push_back({trailing, length / (2 * elements)});
  }
  return zones;
}

}  // namespace nipref::ref
