#pragma once
#include <span>
#include <string>

namespace nipref::verify {

/// The numbers of digits for which the multiprecision peers are compiled, ascending.
std::span<const int> peer_digits();

/// Boost's exp_sinh with mpfr_float_backend<digits> on the smooth remainder of I1 (no cancellation in the
/// integrand), with the loosest tolerance that gives all digits. `alpha` is decimal text, > 0, dimensionless;
/// the result is decimal text without any promise. BadInput naming "digits" unless it is one of
/// peer_digits().
std::string exp_sinh_I1(const std::string& alpha, int digits);

/// |first - second| of two decimal texts, rounded to a double; exact to about 1000 digits.
double decimal_distance(const std::string& first, const std::string& second);

}  // namespace nipref::verify
