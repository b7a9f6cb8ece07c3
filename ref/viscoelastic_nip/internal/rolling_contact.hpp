#pragma once
#include <functional>
#include <memory>
#include <optional>

#include <nipref/data/number/with_error.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_pressure.hpp>

namespace nipref::ref {

/// A rolling contact solved twice, with other panels and other numbers of terms.
class RollingContact {
 public:
  /// A dimensionless quantity of a contact.
  using Functional = std::function<Float(const RollingPressure&)>;

  /// Of a half length, half-thicknesses.
  static RollingContact of_half_length(const Float& half_length, const RollingMaterial& material, int digits);
  /// Of the finer of the first two discretisations; BadInput if that is more than are tried.
  static int first_unknowns(const Float& half_length, const RollingMaterial& material, int digits);
  /// Of a dimensionless load; `check` throws for a half length that is not allowed.
  static RollingContact of_load(const Float& load, const RollingMaterial& material, int digits,
                                const std::function<void(double half_length)>& check);

  [[nodiscard]] int digits() const { return digits_; }
  [[nodiscard]] int working_digits() const { return working_digits_; }
  /// Of the arithmetic that a contact of so many digits is solved in.
  static int working_digits(const RollingMaterial& material, int digits);
  [[nodiscard]] const RollingPressure& fine() const { return *fine_; }
  [[nodiscard]] const RollingPressure& coarse() const { return *coarse_; }
  /// What they differ by anywhere, relative to the largest value of the kind.
  [[nodiscard]] const Float& difference() const { return difference_; }
  [[nodiscard]] RollingKernel& normal_kernel() const { return *normal_; }
  [[nodiscard]] RollingKernel& tangential_kernel() const { return *tangential_; }
  [[nodiscard]] StretchRollingKernel& stretch_kernel() const { return *stretch_; }
  /// The value on the finer discretisation. Its error is estimated as twice the difference of the two discretisations
  /// plus difference() times `scale`, the largest value of the kind, dimensionless.
  [[nodiscard]] data::WithError<Float> estimate(const Functional& functional, const Float& scale) const;

 private:
  /// A load, the length that nearly carries it, and the load's growth, d ln load/d ln length, nearly.
  struct Sought {
    Float load, half_length, growth;
  };
  RollingContact(const RollingMaterial& material, int digits);
  static Sought search(const Float& load, const RollingMaterial& material, int digits,
                       const std::function<void(double half_length)>& check);
  void solve_for_length(const Float& half_length);
  void solve_for_load(Sought sought);
  void measure();

  int digits_, working_digits_;
  std::unique_ptr<RollingKernel> normal_, tangential_;
  std::unique_ptr<StretchRollingKernel> stretch_;
  std::unique_ptr<RollingPressure> coarse_, fine_;
  Float difference_;
};

}  // namespace nipref::ref
