#pragma once
#include <nipref/data/problem/nip.hpp>
#include <nipref/data/problem/seed_nips.hpp>

/// The thesis's nips by the thickness of their sheets, and the thesis's choice of creep.
namespace nipref::test {

inline constexpr data::ElasticNip thick_nip = data::seed::nip(1.0);
inline constexpr data::ElasticNip quarter_inch_nip = data::seed::nip(0.25);
inline constexpr data::ElasticNip middling_nip = data::seed::nip(0.0625);
inline constexpr data::ElasticNip thin_nip = data::seed::nip(0.005);

inline constexpr data::LineLoadFriction thesis_friction{data::LineLoadFriction::Kind::thesis_creep};
constexpr data::LineLoadFriction full_friction(double creep) { return data::LineLoadFriction::full(creep); }

/// A nip with the thesis's Young's modulus and another Poisson's ratio, thickness and radius.
inline data::ElasticNip nip_of(double poisson, double sheet_thickness = 1, double roller_radius = 1e3) {
  return {roller_radius, sheet_thickness, {data::seed::sheet.young, poisson}};
}

}  // namespace nipref::test
