#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

/// A number computed from a solved contact, and the least size that its error is measured by.
template <class Contact>
struct Judged {
  std::function<double(const Contact&)> number;
  double scale = 0;
};

/// A contact solved with more and more terms, each time half as many again, until the accuracy is met; the
/// last three solutions are kept, and what they differ by estimates the error of anything computed from them.
///
/// Levels is a kind of nip, all dimensionless as in HalfContact:
///   Contact            its solution, with half_length and load
///   Resolution         what resolves it, with `remainder`: about the size of what its expansion leaves out
///   most               levels there are
///   whole_share        how much of what the solution as a whole lacks is the least error of any number of it
///   resolution(near, level)                              for half lengths about `near`
///   is_affordable(resolution)                            where it is not, three levels must do
///   solve(half_length, resolution, tolerance, kernels)   tolerance: of the quadrature
///   judged(last, accuracy)                               the numbers that are to meet the accuracy
///   half_length_guess(load)                              to start from
template <class Levels>
class Ladder {
 public:
  using Contact = typename Levels::Contact;
  using Functional = std::function<double(const Contact&)>;

  /// Half length A (half-thicknesses) given.
  static Ladder at_half_length(Levels levels, double half_length, double accuracy) {
    Ladder ladder(std::move(levels), accuracy);
    ladder.climb(half_length, [&](double near, int level) { return ladder.solve(half_length, near, level); });
    return ladder;
  }
  /// Dimensionless load given (unit: HalfContact).
  static Ladder at_load(Levels levels, double load, double accuracy) {
    Ladder ladder(std::move(levels), accuracy);
    ladder.climb(ladder.levels_.half_length_guess(load),
                 [&](double near, int level) { return ladder.solve_for_load(load, near, level); });
    return ladder;
  }

  /// Value on the last solution and an estimate of its error: see estimate_from_levels; not less than a share
  /// of what the whole solution is estimated to lack, nor than what rounding, the kernels' own tolerance and
  /// the load's last residual make, all relative to `scale` (the value itself if that is larger).
  [[nodiscard]] Estimate estimate(const Functional& functional, double scale = 0) const {
    const Estimate own = own_estimate(functional);
    // The kernels are good to ten times that, and the errors of many values mostly cancel.
    const double kernels = 1e-5 * accuracy_;
    const double least =
        std::max({Levels::whole_share * relative_error_, kernels, 3 * load_residual_, rounding});
    return {own.value, std::max(own.error, least * std::max(scale, std::fabs(own.value)))};
  }
  /// The same for a functional whose value may be far smaller than A though its rounding is not: the accuracy
  /// is asked of the value itself, and rounding is relative to A.
  [[nodiscard]] Estimate estimate_down_to_rounding(const Functional& functional) const {
    const Estimate relative = estimate(functional);
    return {relative.value, std::max(relative.error, rounding * half_length(last()))};
  }

  [[nodiscard]] const Contact& last() const { return *solutions_[2]; }
  /// For what is computed from the solutions.
  [[nodiscard]] CountedKernels kernels() const {
    return {Accuracy(std::max(tolerance(), Accuracy::best_rtol)), *work_};
  }
  /// Of the quadrature of what is computed from the solutions: stricter than theirs, for their differences do
  /// not show it.
  [[nodiscard]] double tolerance() const { return std::max(1e-6 * accuracy_, 1e-16); }
  [[nodiscard]] const Work& work() const { return *work_; }

 private:
  using Solution = std::unique_ptr<Contact>;
  /// Of a solution in double, relative.
  static constexpr double rounding = 0x1p-48;

  Ladder(Levels levels, double accuracy) : levels_(std::move(levels)), accuracy_(accuracy) {}

  static double half_length(const Contact& contact) { return std::invoke(&Contact::half_length, contact); }

  /// step(near, level): solution number `level`, its terms laid out for a half length near `near`.
  template <class Step>
  void climb(double near, const Step& step) {
    int in_vain = 0;  // levels
    for (int level = 0; level < Levels::most; ++level) {
      if (level > 2 && !levels_.is_affordable(levels_.resolution(near, level))) return;
      std::ranges::rotate(solutions_, solutions_.begin() + 1);
      solutions_[2] = step(near, level);
      near = half_length(last());
      if (level < 2) continue;
      const double before = std::exchange(relative_error_, largest_relative_error());
      if (!std::isfinite(relative_error_)) {
        throw data::BadInput("contact's half length", near,
                             "in half-thicknesses, must be one that can be solved in double with this sheet");
      }
      // Where more terms twice do not help, rounding is what is left.
      in_vain = relative_error_ < 1e-6 && relative_error_ > 0.5 * before ? in_vain + 1 : 0;
      if (relative_error_ <= accuracy_ || in_vain == 2) return;
    }
  }

  /// Kernels and quadrature are as good as the expansion, so that the differences between levels tell of them
  /// too.
  Solution solve(double half_length, double near, int level) const {
    const auto resolution = levels_.resolution(near, level);
    const double tolerance = std::max(1e-2 * resolution.remainder, 1e-16);
    CountedKernels kernels(Accuracy(std::max({tolerance, 1e-4 * accuracy_, Accuracy::best_rtol})), *work_);
    return levels_.solve(half_length, resolution, tolerance, kernels);
  }

  Solution solve_for_load(double load, double near, int level) {
    for (LengthSearch search(load, near, {load_tolerance(near, level), longest_sought}, exponent_);;) {
      const double half_length = search.length();
      // The layout follows large steps only: it makes the load jump.
      if (level == 0 && std::fabs(std::log(half_length / near)) > 0.3) near = half_length;
      Solution contact = solve(half_length, near, level);
      const bool settled = search.settled(std::invoke(&Contact::load, *contact));
      load_residual_ = search.residual();
      exponent_ = search.exponent();
      if (!settled) continue;
      if (!std::isfinite(load_residual_))
        throw data::BadInput("load", load, "over its unit, must be one for which a contact length is found");
      return contact;
    }
  }
  /// The first level is only compared with the next: it need not meet the load better than its expansion
  /// meets the pressure.
  [[nodiscard]] double load_tolerance(double near, int level) const {
    const double first = level == 0 ? 1e-2 * levels_.resolution(near, level).remainder : 0;
    return std::max({1e-2 * accuracy_, first, 1e-14});
  }

  [[nodiscard]] Estimate own_estimate(const Functional& functional) const {
    std::array<double, 3> values{};
    std::ranges::transform(solutions_, values.begin(),
                           [&](const Solution& contact) { return functional(*contact); });
    return estimate_from_levels(values);
  }
  [[nodiscard]] double largest_relative_error() const {
    double largest = 0;
    for (const Judged<Contact>& judged : levels_.judged(last(), accuracy_)) {
      const Estimate estimate = own_estimate(judged.number);
      const double relative = estimate.error / std::max(judged.scale, std::fabs(estimate.value));
      if (std::isnan(relative)) return relative;
      largest = std::max(largest, relative);
    }
    return largest;
  }

  Levels levels_;
  double accuracy_;
  std::unique_ptr<Work> work_ = std::make_unique<Work>();
  std::array<Solution, 3> solutions_;
  double relative_error_ = 1;
  double load_residual_ = 0;
  double exponent_ = LengthSearch::usual_exponent;
};

}  // namespace nipref::fast
