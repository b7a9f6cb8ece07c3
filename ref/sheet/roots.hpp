#pragma once
#include <nipref/ref/number/enclosure.hpp>

namespace nipref::ref {

/// A root z of sinh 2z + 2z = 0.
struct SheetRoot {
  Enclosure re;
  Enclosure im;
};

/// The n-th root in the first quadrant, ordered by imaginary part; n >= 1, n <= 10^9, digits 16 to 1000,
/// otherwise data::BadInput. Each part is an Enclosure with its promise (both parts exceed 1). (thesis AIV)
///
/// Proof that it is the n-th: With 2z = x + iy, x, y > 0, the equation is cos y = -x/sinh x and cosh x sin y = -y.
/// Hence y lies in the third quadrant of its turn, y = (2n-1) pi + phi with phi(x) = arccos(x/sinh x) in (0, pi/2), n
/// = 1, 2, ..., and
///
///     h_n(x) = cosh x sin phi(x) - phi(x) - (2n-1) pi = 0.
///
/// phi increases and cosh x cos phi = x coth x > 1, so that h_n' = sinh x sin phi + phi' (cosh x cos phi - 1) > 0,
/// and h_n increases from -(2n-1) pi to infinity. Thus each n has one root, and no other root exists. Opposite signs
/// of h_n in interval arithmetic at the two ends of an interval enclose its x, and phi at these ends its y.
SheetRoot sheet_root(long n, int digits);

}  // namespace nipref::ref
