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

/// By what the error of a number falls from level to level: by what the expansions' coefficients do, or not faster than
/// its own differences, where what is left of it is far less than what the expansions leave out of the pressure.
enum class Rate { of_expansions, own };

/// A number computed from a solved contact.
template <class Contact>
struct Judged {
  std::function<double(const Contact&)> number;
  double scale = 0;  ///< the least size that the accuracy is asked relative to
  double size = 0;   ///< the least size by which it tells what the whole solution lacks
  Rate rate = Rate::of_expansions;
  double error_margin = 1;  ///< what is said of its error, over the ladder's estimate
};

/// A contact solved with more and more terms, each time half as many again, until the accuracy is met. The error
/// of anything computed from it is estimated from two sides:
/// - what the expansion leaves out: each solution lacks about what it differs by from the next, and the last one
///   lacks that less by what the expansions' last coefficients have fallen since, if not faster than the expansions
///   can converge. Several differences are asked, for two solutions in succession may be near each other, or near
///   the truth, by chance;
/// - rounding: how much it changes on the last solution's twins, whose equations differ from its own by what
///   rounding may do to them.
/// The factors of safety are those with which random contacts of all kinds were covered.
///
/// Levels is a kind of nip, all dimensionless as in HalfContact:
///   Contact            its solution, with half_length, load, tail (expansion_tail.hpp, in any unit) and twins,
///                      solutions of the same half length
///   Resolution         what resolves it, with `least`: what its expansion leaves out where it converges fastest
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
    return Ladder(std::move(levels), half_length, {}, accuracy);
  }
  /// Dimensionless load given (unit: HalfContact).
  static Ladder at_load(Levels levels, double load, double accuracy) {
    const double near = levels.half_length_guess(load);
    return Ladder(std::move(levels), near, load, accuracy);
  }

  /// Solves with more terms; false where these do not help, or there are no more. The accuracy says only where the ladder
  /// stops at first, by the numbers that are judged: what else is computed may need more.
  bool refine() {
    const int level = static_cast<int>(solutions_.size());
    if (at_rounding_ || stagnant_levels_ == 2 || level == Levels::most) return false;
    const auto resolution = levels_.resolution(near_, level);
    if (level > 2 && !levels_.is_affordable(resolution)) return false;
    solutions_.push_back(load_ ? solve_for_load(*load_, near_, level) : solve(near_, near_, level));
    least_.push_back(resolution.least);
    if (load_) {
      near_ = half_length(last());
      // Twins carry another load: what they say of the length, and with it of all others.
      load_rounding_ = rounding_error(load_of, load_of(last())) / *load_;
    }
    if (level < 2) return true;
    const double before = std::exchange(asked_, judge()).sum();
    if (!std::isfinite(asked_.sum())) {
      throw data::BadInput("contact's half length", half_length(last()),
                           "in half-thicknesses, must be one that can be solved in double with this sheet");
    }
    // Where more terms twice do not help, rounding is what is left.
    stagnant_levels_ = asked_.sum() < 1e-6 && asked_.sum() > 0.5 * before ? stagnant_levels_ + 1 : 0;
    return true;
  }

  /// Value on the last solution and an estimate of its error; not less than a share of what the whole solution is
  /// estimated to lack, nor than what the load's last residual makes, all relative to `scale` (the value itself if
  /// that is larger).
  [[nodiscard]] Estimate estimate(const Functional& functional, double scale = 0,
                                  Rate rate = Rate::of_expansions) const {
    const double value = functional(last()), rounded = rounding_error(functional, value);
    return estimate(value, {expansion_error(functional, rounded, rate), rounded}, 0.1, scale);
  }
  /// The same for a functional that costs kernel values and rounds no worse than the solution: its twins are spared.
  [[nodiscard]] Estimate estimate_of_integral(const Functional& functional, double scale) const {
    return estimate(functional(last()), {expansion_error(functional, 0, Rate::of_expansions), 0}, 1, scale);
  }
  /// The same for one of several, the largest of which counts: their twins do not all agree by chance.
  [[nodiscard]] Estimate estimate_of_several(const Functional& functional, double scale) const {
    const double value = functional(last()), rounded = rounding_error(functional, value);
    return estimate(value, {expansion_error(functional, rounded, Rate::of_expansions), rounded}, 0, scale);
  }
  /// The same for one that fades outside the contact from `scale` to `faded`, with all that the solution lacks, but
  /// not below what rounds where it has not faded.
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

  /// What the expansions leave out of a functional alone.
  [[nodiscard]] double left_out(const Functional& functional) const {
    return expansion_error(functional, 0, Rate::of_expansions);
  }

  [[nodiscard]] const Contact& last() const { return *solutions_.back(); }
  /// For what is computed from the solutions.
  [[nodiscard]] CountedKernels kernels() const { return {Accuracy(), *work_}; }
  /// Of the quadrature of the solutions and of what is computed from them: their differences do not show it.
  static constexpr double tolerance() { return 1e-16; }
  [[nodiscard]] const Work& work() const { return *work_; }

 private:
  using Solution = std::unique_ptr<Contact>;
  struct Error {
    double of_expansion = 0;
    double of_rounding = 0;
    [[nodiscard]] double sum() const { return of_expansion + of_rounding; }
    /// To what `other` is of `size`.
    void enlarge(const Error& other, double size) {
      of_expansion = std::max(of_expansion, other.of_expansion / size);
      of_rounding = std::max(of_rounding, other.of_rounding / size);
    }
  };
  /// Of a solution in double, relative.
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
      // The layout follows large steps only: it makes the load jump.
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
  /// A level need not meet the load better than its expansion meets the pressure, nor, until the accuracy is met, than
  /// that needs, and cannot better than it rounds.
  [[nodiscard]] double load_tolerance(double near, int level) const {
    const double rounds = solutions_.empty() ? 0 : twins_apart(load_of, load_of(last())) / load_of(last());
    return std::max(
        {settled_ ? 0 : 1e-2 * accuracy_, 1e-2 * levels_.resolution(near, level).least, 1e-14, rounds});
  }

  /// `rounding_share`: of the whole solution's rounding at least, for the twins may agree by chance.
  [[nodiscard]] Estimate estimate(double value, const Error& own, double rounding_share, double scale) const {
    const double least = std::max({Levels::whole_share * whole_.of_expansion, 3 * load_residual_, rounding}) +
                         rounding_share * whole_.of_rounding + load_rounding_;
    return {value, std::max(own.sum(), least * std::max(scale, std::fabs(value)))};
  }
  /// Each solution lacks about what it differs by from the next; of that the last one has kept a part. A difference is
  /// told by what it is larger than `rounded`, what rounding may make.
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
        // Two differences in succession may be far apart by chance: then the one before must do.
        of_one = std::pow(of_one, 0.9);
        if (i > 1) of_one = std::max(of_one, kept_of_own(step(i), step(i - 1), last == 2));
      }
      kept *= of_one;
      left = std::max(left, (step(i) - rounded) * kept);
    }
    return safety * left;
  }
  /// What of the error of solution `i` is left in the next; the last coefficients tell it but roughly.
  [[nodiscard]] double kept_since(std::size_t i) const {
    const auto tail = [&](std::size_t k) { return std::invoke(&Contact::tail, *solutions_[k]); };
    const double fastest = least_[i + 1] / least_[i];
    if (tail(i + 1) <= fastest * tail(i)) return std::pow(fastest, 0.95);
    return tail(i + 1) < tail(i) ? std::pow(tail(i + 1) / tail(i), 0.95) : 1;
  }
  /// The same by two differences in succession: they fall geometrically in the number of terms, of which half
  /// as many again are added next time; this, too, tells it but roughly, and hardly where there are no more than two.
  static double kept_of_own(double difference, double before, bool no_more) {
    return difference < before ? std::pow(difference / before, (no_more ? 0.5 : 0.95) * 1.5) : 1;
  }
  [[nodiscard]] double rounding_error(const Functional& functional, double value) const {
    constexpr double safety = 12;
    return safety * twins_apart(functional, value);
  }
  /// Root mean square of what they differ by from `value`.
  [[nodiscard]] double twins_apart(const Functional& functional, double value) const {
    double squares = 0;
    for (const auto& twin : last().twins) squares += std::pow(functional(*twin) - value, 2);
    return squares == 0 ? 0 : std::sqrt(squares / static_cast<double>(last().twins.size()));
  }
  /// The largest relative error of the numbers that are judged; what the whole solution lacks, and whether each number
  /// is as accurate as was asked or as its rounding lets, on the way.
  Error judge() {
    Error asked;
    whole_ = {};
    settled_ = at_rounding_ = true;
    for (const Judged<Contact>& judged : levels_.judged(last(), accuracy_)) {
      const double value = judged.number(last()), rounded = rounding_error(judged.number, value);
      const Error own{expansion_error(judged.number, rounded, judged.rate), rounded};
      const double size = std::max(judged.scale, std::fabs(value));
      if (std::isnan(own.sum() / size)) return {own.sum() / size, 0};
      // By three times, for what the expansion leaves out is the safer estimate.
      const bool rounded_only = own.of_expansion <= 3 * own.of_rounding;
      settled_ &= judged.error_margin * own.sum() <= accuracy_ * size || rounded_only;
      at_rounding_ &= rounded_only;
      asked.enlarge(own, size);
      whole_.enlarge(own, std::max(judged.size, size));
    }
    return asked;
  }

  Levels levels_;
  double near_;  ///< half length for which the next level is laid out; given if no load is
  std::optional<double> load_;
  double accuracy_;
  std::unique_ptr<Work> work_ = std::make_unique<Work>();
  std::vector<Solution> solutions_;
  std::vector<double> least_;  ///< left out by each
  Error asked_{1, 0};          ///< of the numbers judged, relative to what the accuracy is asked of
  bool settled_ = false, at_rounding_ = false;
  int stagnant_levels_ = 0;  ///< levels
  Error whole_;      ///< of the solution as a whole, relative
  double load_residual_ = 0;
  double load_rounding_ = 0;  ///< relative, where the load is given
  double exponent_ = LengthSearch::usual_exponent;
};

}  // namespace nipref::fast
