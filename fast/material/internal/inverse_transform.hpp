#pragma once
#include <nipref/fast/material/internal/polynomial.hpp>
#include <nipref/fast/number/internal/sized.hpp>

namespace nipref::fast::internal {

/// The function of time, t >= 0, that has this transform, without its impulses at 0: divided differences of e^(p t) over
/// the roots of the denominator, which may coincide. The error is below 2^-150 of the size. BadInput where five roots of
/// one factor nearly coincide.
Sized<Octuple> inverse_transform(const Rational& transform, double t);

}  // namespace nipref::fast::internal
