#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>
#include <nipref/fast/partial_slip/internal/element_contact.hpp>
#include <nipref/fast/sheet/internal/regular_parts.hpp>
#include <nipref/fast/sheet/kernels.hpp>

namespace nipref::fast {
namespace {

using Eigen::Index, Eigen::RowVectorXd;
using std::numbers::pi;

/// Displacements at the middle of an element under unit tractions on the element k places before it: u under pressure,
/// v under pressure, v under shear. u under shear is minus v under pressure.
struct Influence {
  std::vector<double> normal, coupling, along;
};

Influence influence(double beta, double width, int count) {
  std::vector<double> alpha(static_cast<std::size_t>(count)), normal(alpha.size()), along(alpha.size());
  for (std::size_t k = 0; k < alpha.size(); ++k) alpha[k] = static_cast<double>(k) * width;
  internal::regular_I1(alpha, normal);
  internal::regular_I6(alpha, along);
  Influence of;
  const auto integral = [](double x) { return x * std::log(std::fabs(x)) - x; };
  for (std::size_t k = 0; k < alpha.size(); ++k) {
    const double logarithm = integral(alpha[k] + width / 2) - integral(alpha[k] - width / 2);
    of.normal.push_back((width * normal[k] - logarithm) / pi);
    of.along.push_back((width * along[k] - logarithm) / pi);
    of.coupling.push_back(k == 0 ? 0 : width * (I3(alpha[k]) / pi - beta / 2));
  }
  return of;
}

class ActiveSet {
 public:
  ActiveSet(const PartialSlipTask& task, double half_region, int count)
      : task_(task), elements_(static_cast<std::size_t>(count)), width_(2 * half_region / count) {
    influence_ = influence(task.beta, width_, count + 1);
    for (int k = 0; k < count; ++k)
      elements_[static_cast<std::size_t>(k)] = {(k + 0.5) * width_ - half_region, true, 0, 0, 0};
  }

  /// A contact up to the outermost elements would go on beyond them.
  ElementContact solved() {
    constexpr int changes_of_all = 20, most_changes = 60;
    bool settled = false;
    for (int change = 0; change < most_changes && !settled; ++change) {
      solve();
      settled = !changed(change < changes_of_all) && std::isfinite(creep_);
    }
    settled = settled && !elements_.front().presses && !elements_.back().presses;
    return {elements_, width_, creep_, solution_(unknowns_ - 2), settled};
  }

 private:
  /// u or v at the middle of element k as a row over the unknowns.
  RowVectorXd row(int k, bool normal) const {
    RowVectorXd result = RowVectorXd::Zero(unknowns_);
    for (std::size_t j = 0; j < elements_.size(); ++j) {
      if (!elements_[j].presses) continue;
      const int apart = k - static_cast<int>(j);
      const auto distance = static_cast<std::size_t>(std::abs(apart));
      const double coupling = apart < 0 ? -influence_.coupling[distance] : influence_.coupling[distance];
      const double of_pressure = normal ? influence_.normal[distance] : coupling;
      const double of_shear = normal ? -coupling : influence_.along[distance];
      result(pressure_[j]) += of_pressure;
      if (elements_[j].sign == 0)
        result(shear_[j]) += of_shear;
      else
        result(pressure_[j]) += task_.friction * elements_[j].sign * of_shear;
    }
    return result;
  }

  void number() {
    pressure_.assign(elements_.size(), -1);
    shear_ = pressure_;
    unknowns_ = 0;
    for (std::size_t k = 0; k < elements_.size(); ++k)
      if (elements_[k].presses) pressure_[k] = unknowns_++;
    for (std::size_t k = 0; k < elements_.size(); ++k)
      if (elements_[k].presses && elements_[k].sign == 0) shear_[k] = unknowns_++;
    unknowns_ += 2;  // the approach and the creep
  }

