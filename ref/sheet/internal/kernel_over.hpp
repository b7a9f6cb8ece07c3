#pragma once
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// I1, I3 and, without the part that depends on eta alone, I6.
enum class SheetKernel { I1, I3, I6 };

/// An interval that contains the kernel's values on an interval of arguments without 0. Its width is about 10^-digits
/// plus the effect of the argument's width, |alpha dI/dalpha| < 2 (1 + |alpha|). residue_terms is 0, or the number of
/// terms of plain_series(), which then replaces the kernel.
Interval kernel_over(SheetKernel kernel, const Interval& alpha, int residue_terms, int digits);

}  // namespace nipref::ref
