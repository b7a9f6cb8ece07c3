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

constexpr int elements = 120, most_changes = 200;

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
    constexpr int most_steps = 40, digits = 40;
    double from = 0, to = 0, before = excess(from), after = before;
    for (int step = 0; before * after > 0; ++step) {
      if (step == most_steps) return;
      from = std::exchange(to, to + std::ldexp(after < 0 ? element_ : -element_, step));
      before = std::exchange(after, excess(to));
    }
    if (!(before * after < 0)) return;
    if (to < from) std::swap(from, to), std::swap(before, after);
    std::uintmax_t most_calls = 100;
    const auto found = boost::math::tools::toms748_solve(
        excess, from, to, before, after, boost::math::tools::eps_tolerance<double>(digits), most_calls);
    excess(found.second);
  }
  [[nodiscard]] double load() const { return element_ * pressure_.sum(); }
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

}  // namespace

Row<SlipZone> plain_zones(const SlipProblem& problem, SheetKernels& kernels, double length) {
  constexpr int digits_of_length = 4;
  Row<int> signs(GridIndex{elements});
  int trailing = 0;
  const auto contact_of = [&](const Lengths& lengths) {
    std::optional<PlainContact> contact(std::in_place, problem, kernels, static_cast<double>(lengths.length));
    contact->settle(signs);
    trailing = contact->trailing_sign();
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
  for (int sign : signs) add_zone(zones, sign, length / elements);
  if (zones.back().sign == 0 && !problem.may_stick_all_along(zones)) {
    zones.back().length -= length / (2 * elements);
    zones.push_back({trailing, length / (2 * elements)});
  }
  return zones;
}

}  // namespace nipref::ref
