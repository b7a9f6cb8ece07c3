#pragma once
#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>

namespace nipref::verify {

/// Estimates, from the number of unknowns, of the seconds that the reference takes for the converged contact of that length
/// on one core of a server of 2022; they are right to a factor of about two. They throw BadInput where the reference does.
[[nodiscard]] double likely_seconds(const data::ElasticNip& nip, data::Friction friction, double length,
                                    int digits, int most_terms = ref::most_proof_terms);
[[nodiscard]] double likely_seconds(const data::ViscoelasticNip& nip, double length, int digits);

/// Seconds beyond which the catalogue refuses a contact and `solve` warns; and the terms of a proof that takes so long.
inline constexpr double long_time = 10;
inline constexpr int terms_in_long_time = 750;

}  // namespace nipref::verify
