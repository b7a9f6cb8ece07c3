#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

/// How fast the error of a number falls from level to level: like the coefficients of the expansions, or like the number's
/// own differences between levels if those fall more slowly. The latter is for numbers whose error is far smaller than the
/// truncation error of the pressure.
enum class Rate { of_expansions, own };

/// A number computed from a solved contact that is to meet the accuracy.
template <class Contact>
struct AccuracyTarget {
  std::function<double(const Contact&)> number;
  double scale = 0;  ///< the accuracy is relative to the number's size, and to this at least
  double size = 0;   ///< at least this size is taken where its error is counted as one of the whole solution
  Rate rate = Rate::of_expansions;
  double error_margin = 1;  ///< its error is stated as this times the ladder's estimate
};

/// A contact solved with more and more terms, each time half as many again, until the accuracy is met. The error of
/// anything computed from it is estimated from two sources:
/// - Truncation. The truncation error of a solution is about its difference from the next solution. That of the last
///   solution is smaller by the factor by which the last coefficients of the expansions have fallen since, but it does not
///   fall faster than the expansions can converge. Several differences are used, because two successive solutions may be
///   close to each other, or to the truth, by chance.
/// - Rounding. Each solution has twins, solutions of equations that differ from its own by what rounding may do to them.
///   The rounding error is estimated from the differences between the last solution and its twins.
/// The factors of safety were chosen such that random contacts of all kinds were covered.
///
/// Levels is a kind of nip, all dimensionless as in HalfContact:
///   Contact            its solution, with half_length, load, tail (expansion_tail.hpp, in any unit) and twins,
///                      solutions of the same half length
///   Resolution         its panels and terms, and `least`: the truncation error where the expansion converges fastest
///   most               the number of levels
///   whole_share        the error of any number is at least this share of the relative error of the whole solution
///   resolution(near, level)                              for half lengths about `near`
///   is_affordable(resolution)                            a resolution that is not is used only up to the third level
///   solve(half_length, resolution, tolerance, kernels)   tolerance: of the quadrature
///   accuracy_targets(last, accuracy)                     the numbers that are to meet the accuracy
///   half_length_guess(load)                              to start from
template <class Levels>
class Ladder {
 public:
  using Contact = typename Levels::Contact;
  using Functional = std::function<double(const Contact&)>;

  /// Half length A (half-thicknesses) given.
  static Ladder at_half_length(Levels levels, double half_length, double accuracy) {
    return Ladder(std::move(levels), half_length, {}, accuracy);
  }
  /// Dimensionless load given (unit: HalfContact).
  static Ladder at_load(Levels levels, double load, double accuracy) {
    const double near = levels.half_length_guess(load);
    return Ladder(std::move(levels), near, load, accuracy);
  }

  /// Solves with more terms; false where more terms do not help, or at the last level. At first the ladder stops where its
  /// accuracy targets are met; other numbers computed from the contact may need further levels.
  bool refine() {
    const int level = static_cast<int>(solutions_.size());
    if (at_rounding_ || stagnant_levels_ == 2 || level == Levels::most) return false;
    const auto resolution = levels_.resolution(near_, level);
    if (level > 2 && !levels_.is_affordable(resolution)) return false;
    solutions_.push_back(load_ ? solve_for_load(*load_, near_, level) : solve(near_, near_, level));
    least_.push_back(resolution.least);
    if (load_) {
      near_ = half_length(last());
      // The twins' loads differ at one length: so do, at one load, the length and with it all other numbers.
      load_rounding_ = rounding_error(load_of, load_of(last())) / *load_;
    }
    if (level < 2) return true;
    const double before = std::exchange(asked_, assess()).sum();
    if (!std::isfinite(asked_.sum())) {
      throw data::BadInput("contact's half length", half_length(last()),
                           "in half-thicknesses, must be one that can be solved in double with this sheet");
    }
    // Where more terms do not help twice in succession, the error has stagnated at rounding.
    stagnant_levels_ = asked_.sum() < 1e-6 && asked_.sum() > 0.5 * before ? stagnant_levels_ + 1 : 0;
    return true;
  }

