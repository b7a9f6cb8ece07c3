#pragma once
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// I1, I3 and, without the part that depends on eta alone, I6.
enum class SheetKernel { I1, I3, I6 };

/// A kernel at every argument of an interval, which must not hold 0, to about 10^-digits and what the interval's
/// width makes of it: |alpha dI/dalpha| < 2 (1 + |alpha|). residue_terms: 0, or what plain_series() sums.
Interval kernel_over(SheetKernel kernel, const Interval& alpha, int residue_terms, int digits);

}  // namespace nipref::ref
