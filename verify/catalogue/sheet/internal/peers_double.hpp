#pragma once
#include <functional>

namespace nipref::verify {

// Other people's ways to compute I1 in double, set up as well as we can. Each maker does once what may be
// reused for many arguments; the evaluator takes alpha > 0 (dimensionless), makes no promise, and is not to
// be shared between threads.

/// The thesis's own series (AI.9) with 500 residues, straight.
std::function<double(double)> make_plain_series_I1();

/// GSL's gsl_integration_qawf on the integrand as it stands, absolute tolerance 1e-13.
std::function<double(double)> make_qawf_I1();

/// Boost's ooura_fourier_cos on the integrand as it stands, default tolerance (which ends near full
/// accuracy).
std::function<double(double)> make_ooura_I1();

}  // namespace nipref::verify