  void solve() {
    number();
    const Index approach = unknowns_ - 2, creep = unknowns_ - 1;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(unknowns_, unknowns_);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns_);
    for (std::size_t k = 0; k < elements_.size(); ++k) {
      const ElementContact::Element& element = elements_[k];
      if (!element.presses) continue;
      const int place = static_cast<int>(k);
      matrix.row(pressure_[k]) = row(place, true);
      matrix(pressure_[k], approach) = -1;
      right(pressure_[k]) = -element.e * element.e;
      matrix(approach, pressure_[k]) = width_;
      if (element.sign == 0) {
        matrix.row(shear_[k]) = row(place, false) - row(place - 1, false);
        matrix(shear_[k], creep) = -width_;
        matrix(creep, shear_[k]) = width_;
      } else {
        matrix(creep, pressure_[k]) = width_ * task_.friction * element.sign;
      }
    }
    right(approach) = *task_.load;
    right(creep) = task_.creep ? *task_.creep : *task_.traction;
    if (task_.creep) matrix.row(creep) = RowVectorXd::Unit(unknowns_, creep);
    solution_ = Elimination(matrix).solve(right);
    ++task_.work->systems;
    task_.work->unknowns = std::max(task_.work->unknowns, unknowns_);
    creep_ = solution_(creep);
    for (std::size_t k = 0; k < elements_.size(); ++k) {
      ElementContact::Element& element = elements_[k];
      element.pressure = element.presses ? solution_(pressure_[k]) : 0;
      element.shear =
          shear_[k] >= 0 ? solution_(shear_[k]) : task_.friction * element.sign * element.pressure;
    }
  }

  /// Changes the state of all elements that violate their conditions, or of the first; returns whether there are any.
  /// An element that presses again has its former sign.
  bool changed(bool all) {
    std::vector<ElementContact::Element> next = elements_;
    bool any = false;
    for (std::size_t k = 0; k < elements_.size() && (all || !any); ++k) {
      const int place = static_cast<int>(k);
      ElementContact::Element& element = next[k];
      const int sign = element.sign;
      if (!element.presses) {
        const double gap = solution_(unknowns_ - 2) - element.e * element.e - row(place, true).dot(solution_);
        element.presses = gap > 1e-12 * solution_(unknowns_ - 2);
        any = any || element.presses;
        continue;
      }
      if (element.pressure < 0) {
        element.presses = false;
      } else if (sign == 0) {
        if (std::fabs(element.shear) > task_.friction * element.pressure)
          element.sign = element.shear > 0 ? 1 : -1;
      } else if (((row(place, false) - row(place - 1, false)).dot(solution_) - creep_ * width_) * sign > 0) {
        element.sign = 0;
      }
      any = any || !element.presses || element.sign != sign;
    }
    if (task_.traction) keep_one_sticking(next);
    elements_ = next;
    return any;
  }

  /// If no element sticks, a traction does not determine the creep. So of the elements that stuck the one farthest from
  /// slipping still sticks, or, if only one stuck, the nearest element that slips the other way.
  void keep_one_sticking(std::vector<ElementContact::Element>& next) const {
    const auto sticks = [](const auto& element) { return element.presses && element.sign == 0; };
    if (std::ranges::any_of(next, sticks)) return;
    double least = std::numeric_limits<double>::infinity();
    std::size_t kept = 0;
    for (std::size_t k = 0; k < next.size(); ++k) {
      const double ratio = std::fabs(next[k].shear) / next[k].pressure;
      if (next[k].presses && sticks(elements_[k]) && ratio < least) least = ratio, kept = k;
    }
    if (std::ranges::count_if(elements_, sticks) == 1) {
      const std::size_t alone = kept;
      const auto apart = [&](std::size_t k) { return k > alone ? k - alone : alone - k; };
      for (std::size_t k = 0; k < next.size(); ++k)
        if (next[k].presses && next[k].sign == -next[alone].sign && (kept == alone || apart(k) < apart(kept)))
          kept = k;
    }
    next[kept].sign = 0;
  }

  PartialSlipTask task_;
  std::vector<ElementContact::Element> elements_;
  double width_, creep_ = 0;
  Influence influence_;
  std::vector<int> pressure_, shear_;
  int unknowns_ = 0;
  Eigen::VectorXd solution_;
};

}  // namespace

ElementContact element_contact(const PartialSlipTask& task, int elements) {
  return ActiveSet(task, element_reach * half_length_guess(*task.load), elements).solved();
}

}  // namespace nipref::fast
