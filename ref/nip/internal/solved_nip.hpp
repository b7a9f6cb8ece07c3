#pragma once
#include <algorithm>
#include <functional>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/number/with_error.hpp>
#include <nipref/ref/nip/internal/nip_solution.hpp>

namespace nipref::ref {

/// A contact solved twice, with other panels, other numbers of terms and other nodes, and again with more of them until both
/// agree to the digits asked for. `Model` is a kind of nip: Model::Solution, what it is solved to; and
///     solved(half_length, panels, nats of the quadrature, kernels), unknowns(panels), resolution(), lost_digits().
///
/// The result of a functional is that of the finer solution. Its error is estimated, not proven: twice the difference of the
/// two, and of the scale of its kind the largest difference of load, length, displacement and tractions anywhere and a
/// hundredth of the last digit.
template <class Model>
class SolvedNip {
 public:
  using Solution = typename Model::Solution;
  using Functional = std::function<Float(const Solution&)>;

  /// Throws for a half length that is not allowed.
  using Check = std::function<void(double half_length)>;

  static SolvedNip of_half_length(Model model, const Float& half_length, int digits) {
    SolvedNip nip(std::move(model), digits);
    nip.solve([&](const Fineness& fineness) { return nip.solution(half_length, fineness); }, half_length);
    return nip;
  }
  /// Of the load, by a search that begins at the half length `guess`, which may be wrong by a factor.
  static SolvedNip of_load(Model model, const Float& load, double guess, int digits, const Check& check) {
    Float length = searched(model, load, guess, digits, check);
    SolvedNip nip(std::move(model), digits);
    const Float enough = pow(Float(10), -digits) / 1000;
    nip.solve(
        [&](const Fineness& fineness) {
          for (int step = 0; step < most_steps; ++step) {
            auto here = nip.solution(length, fineness);
            const Float change = newton_step(load, *here);
            length *= exp(change);
            if (abs(change) <= enough) return here;
          }
          throw std::logic_error("a length for a load that is not found");
        },
        length);
    return nip;
  }

  /// The unknowns of the finer of the first two solutions; BadInput if these are more than are tried.
  static int first_unknowns(const Model& model, const Float& half_length, int digits) {
    const auto panels = panels_of(half_length, model.resolution(), fineness_of(true, first_nats(digits)));
    check_unknowns(model.unknowns(panels), digits);
    return model.unknowns(panels);
  }
  static constexpr int working_digits(int digits, int lost_digits) { return digits + 14 + lost_digits; }
  /// The part of its kind's scale that a small result, which is measured by itself, is measured by at least: the kernels'
  /// errors are smaller than a hundredth of the last digit by that factor.
  static Float kernel_share() { return pow(Float(10), 2 - kernel_guard); }

  [[nodiscard]] int digits() const { return digits_; }
  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] const Solution& fine() const { return *fine_; }
  [[nodiscard]] const Solution& coarse() const { return *coarse_; }
  [[nodiscard]] SheetKernels& kernels() const { return *kernels_; }
  [[nodiscard]] const Float& difference() const { return difference_; }
  [[nodiscard]] data::WithError<Float> estimate(const Functional& functional, const Float& scale) const {
    Float value = functional(*fine_);
    const Float least = pow(Float(10), -digits_) / 100;
    Float error =
        2 * abs(value - functional(*coarse_)) + (difference_ + least) * std::max(scale, Float(abs(value)));
    return {std::move(value), std::move(error)};
  }

 private:
  static constexpr int most_unknowns = 1400;
  static constexpr int most_steps = 40;
  static constexpr int kernel_guard = 8, quadrature_guard = 6;  ///< digits
  static constexpr int search_digits = 10;

  SolvedNip(Model model, int digits)
      : model_(std::move(model)),
        digits_(digits),
        kernels_(std::make_unique<SheetKernels>(digits + kernel_guard)) {}

  static double nats_of(int digits) { return digits * std::numbers::ln10; }
  static double first_nats(int digits) { return nats_of(digits) + 2; }
  static Fineness fineness_of(bool fine, double nats) {
    return fine ? Fineness{1.5, 2.2, 1.2 * nats} : Fineness{1.3, 2, nats};
  }
  static void check_unknowns(int unknowns, int digits) {
    if (unknowns <= most_unknowns) return;
    throw data::BadInput("digits", std::to_string(digits),
                         "must be fewer, or the contact shorter: the reference tries " +
                             std::to_string(most_unknowns) + " unknowns at most, and this takes " +
                             std::to_string(unknowns));
  }

  [[nodiscard]] std::unique_ptr<Solution> solution(const Float& half_length, const Fineness& fineness) const {
    auto panels = panels_of(half_length, model_.resolution(), fineness);
    check_unknowns(model_.unknowns(panels), digits_);
    return model_.solved(half_length, std::move(panels), nats_of(digits_ + quadrature_guard), *kernels_);
  }

  /// Of ln A, to a load.
  static Float newton_step(const Float& load, const Solution& here) {
    return log(load / here.load()) / here.growth();
  }

  /// By such steps with few digits.
  static Float searched(const Model& model, const Float& load, double guess, int digits, const Check& check) {
    Float length = guess;
    {
      const WorkingDigits working(working_digits(search_digits, model.lost_digits()));
      const SolvedNip few(model, search_digits);
      Float here = guess;
      for (int step = 0; step < most_steps; ++step) {
        check(static_cast<double>(here));
        first_unknowns(model, here, digits);
        const auto solution = few.solution(here, fineness_of(false, first_nats(search_digits)));
        const Float change = newton_step(load, *solution);
        here *= exp(std::clamp(change, Float(-1), Float(1)));
        if (abs(change) < pow(Float(10), -search_digits / 2)) break;
      }
      check(static_cast<double>(here));
      mpfr_set(raw(length), raw(here), MPFR_RNDN);
    }
    return length;
  }

  template <class Solve>
  void solve(const Solve& solve_at, const Float& near) {
    const Float enough = pow(Float(10), -digits_) / 4;
    for (double nats = first_nats(digits_);; nats *= 1.25) {
      const auto finest = panels_of(near, model_.resolution(), fineness_of(true, nats));
      check_unknowns(model_.unknowns(finest), digits_);
      fine_ = solve_at(fineness_of(true, nats));
      coarse_ = solve_at(fineness_of(false, nats));
      measure();
      if (difference_ <= enough) return;
    }
  }

  void measure() {
    const std::vector<Float> fine = fine_->signature(), coarse = coarse_->signature();
    difference_ = ldexp(Float(1), 20 - working_bits());
    for (std::size_t i = 0; i < fine.size(); ++i) {
      const Float apart = abs(fine[i] - coarse[i]);
      if (!(apart <= difference_)) difference_ = apart;
    }
  }

  Model model_;
  int digits_;
  std::unique_ptr<SheetKernels> kernels_;
  std::unique_ptr<Solution> coarse_, fine_;
  Float difference_ = 0;
};

}  // namespace nipref::ref