  /// The value on the last solution and an estimate of its error. The estimate is no less than a share of the error of the
  /// whole solution, and no less than the effect of the load's last residual; both are relative to `scale`, or to the value
  /// if that is larger.
  [[nodiscard]] Estimate estimate(const Functional& functional, double scale = 0,
                                  Rate rate = Rate::of_expansions) const {
    const double value = functional(last()), rounded = rounding_error(functional, value);
    return estimate(value, {expansion_error(functional, rounded, rate), rounded}, 0.1, scale);
  }
  /// The same for a functional that costs kernel values and rounds no worse than the solution: it is not evaluated on
  /// the twins.
  [[nodiscard]] Estimate estimate_of_integral(const Functional& functional, double scale) const {
    return estimate(functional(last()), {expansion_error(functional, 0, Rate::of_expansions), 0}, 1, scale);
  }
  /// The same for one of several functionals of which the largest error is taken: the twins cannot agree on all of them
  /// by chance, so no share of the whole solution's rounding error is added.
  [[nodiscard]] Estimate estimate_of_several(const Functional& functional, double scale) const {
    const double value = functional(last()), rounded = rounding_error(functional, value);
    return estimate(value, {expansion_error(functional, rounded, Rate::of_expansions), rounded}, 0, scale);
  }
  /// The same for a functional that decays outside the contact from `scale` to `faded`. The estimate is no less than the
  /// rounding error at the size `scale`.
  [[nodiscard]] Estimate estimate_of_fading(const Functional& functional, double scale, double faded) const {
    const Estimate fading = estimate_of_integral(functional, faded);
    return {fading.value, std::max(fading.error, rounding * scale)};
  }
  /// The same for a functional whose value may be far smaller than A though its rounding is not: the accuracy
  /// is asked of the value itself, and rounding is relative to A.
  [[nodiscard]] Estimate estimate_down_to_rounding(const Functional& functional) const {
    const Estimate relative = estimate(functional, 0, Rate::own);
    return {relative.value, std::max(relative.error, rounding * half_length(last()))};
  }

  /// The truncation error of a functional, without rounding.
  [[nodiscard]] double truncation_error(const Functional& functional) const {
    return expansion_error(functional, 0, Rate::of_expansions);
  }

  [[nodiscard]] const Contact& last() const { return *solutions_.back(); }
  /// The kernels for what is computed from the solutions.
  [[nodiscard]] CountedKernels kernels() const { return {Accuracy(), *work_}; }
  /// The tolerance of all quadratures. It is far below the accuracy, since the differences between solutions do not show
  /// the errors of quadrature.
  static constexpr double tolerance() { return 1e-16; }
  [[nodiscard]] const Work& work() const { return *work_; }

 private:
  using Solution = std::unique_ptr<Contact>;
  struct Error {
    double of_expansion = 0;
    double of_rounding = 0;
    [[nodiscard]] double sum() const { return of_expansion + of_rounding; }
    /// Takes the larger of this and of `other` relative to `size`.
    void enlarge(const Error& other, double size) {
      of_expansion = std::max(of_expansion, other.of_expansion / size);
      of_rounding = std::max(of_rounding, other.of_rounding / size);
    }
  };
  /// The relative rounding error of a solution in double.
  static constexpr double rounding = 0x1p-48;

  Ladder(Levels levels, double near, std::optional<double> load, double accuracy)
      : levels_(std::move(levels)), near_(near), load_(load), accuracy_(accuracy) {
    while (!settled_ && refine()) {
    }
  }

  static double load_of(const Contact& contact) { return std::invoke(&Contact::load, contact); }
  static double half_length(const Contact& contact) { return std::invoke(&Contact::half_length, contact); }

  Solution solve(double half_length, double near, int level) const {
    CountedKernels kernels(Accuracy(), *work_);
    return levels_.solve(half_length, levels_.resolution(near, level), tolerance(), kernels);
  }

  Solution solve_for_load(double load, double near, int level) {
    for (LengthSearch search(load, near, {load_tolerance(near, level), longest_sought}, exponent_);;) {
      const double half_length = search.length();
      // The layout of the panels follows large steps only, because a new layout makes the load jump.
      if (level == 0 && std::fabs(std::log(half_length / near)) > 0.3) near = half_length;
      Solution contact = solve(half_length, near, level);
      const bool settled = search.settled(load_of(*contact));
      load_residual_ = search.residual();
      exponent_ = search.exponent();
      if (!settled) continue;
      if (!std::isfinite(load_residual_))
        throw data::BadInput("load", load, "over its unit, must be one for which a contact length is found");
      return contact;
    }
  }
  /// The load is met to within the truncation error of the level and, until the accuracy is met, to within a hundredth of
  /// the accuracy; rounding allows no better than the distance of the twins.
  [[nodiscard]] double load_tolerance(double near, int level) const {
    const double rounds = solutions_.empty() ? 0 : twins_apart(load_of, load_of(last())) / load_of(last());
    return std::max(
        {settled_ ? 0 : 1e-2 * accuracy_, 1e-2 * levels_.resolution(near, level).least, 1e-14, rounds});
  }

