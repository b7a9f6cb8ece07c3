#pragma once
#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/data/problem/friction.hpp>
#include <nipref/data/problem/viscoelastic_nip.hpp>

namespace nipref::verify {

/// Estimates, from the number of unknowns, of the seconds that the reference takes for the converged contact of that length
/// on one core of a server of 2022; they are right to a factor of about two. They throw BadInput where the reference does.
[[nodiscard]] double likely_seconds(const data::ElasticNip& nip, data::Friction friction, double length,
                                    int digits);
[[nodiscard]] double likely_seconds(const data::ViscoelasticNip& nip, double length, int digits);
/// The same of a frictionless contact with proven bounds.
[[nodiscard]] double likely_seconds_proven(const data::ElasticNip& nip, double length, int digits);

/// Seconds beyond which the catalogue refuses a contact and `solve` warns.
inline constexpr double long_time = 10;

}  // namespace nipref::verify
