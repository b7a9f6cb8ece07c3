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

/// Of the reference at these arguments. Where the envelope leaves the doubles the scale is the value alone, which is
/// no larger.
bool is_met(const Quantity& quantity, const ParsedArguments& arguments, const ref::Estimate& found,
            int digits);

/// Of fast; a NaN meets nothing.
inline bool is_met(double error, double scale, double rtol) { return error <= rtol * scale; }

}  // namespace nipref::verify
