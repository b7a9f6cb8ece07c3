#pragma once
#include <functional>
#include <optional>

#include <nipref/ref/nip/internal/proven_contact.hpp>
#include <nipref/ref/nip/internal/sheet_kernels.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

// The frictionless contact of an elastic sheet, solved and proven, with results to `digits` digits. Half lengths are in
// half-thicknesses, beta = theta2/N. Nothing if most_terms do not suffice. The kernel is ref's I1, except in tests.

std::optional<Proof> proven_elastic(const Exact& half_length, const Exact& beta, int digits,
                                    const NormalKernel& kernel, int most_terms);

/// The contact that carries a load. `guess` is the half length to a tenth. Nothing also if is_allowed does not hold for
/// the half length as it is known to 1e-11. Only one length carries the load: ref/elastic_nip/README.md.
std::optional<Proof> proven_elastic_for_load(const Exact& load, double guess,
                                             const std::function<bool(double half_length)>& is_allowed,
                                             const Exact& beta, int digits, const NormalKernel& kernel,
                                             int most_terms);

/// The size of the expansion of a contact of given length.
int proven_elastic_terms(double half_length, int digits);

/// The contact of an elastic sheet with full friction, solved and proven so that its results have the requested digits;
/// half lengths are in half-thicknesses, beta = theta2/N. (ref/elastic_nip/README.md, Contacts with full friction)
Proof proven_gripped(const Exact& half_length, const Exact& beta, int digits, const GrippedKernels& kernels);

/// The contact that carries a load, from a guess of the half length that may be wrong by a third. Nothing if is_allowed
/// refuses a half length of the search or most_terms do not suffice. That no other length carries it is not proven.
std::optional<Proof> proven_gripped_for_load(const Exact& load, double guess,
                                             const std::function<bool(double half_length)>& is_allowed,
                                             const Exact& beta, int digits, const GrippedKernels& kernels,
                                             int most_terms);

/// The size of the expansion of such a contact of given length.
int proven_gripped_terms(double half_length, double beta, int digits);

}  // namespace nipref::ref
