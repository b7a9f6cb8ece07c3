#pragma once
#include <nipref/ref/sheet/plain_series.hpp>

namespace nipref::ref {

/// An interval that contains the values of I1, I3 or I6_alpha_part on an interval of arguments. Its width is about 10^-digits
/// plus the effect of the argument's width, |alpha dI/dalpha| < 2 (1 + |alpha|). residue_terms is 0, or the number of
/// terms of plain_series(), which then replaces the kernel. BadInput "y" where it contains 0.
Interval kernel_over(PlainKernel kernel, const Interval& alpha, int residue_terms, int digits);

}  // namespace nipref::ref
