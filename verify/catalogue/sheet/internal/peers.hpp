#pragma once
#include <functional>
#include <span>
#include <string>

namespace nipref::verify {

// Methods of other libraries, and of the thesis, to compute I1 in double, each set up as well as we can. Each maker
// prepares everything that can be reused for many arguments. The evaluator takes alpha > 0 (dimensionless), promises no
// accuracy, and must not be shared between threads.

/// The thesis's own series (AI.9) with 500 residues, summed as it is written.
std::function<double(double)> make_plain_series_I1();

/// GSL's gsl_integration_qawf on the integrand as it stands, absolute tolerance 1e-13.
std::function<double(double)> make_qawf_I1();

/// Boost's ooura_fourier_cos on the integrand as it stands, default tolerance (which ends near full
/// accuracy).
std::function<double(double)> make_ooura_I1();

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
