#pragma once
#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/data/problem/nip.hpp>
#include <nipref/data/problem/seed_nips.hpp>

/// The thesis's nip with a sheet that softens by one half. It rolls at speed 1, so that a relaxation time is a length.
namespace nipref::test {

inline constexpr data::ElasticNip at_once = data::seed::nip(0.25);
inline constexpr double radius = at_once.roller_radius, thickness = at_once.sheet_thickness, load = 50;
inline constexpr double bulk = at_once.material.young;  // Poisson's ratio is 1/3

/// One relaxation time in shear and dilatation; the compliance grows to twice the instantaneous one.
inline data::ViscoelasticMaterial solid(double relaxation_time) {
  return data::single_relaxation_time_solid(bulk, data::thesis_shear_over_bulk * bulk, relaxation_time);
}

inline data::ViscoelasticNip nip(double relaxation_length) {
  return {radius, thickness, solid(relaxation_length), 1};
}

/// The elastic nip of `compliance` times the instantaneous compliance of `solid`.
inline data::ElasticNip elastic(double compliance) {
  return {radius, thickness, {bulk / compliance, at_once.material.poisson}};
}

}  // namespace nipref::test
