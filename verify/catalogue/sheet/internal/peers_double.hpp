#pragma once
#include <functional>

namespace nipref::verify {

// Ways of other libraries, and of the thesis, to compute I1 in double, each set up as well as we can. Each maker prepares
// everything that can be reused for many arguments. The evaluator takes alpha > 0 (dimensionless), promises no accuracy,
// and must not be shared between threads.

/// The thesis's own series (AI.9) with 500 residues, summed as it is written.
std::function<double(double)> make_plain_series_I1();

/// GSL's gsl_integration_qawf on the integrand as it stands, absolute tolerance 1e-13.
std::function<double(double)> make_qawf_I1();

/// Boost's ooura_fourier_cos on the integrand as it stands, default tolerance (which ends near full
/// accuracy).
std::function<double(double)> make_ooura_I1();

}  // namespace nipref::verify
