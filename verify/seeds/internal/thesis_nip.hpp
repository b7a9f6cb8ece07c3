#pragma once
#include <nipref/data/material/seed_solids.hpp>
#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>

namespace nipref::verify {

// The thesis's nips: rollers of 6 in, the sheet that its tables were computed with; inches and pounds.

inline constexpr double thesis_radius = 6, claims_accuracy = 1e-9;

inline fast::ConvergedElasticNip thesis_nip(double thickness, double load, data::Friction friction,
                                            double poisson = data::seed::sheet_of_the_tables.poisson) {
  const data::ElasticNip nip{thesis_radius, thickness, {data::seed::sheet_of_the_tables.young, poisson}};
  return fast::converged_for_load(nip, friction, load, claims_accuracy);
}

/// A contact of half-length A = L/B on a sheet of half-thickness 1 and modulus 1, which L/B and Poisson's ratio say all of.
inline fast::ConvergedElasticNip nip_of_length(double length_over_thickness, data::Friction friction,
                                               double poisson) {
  const data::ElasticNip nip{100 * (1 + length_over_thickness), 2, {1, poisson}};
  return fast::converged_for_length(nip, friction, 2 * length_over_thickness, claims_accuracy);
}

}  // namespace nipref::verify
