#pragma once
#include <nipref/data/problem/nip.hpp>
#include <nipref/ref/nip/converged.hpp>

namespace nipref::ref {

/// The largest number of terms with which a proof is tried. Without friction a contact longer than a few sheet
/// thicknesses needs about 0.6 L/B (digits + 20) terms. The time grows with their square.
inline constexpr int most_proof_terms = 2200;

/// The contact of an elastic nip of the given length: > 0, L <= R and 1e-8 <= L/B <= 1000; digits: 16 to 100. BadInput
/// otherwise, and naming the digits if 1400 unknowns do not give them. If most_terms suffice and L/B is at most 80
/// without friction, 4 with it, the results that ref/elastic_nip/README.md names are proven.
ConvergedNip converged_for_length(const data::ElasticNip& nip, data::Friction friction, double contact_length,
                                  int digits, int most_terms = most_proof_terms);

/// The contact that carries `load` per unit width, > 0 and finite, with length and digits as above; BadInput otherwise.
ConvergedNip converged_for_load(const data::ElasticNip& nip, data::Friction friction, double load, int digits,
                                int most_terms = most_proof_terms);

/// The number of terms of the expansion that proves a contact of given length, or 0 if none does.
int proven_terms(const data::ElasticNip& nip, data::Friction friction, double contact_length, int digits,
                 int most_terms = most_proof_terms);
/// The number of unknowns of the first solution by panels; the time grows with its square. BadInput as above.
int elastic_unknowns(const data::ElasticNip& nip, data::Friction friction, double contact_length, int digits);

}  // namespace nipref::ref
