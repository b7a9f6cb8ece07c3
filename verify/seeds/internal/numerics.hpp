#pragma once
#include <functional>

#include <nipref/verify/seeds/propagated.hpp>

namespace nipref::verify {

using Function = std::function<Propagated(double)>;

// The error of an integral is the sum of the rule's estimate of its truncation error, the integral of the errors of f, and
// the rounding of the sum.

/// int_from^to f, which may be singular at the ends in an integrable way.
Propagated integral(const Function& f, double from, double to);
/// The same for a smooth f.
Propagated smooth_integral(const Function& f, double from, double to);
/// int_0^inf f
Propagated half_line_integral(const Function& f);
/// (1/pi) times the principal value of int_from^to f(t)/(t - x) dt, from < x < to.
Propagated hilbert(const Function& f, double x, double from, double to);

/// f'(x) by central differences with halved steps, extrapolated to 0 (Ridders). Of the extrapolated values the result is the
/// one with the least error, the sum of the change by the last extrapolation and of the propagated errors of f. f must be
/// analytic within several steps.
Propagated derivative(const Function& f, double x, double step);

/// The place where f changes its sign, between two places at which its signs differ. The error reaches to where they are
/// certain.
Propagated sign_change(const Function& f, double lower, double upper);

/// f at a place that has an error; f must be monotonic there.
Propagated monotonic(const Function& f, const Propagated& place);

/// The largest value of f, which rises to it and falls from it, and its place, whose error reaches to where f is certainly
/// smaller.
Propagated largest(const Function& f, double lower, double upper);
Propagated place_of_largest(const Function& f, double lower, double upper);

}  // namespace nipref::verify
