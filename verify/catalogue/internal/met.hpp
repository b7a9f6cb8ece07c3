#pragma once
#include <nipref/verify/catalogue/arguments.hpp>

namespace nipref::verify {

// A value meets the accuracy that was asked for if
//
//     error <= accuracy * scale,    scale = max(|value|, envelope).
//
// The accuracy is 10^-digits for the reference and rtol for fast. The scale is what the quantity's errors are measured
// against, as the results of a scene are measured against data::Scale. The error is the stated one before it is rounded up
// to two digits.

/// Whether the reference's value at these arguments is accurate enough. Where the envelope is no finite double, the scale is
/// the value alone, which is no larger.
bool is_met(const Quantity& quantity, const ParsedArguments& arguments, const ref::Estimate& found,
            int digits);

/// Whether fast's value is accurate enough; it is not if the error or the scale is a NaN.
inline bool is_met(double error, double scale, double rtol) { return error <= rtol * scale; }

}  // namespace nipref::verify
