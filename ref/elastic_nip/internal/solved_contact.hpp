#pragma once
#include <functional>
#include <memory>

#include <nipref/ref/elastic_nip/internal/functionals.hpp>
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/sheet/internal/smooth_kernel.hpp>

namespace nipref::ref {

/// How many digits each part of a solution is computed to.
struct ContactPrecision {
  int expansion;  ///< the coefficients' radius
  int kernel;     ///< after the point
  int working;
};

/// A frictionless contact, solved and proven so that its results have the requested digits, in the units of
/// ContactFunctionals; half lengths are in half-thicknesses. The kernel is ref's I1, except in tests.
class SolvedContact {
 public:
  /// BadInput "digits" where most_terms do not suffice.
  static SolvedContact of_half_length(const Exact& half_length, int digits, NormalKernel kernel);
  /// The same for a load. `guess` is an approximation of the half length to a tenth. `check` is called with the half
  /// length to 1e-11 before the proof, and may throw.
  static SolvedContact of_load(const Exact& load, double guess,
                               const std::function<void(double half_length)>& check, int digits,
                               NormalKernel kernel);

  /// That a contact of given length is expanded in; BadInput likewise.
  static int terms_of(double half_length, int digits);

  [[nodiscard]] int digits() const { return digits_; }
  [[nodiscard]] int working_digits() const { return precision_.working; }
  [[nodiscard]] long kernel_values() const { return kernel_->kernel_values(); }
  /// What it has is to be computed at working_digits().
  [[nodiscard]] const ContactFunctionals& operator*() const { return *functionals_; }
  [[nodiscard]] const ContactFunctionals* operator->() const { return functionals_.get(); }

 private:
  SolvedContact(int digits, const ContactPrecision& precision, NormalKernel kernel);
  void finish(const ChebyshevSystem& system, const Vector& coefficients, const Interval& half_length);

  int digits_;
  ContactPrecision precision_;
  std::unique_ptr<SmoothKernel> kernel_;
  std::unique_ptr<ContactFunctionals> functionals_;
};

}  // namespace nipref::ref
