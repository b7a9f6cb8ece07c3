#pragma once
#include <functional>
#include <memory>

#include <nipref/data/number/with_error.hpp>
#include <nipref/ref/nip/internal/nip_solution.hpp>

namespace nipref::ref {

/// A contact solved twice, with other panels, other numbers of terms and other nodes, and again with more of them until both
/// agree to the digits asked for. The result of a functional is that of the finer solution, with an error that is estimated:
/// ref/nip/README.md, Two solutions.
class SolvedNip {
 public:
  using Functional = std::function<Float(const NipSolution&)>;
  /// Throws for a half length that is not allowed.
  using Check = std::function<void(double half_length)>;
  using Sheet = std::shared_ptr<const NipSheet>;

  static SolvedNip of_half_length(const Sheet& sheet, const Float& half_length, int digits);
  /// Of the load, by a search that begins at the half length `guess`, which may be wrong by a factor.
  static SolvedNip of_load(const Sheet& sheet, const Float& load, double guess, int digits,
                           const Check& check);

  /// The unknowns of the finer of the first two solutions; BadInput if these are more than are tried.
  static int first_unknowns(const NipSheet& sheet, const Float& half_length, int digits);
  static constexpr int working_digits(int digits, int lost_digits) { return digits + 14 + lost_digits; }
  /// The part of its kind's scale that a small result, which is measured by itself, is measured by at least: the kernels'
  /// errors are smaller than a hundredth of the last digit by that factor.
  static Float kernel_share();

  [[nodiscard]] const NipSolution& fine() const { return *fine_; }
  [[nodiscard]] const NipSolution& coarse() const { return *coarse_; }
  [[nodiscard]] SheetKernels& kernels() const { return *kernels_; }
  [[nodiscard]] const Float& difference() const { return difference_; }
  [[nodiscard]] data::WithError<Float> estimate(const Functional& functional, const Float& scale) const;

 private:
  SolvedNip(Sheet sheet, int digits);

  [[nodiscard]] std::unique_ptr<NipSolution> solution(const Float& half_length,
                                                      const Fineness& fineness) const;
  /// Solves by solve_at(fineness), about the half length `near`.
  void solve(const std::function<std::unique_ptr<NipSolution>(const Fineness&)>& solve_at, const Float& near);
  void measure();

  Sheet sheet_;
  int digits_;
  std::unique_ptr<SheetKernels> kernels_;
  std::unique_ptr<NipSolution> coarse_, fine_;
  Float difference_ = 0;
};

}  // namespace nipref::ref
