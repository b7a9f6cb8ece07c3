#pragma once
#include <nipref/ref/number/estimate.hpp>
#include <nipref/verify/catalogue/arguments.hpp>

namespace nipref::verify {

/// Unit in the last place: 2^(e-52) for 2^e <= |scale| < 2^(e+1), and 2^-1074 for zero and subnormal scales:
/// the spacing of the doubles just above |scale|. Same unit as `scale`. Exact. BadInput naming "scale" unless
/// it is finite.
double ulp_of(double scale);

/// How far an approximation is from the truth. Every number is an upper bound: the reference's own error is
/// added. All are infinite when the approximation is not a finite number.
struct Deviation {
  double ulps;      ///< |x - truth| in units in the last place of the scale
  double relative;  ///< |x - truth| / |truth|; 0 when both are 0
  double of_scale;  ///< |x - truth| / scale
  double scale;     ///< max(|truth|, envelope), unit of the quantity
};

/// Deviation of the double `approximation` from `truth`, where `envelope` >= 0 is the size that the quantity
/// would have away from its zeros (0: none). The difference is formed in MPFR, so that nothing is lost to
/// cancellation or underflow.
Deviation deviation(double approximation, const ref::Estimate& truth, double envelope);

// A value meets the accuracy that was asked for if
//
//     error <= accuracy * scale,    scale = max(|value|, envelope).
//
// The accuracy is 10^-digits for the reference and rtol for fast. The errors of the quantity are measured against the
// scale, as the results of a scene are measured against data::Scale. The error is the stated one before it is rounded
// up to two digits.

/// Whether the value of the reference at these arguments is accurate enough. If the envelope is not a finite double,
/// the scale is the value alone, which is no larger.
bool is_met(const Quantity& quantity, const ParsedArguments& arguments, const ref::Estimate& found,
            int digits);

/// Whether fast's value is accurate enough; it is not if the error or the scale is a NaN.
inline bool is_met(double error, double scale, double rtol) { return error <= rtol * scale; }

}  // namespace nipref::verify
