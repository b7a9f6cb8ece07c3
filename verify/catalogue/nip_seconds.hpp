#pragma once
#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/data/problem/friction.hpp>
#include <nipref/data/problem/viscoelastic_nip.hpp>

namespace nipref::verify {

/// Estimates of the seconds that the reference takes for the converged contact of that length on one core of a server of
/// 2022, good to a factor of about two: they follow from the number of unknowns. BadInput as the reference has it.
[[nodiscard]] double likely_seconds(const data::ElasticNip& nip, data::Friction friction, double length,
                                    int digits);
[[nodiscard]] double likely_seconds(const data::ViscoelasticNip& nip, double length, int digits);

/// Seconds beyond which the catalogue refuses a contact and `solve` warns.
inline constexpr double long_time = 10;

}  // namespace nipref::verify
