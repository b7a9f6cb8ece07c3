#pragma once
#include <memory>

#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/ref/number/estimated.hpp>

namespace nipref::ref {

/// The continuous frictionless contact of an elastic nip in multiprecision: pressure sqrt(1 - t^2) sum_{k <
/// terms} c_k U_2k(t), t = 2Y/L, the logarithm of I1 acting on it in closed form, the analytic rest by
/// Gauss-Chebyshev with values of ref::I1; terms are added, half as many again each time, until the digits
/// are there. Inputs are doubles taken exactly; units as in data::ElasticNip.
///
/// Errors are estimated from the last two differences d0 and d1 as 10 d1^2/d0. (thesis 2.2, 5.3; continuous
/// form)
class ConvergedElasticNip {
 public:
  ConvergedElasticNip(ConvergedElasticNip&&) noexcept;
  ~ConvergedElasticNip();

  [[nodiscard]] Estimated contact_length() const;
  [[nodiscard]] Estimated load() const;
  [[nodiscard]] Estimated indentation() const;
  [[nodiscard]] Estimated edge_displacement() const;
  /// At distance y from the middle, finite; 0 outside the contact. BadInput otherwise.
  [[nodiscard]] Estimated pressure(double y) const;
  [[nodiscard]] int terms() const;           ///< of the expansion
  [[nodiscard]] long kernel_values() const;  ///< of I1, taken so far

 private:
  struct Implementation;
  explicit ConvergedElasticNip(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
  friend ConvergedElasticNip converged_for_length(const data::ElasticNip&, double, int);
  friend ConvergedElasticNip converged_for_load(const data::ElasticNip&, double, int);
};

/// Contact of the given length: > 0, L <= R and 1e-6 <= L/B <= 20, beyond which an expansion over the whole
/// contact needs too many terms. digits: 16 to 100. BadInput otherwise, and naming the digits where 900 terms
/// do not give them, which is the case of long contacts and many digits.
ConvergedElasticNip converged_for_length(const data::ElasticNip& nip, double contact_length, int digits);

/// Contact that carries `load` per unit width, > 0 and finite, with a length and digits as above; BadInput
/// otherwise.
ConvergedElasticNip converged_for_load(const data::ElasticNip& nip, double load, int digits);

}  // namespace nipref::ref
