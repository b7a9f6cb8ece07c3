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
/// Proof: ref/sheet/README.md, Roots.
SheetRoot sheet_root(long n, int digits);

}  // namespace nipref::ref
