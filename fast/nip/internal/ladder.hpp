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

/// How fast the truncation error of a number is taken to fall from level to level: like the last coefficients of the
/// expansions, or no faster than the differences of the number itself. The second is for numbers whose error is far
/// smaller than the truncation error of the pressure.
enum class Rate { of_expansions, own };

/// A number computed from a solved contact that is to meet the accuracy.
template <class Contact>
struct AccuracyTarget {
  std::function<double(const Contact&)> number;
  double scale = 0;  ///< the accuracy is relative to the value or to this, whichever is larger
  double size = 0;   ///< likewise what its error counts relative to in the error of the whole solution
  Rate rate = Rate::of_expansions;
  double error_margin = 1;  ///< its stated error over the ladder's estimate
};

/// A contact solved on levels, each with half as many terms again as the one before, until the accuracy is met. The
/// error of a number computed from it has two parts:
/// - The truncation error. The error of a solution is about its difference from the next one. On the last level it is
///   smaller by the factor by which the expansions' last coefficients have fallen since, but by no more than the
///   expansions can converge at best. Several differences are used, because two successive solutions may agree by
///   chance.
/// - Rounding: the spread of the number over the twins of the last solution, whose equations differ from its own by
///   possible roundings.
/// The factors of safety are those that covered the errors of random contacts of all kinds.
///
/// Levels describes a kind of nip; all quantities are dimensionless as in HalfContact:
///   Contact            a solution, with half_length, load, tail (expansion_tail.hpp, in any unit) and twins, which are
///                      solutions of the same half length
///   Resolution         how a level is resolved; `least` is its truncation error where the expansion converges fastest
///   most               the number of levels
///   whole_share        the error of a number is at least this share of the error of the whole solution
///   resolution(near, level)                              for half lengths about `near`
///   is_affordable(resolution)                            the first three levels are solved even where it is not
///   solve(half_length, resolution, tolerance, kernels)   tolerance: of the quadrature
///   accuracy_targets(last, accuracy)                     the numbers that have to meet the accuracy
///   half_length_guess(load)                              where the search for the load starts
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

  /// Solves the next level; false if that would not help or there is none. The constructor stops where the accuracy
  /// targets are met; other numbers may need more levels.
  bool refine() {
    const int level = static_cast<int>(solutions_.size());
    if (at_rounding_ || stagnant_levels_ == 2 || level == Levels::most) return false;
    const auto resolution = levels_.resolution(near_, level);
    if (level > 2 && !levels_.is_affordable(resolution)) return false;
    solutions_.push_back(load_ ? solve_for_load(*load_, near_, level) : solve(near_, near_, level));
    least_.push_back(resolution.least);
    if (load_) {
      near_ = half_length(last());
      // The twins have this length but other loads. At a given load that is an uncertainty of the length, and with it
      // of every number.
      load_rounding_ = rounding_error(load_of, load_of(last())) / *load_;
    }
    if (level < 2) return true;
    const double before = std::exchange(asked_, assess()).sum();
    if (!std::isfinite(asked_.sum())) {
      throw data::BadInput("contact's half length", half_length(last()),
                           "in half-thicknesses, must be one that can be solved in double with this sheet");
    }
    // If two levels in succession do not halve an error below 1e-6, it is rounding.
    stagnant_levels_ = asked_.sum() < 1e-6 && asked_.sum() > 0.5 * before ? stagnant_levels_ + 1 : 0;
    return true;
  }

  /// The value on the last solution and an estimate of its error. Relative to `scale`, or to the value if that is
  /// larger, the error is at least a share of that of the whole solution and at least what the residual of the load
  /// causes.
  [[nodiscard]] Estimate estimate(const Functional& functional, double scale = 0,
                                  Rate rate = Rate::of_expansions) const {
    const double value = functional(last()), rounded = rounding_error(functional, value);
    return estimate(value, {truncation_error(functional, rounded, rate), rounded}, 0.1, scale);
  }
  /// The same for a functional that needs kernel values and rounds no worse than the solution: it is not evaluated on
  /// the twins.
  [[nodiscard]] Estimate estimate_of_integral(const Functional& functional, double scale) const {
    return estimate(functional(last()), {truncation_error(functional), 0}, 1, scale);
  }
  /// The same for one of several functionals of which the largest error is used: their twins do not all agree by
  /// chance.
  [[nodiscard]] Estimate estimate_of_several(const Functional& functional, double scale) const {
    const double value = functional(last()), rounded = rounding_error(functional, value);
    return estimate(value, {truncation_error(functional, rounded), rounded}, 0, scale);
  }
  /// The same for a functional that decays outside the contact from the size `scale` to `faded`: its error is relative
  /// to `faded`, but not below the rounding of `scale`.
  [[nodiscard]] Estimate estimate_of_fading(const Functional& functional, double scale, double faded) const {
    const Estimate fading = estimate_of_integral(functional, faded);
    return {fading.value, std::max(fading.error, rounding * scale)};
  }
  /// The same for a functional that may be far smaller than the half length A while its rounding is relative to A: the
  /// accuracy is relative to the value.
  [[nodiscard]] Estimate estimate_down_to_rounding(const Functional& functional) const {
    const Estimate relative = estimate(functional, 0, Rate::own);
    return {relative.value, std::max(relative.error, rounding * half_length(last()))};
  }

  /// The truncation error of a functional. The error of a solution is about its difference from the next one; it is
  /// multiplied by the factors by which errors have fallen from there to the last level. `rounded`: what rounding may
  /// contribute to a difference.
  [[nodiscard]] double truncation_error(const Functional& functional, double rounded = 0,
                                        Rate rate = Rate::of_expansions) const {
    const double safety = rate == Rate::own ? 8 : 7;
    std::vector<double> values;
    for (const Solution& solution : solutions_) values.push_back(functional(*solution));
    const std::size_t last = values.size() - 1;
    const auto step = [&](std::size_t i) { return std::fabs(values[i] - values[i - 1]); };
    double largest = 0, remaining = 1;
    for (std::size_t i = last; i > 0 && i + 3 > last; --i) {
      double factor = fall_of_coefficients(i - 1);
      if (rate == Rate::own) {
        // The ratio of two successive differences may be small by chance: the coefficients limit it from below.
        factor = std::pow(factor, 0.9);
        if (i > 1) factor = std::max(factor, fall_of_differences(step(i), step(i - 1), last == 2));
      }
      remaining *= factor;
      largest = std::max(largest, (step(i) - rounded) * remaining);
    }
    return safety * largest;
  }

  [[nodiscard]] const Contact& last() const { return *solutions_.back(); }
  /// For functionals of the solutions.
  [[nodiscard]] CountedKernels kernels() const { return {Accuracy(), *work_}; }
  /// Of the quadratures in solutions and functionals. Differences between levels do not show their errors.
  static constexpr double tolerance() { return 1e-16; }
  [[nodiscard]] const Work& work() const { return *work_; }

 private:
  using Solution = std::unique_ptr<Contact>;
  struct Error {
    double truncation = 0;
    double rounding = 0;
    [[nodiscard]] double sum() const { return truncation + rounding; }
    /// Makes neither part smaller than that of `other` relative to `size`.
    void enlarge(const Error& other, double size) {
      truncation = std::max(truncation, other.truncation / size);
      rounding = std::max(rounding, other.rounding / size);
    }
  };
  /// Relative rounding of a solution in double.
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
      // The layout follows only large changes of the length: with each new layout the load jumps.
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
  /// The load need not be met better than the level's truncation error, nor, before the accuracy is met, better than
  /// the accuracy needs. It cannot be met better than its rounding.
  [[nodiscard]] double load_tolerance(double near, int level) const {
    const double rounds = solutions_.empty() ? 0 : twin_spread(load_of, load_of(last())) / load_of(last());
    return std::max(
        {settled_ ? 0 : 1e-2 * accuracy_, 1e-2 * levels_.resolution(near, level).least, 1e-14, rounds});
  }

  /// `rounding_share`: the error is at least this share of the whole solution's rounding, for the twins of one number
  /// may agree by chance.
  [[nodiscard]] Estimate estimate(double value, const Error& own, double rounding_share, double scale) const {
    const double least = std::max({Levels::whole_share * whole_.truncation, 3 * load_residual_, rounding}) +
                         rounding_share * whole_.rounding + load_rounding_;
    return {value, std::max(own.sum(), least * std::max(scale, std::fabs(value)))};
  }
  /// The factor by which the truncation error falls from level i to the next, by the last coefficients. They are a
  /// rough measure of it, hence the powers of 0.95.
  [[nodiscard]] double fall_of_coefficients(std::size_t i) const {
    const auto tail = [&](std::size_t k) { return std::invoke(&Contact::tail, *solutions_[k]); };
    const double fastest = least_[i + 1] / least_[i];
    if (tail(i + 1) <= fastest * tail(i)) return std::pow(fastest, 0.95);
    return tail(i + 1) < tail(i) ? std::pow(tail(i + 1) / tail(i), 0.95) : 1;
  }
  /// The same factor by two successive differences. They fall geometrically in the number of terms, and the next level
  /// adds half as many terms again as the last one did. This is a rough measure too, and a bad one if it is the only
  /// pair.
  static double fall_of_differences(double difference, double before, bool is_only_pair) {
    return difference < before ? std::pow(difference / before, (is_only_pair ? 0.5 : 0.95) * 1.5) : 1;
  }
  [[nodiscard]] double rounding_error(const Functional& functional, double value) const {
    constexpr double safety = 12;
    return safety * twin_spread(functional, value);
  }
  /// The root mean square of the twins' differences from `value`.
  [[nodiscard]] double twin_spread(const Functional& functional, double value) const {
    double squares = 0;
    for (const auto& twin : last().twins) squares += std::pow(functional(*twin) - value, 2);
    return squares == 0 ? 0 : std::sqrt(squares / static_cast<double>(last().twins.size()));
  }
  /// The largest relative error of the accuracy targets. Also finds the error of the whole solution, and whether each
  /// number is as accurate as was asked or as its rounding allows.
  Error assess() {
    Error asked;
    whole_ = {};
    settled_ = at_rounding_ = true;
    for (const AccuracyTarget<Contact>& target : levels_.accuracy_targets(last(), accuracy_)) {
      const double value = target.number(last()), rounded = rounding_error(target.number, value);
      const Error own{truncation_error(target.number, rounded, target.rate), rounded};
      const double size = std::max(target.scale, std::fabs(value));
      if (std::isnan(own.sum() / size)) return {own.sum() / size, 0};
      // The factor is 3 because the estimate of the truncation error has the larger margin of safety.
      const bool rounded_only = own.truncation <= 3 * own.rounding;
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
  std::vector<double> least_;  ///< truncation error of each at best
  Error asked_{1, 0};          ///< of the accuracy targets, relative to what the accuracy is relative to
  bool settled_ = false, at_rounding_ = false;
  int stagnant_levels_ = 0;  ///< successive levels that did not make the error smaller
  Error whole_;              ///< of the solution as a whole, relative
  double load_residual_ = 0;
  double load_rounding_ = 0;  ///< relative, where the load is given
  double exponent_ = LengthSearch::usual_exponent;
};

}  // namespace nipref::fast
