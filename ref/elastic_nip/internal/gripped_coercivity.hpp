#pragma once
#include <nipref/ref/number/interval.hpp>

// How stiff a sheet with full friction is against the tractions of a contact; beta = theta2/N. (ref/elastic_nip/README.md,
// Contacts with full friction, (1))

namespace nipref::ref {

/// A bound from below of the least eigenvalue of x times the symbol of both displacements under both tractions, for the
/// wave number x and all larger ones.
Interval least_stiffness(const Interval& x, const Interval& beta);

/// lambda of the page, for all half lengths of the interval, in half-thicknesses.
Interval gripped_coercivity(const Interval& half_length, const Interval& beta);

}  // namespace nipref::ref