  /// `rounding_share`: this share of the whole solution's rounding error is always added, because the twins may agree by
  /// chance.
  [[nodiscard]] Estimate estimate(double value, const Error& own, double rounding_share, double scale) const {
    const double least = std::max({Levels::whole_share * whole_.of_expansion, 3 * load_residual_, rounding}) +
                         rounding_share * whole_.of_rounding + load_rounding_;
    return {value, std::max(own.sum(), least * std::max(scale, std::fabs(value)))};
  }
  /// The truncation error of each solution is about its difference from the next, less the part of it that rounding,
  /// `rounded`, may have made. A part of that error remains in the last solution.
  [[nodiscard]] double expansion_error(const Functional& functional, double rounded, Rate rate) const {
    const double safety = rate == Rate::own ? 8 : 7;
    std::vector<double> values;
    for (const Solution& solution : solutions_) values.push_back(functional(*solution));
    const std::size_t last = values.size() - 1;
    const auto step = [&](std::size_t i) { return std::fabs(values[i] - values[i - 1]); };
    double left = 0, kept = 1;
    for (std::size_t i = last; i > 0 && i + 3 > last; --i) {
      double of_one = kept_since(i - 1);
      if (rate == Rate::own) {
        // Two successive differences may fall apart by chance: then the pair of differences before is used.
        of_one = std::pow(of_one, 0.9);
        if (i > 1) of_one = std::max(of_one, kept_of_own(step(i), step(i - 1), last == 2));
      }
      kept *= of_one;
      left = std::max(left, (step(i) - rounded) * kept);
    }
    return safety * left;
  }
  /// The part of the error of solution `i` that remains in the next, estimated roughly from the last coefficients.
  [[nodiscard]] double kept_since(std::size_t i) const {
    const auto tail = [&](std::size_t k) { return std::invoke(&Contact::tail, *solutions_[k]); };
    const double fastest = least_[i + 1] / least_[i];
    if (tail(i + 1) <= fastest * tail(i)) return std::pow(fastest, 0.95);
    return tail(i + 1) < tail(i) ? std::pow(tail(i + 1) / tail(i), 0.95) : 1;
  }
  /// The same from two successive differences: they fall geometrically in the number of terms, which grows by a half from
  /// level to level. This, too, is a rough estimate, and a poor one where there are only two differences (`no_more`).
  static double kept_of_own(double difference, double before, bool no_more) {
    return difference < before ? std::pow(difference / before, (no_more ? 0.5 : 0.95) * 1.5) : 1;
  }
  [[nodiscard]] double rounding_error(const Functional& functional, double value) const {
    constexpr double safety = 12;
    return safety * twins_apart(functional, value);
  }
  /// The root mean square of the differences between the twins' values and `value`.
  [[nodiscard]] double twins_apart(const Functional& functional, double value) const {
    double squares = 0;
    for (const auto& twin : last().twins) squares += std::pow(functional(*twin) - value, 2);
    return squares == 0 ? 0 : std::sqrt(squares / static_cast<double>(last().twins.size()));
  }
  /// The largest relative error of the accuracy targets. Sets the error of the whole solution, and whether each target is
  /// met or limited by rounding.
  Error assess() {
    Error asked;
    whole_ = {};
    settled_ = at_rounding_ = true;
    for (const AccuracyTarget<Contact>& target : levels_.accuracy_targets(last(), accuracy_)) {
      const double value = target.number(last()), rounded = rounding_error(target.number, value);
      const Error own{expansion_error(target.number, rounded, target.rate), rounded};
      const double size = std::max(target.scale, std::fabs(value));
      if (std::isnan(own.sum() / size)) return {own.sum() / size, 0};
      // Three times, because the estimate of the truncation error is the more cautious one.
      const bool rounded_only = own.of_expansion <= 3 * own.of_rounding;
      settled_ &= target.error_margin * own.sum() <= accuracy_ * size || rounded_only;
      at_rounding_ &= rounded_only;
      asked.enlarge(own, size);
      whole_.enlarge(own, std::max(target.size, size));
    }
    return asked;
  }

  Levels levels_;
  double near_;  ///< half length for which the next level is laid out; given if no load is
  std::optional<double> load_;
  double accuracy_;
  std::unique_ptr<Work> work_ = std::make_unique<Work>();
  std::vector<Solution> solutions_;
  std::vector<double> least_;  ///< the least truncation error of each
  Error asked_{1, 0};          ///< the largest of the accuracy targets, relative
  bool settled_ = false, at_rounding_ = false;
  int stagnant_levels_ = 0;
  Error whole_;  ///< of the solution as a whole, relative
  double load_residual_ = 0;
  double load_rounding_ = 0;  ///< relative, where the load is given
  double exponent_ = LengthSearch::usual_exponent;
};

}  // namespace nipref::fast
