#pragma once
#include <functional>

#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

// Bounds of the contacts' systems in Chebyshev's polynomials, (1) and (2) of ref/elastic_nip/README.md.

/// A bound from below of x times the symbol of the displacements under the tractions, for the wave number x and all larger
/// ones: without friction, and the least eigenvalue with full friction, beta = theta2/N.
Interval frictionless_stiffness(const Interval& x);
Interval gripped_stiffness(const Interval& x, const Interval& beta);

/// lambda of (1) with such a bound, for all half lengths of the interval, in half-thicknesses.
using Stiffness = std::function<Interval(const Interval& x)>;
Interval coercivity(const Interval& half_length, const Stiffness& stiffness);

/// C and tau of (2) that an expansion of this size is proven with.
struct EntryBounds {
  Interval amplitude, rate;

  /// e^{-k tau}
  [[nodiscard]] Interval power(long k) const { return exp(-(k * rate)); }
};
EntryBounds entry_bounds(const Interval& half_length, int size);

/// A bound of all entries that N points fold onto one, where the least index folded is `first`.
Interval folded_entries(const EntryBounds& decay, long points, long first);

/// Bounds of sum m e^{-m rate} over m = first, first + 2, .., and of sum m^2 e^{-m rate} over all m >= first; rate > 0.
Interval tail(const Interval& rate, long first);
Interval square_tail(const Interval& rate, long first);

/// Units of (A + 1) that cover what rounding A cos(theta_i) -+ A cos(theta_j) does to a value of J.
inline constexpr long argument_units = 64;

/// Coefficients that give about so many digits, by the bounds above.
int size_for(double half_length, int digits);

}  // namespace nipref::ref
