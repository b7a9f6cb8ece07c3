#pragma once
#include <nipref/verify/catalogue/arguments.hpp>

namespace nipref::verify {

// A value is as accurate as was asked, the accuracy is met, where
//
//     error <= accuracy * scale,    scale = max(|value|, envelope),
//
// accuracy being 10^-digits of the reference and rtol of fast, and the scale what the quantity's errors are measured
// against, as for a scene's results those of data::Scale. The error is the one that is stated,
// before it is rounded up to two digits.

/// Whether the reference's value at these arguments is accurate enough. Where the envelope is no finite double, the scale is
/// the value alone, which is no larger.
bool is_met(const Quantity& quantity, const ParsedArguments& arguments, const ref::Estimate& found,
            int digits);

/// Whether fast's value is accurate enough; it is not if the error or the scale is a NaN.
inline bool is_met(double error, double scale, double rtol) { return error <= rtol * scale; }

}  // namespace nipref::verify
