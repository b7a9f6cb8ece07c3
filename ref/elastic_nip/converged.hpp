#pragma once
#include <nipref/data/problem/nip.hpp>
#include <nipref/ref/nip/converged.hpp>

namespace nipref::ref {

/// Terms of the expansion that is tried at most to prove a contact: beyond a few sheet thicknesses it needs
/// about L/B (digits + 20) 0.6 of them without friction, and the time grows with their square.
inline constexpr int most_proof_terms = 2200;

/// Contact of an elastic nip of the given length: > 0, L <= R and 1e-8 <= L/B <= 1000; digits: 16 to 100. BadInput
/// otherwise, and naming the digits where 1400 unknowns do not give them. Where so many terms
/// suffice, of up to 80 sheet thicknesses without friction and 4 with it, what ref/elastic_nip/README.md says is proven.
ConvergedNip converged_for_length(const data::ElasticNip& nip, data::Friction friction, double contact_length,
                                  int digits, int most_terms = most_proof_terms);

/// Contact that carries `load` per unit width, > 0 and finite, with a length and digits as above; BadInput otherwise.
ConvergedNip converged_for_load(const data::ElasticNip& nip, data::Friction friction, double load, int digits,
                                int most_terms = most_proof_terms);

/// The terms of the expansion that proves a contact of given length, 0 where none does.
int proven_terms(const data::ElasticNip& nip, data::Friction friction, double contact_length, int digits,
                 int most_terms = most_proof_terms);
/// The number of unknowns that panels take at first; their cost grows with its square. BadInput as above.
int elastic_unknowns(const data::ElasticNip& nip, data::Friction friction, double contact_length, int digits);

}  // namespace nipref::ref
