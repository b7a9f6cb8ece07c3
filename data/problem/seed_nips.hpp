#pragma once
#include <array>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/data/problem/nip.hpp>

/// The nips of the thesis's tables: inches and psi.
namespace nipref::data::seed {

inline constexpr double roller_radius = 6;

/// Tables III to VI, VII to X, and XI to XXVI four of each.
inline constexpr std::array<double, 4> sheet_thicknesses{1, 0.25, 0.0625, 0.005};

/// With the sheet as the thesis states it.
constexpr ElasticNip nip(double sheet_thickness) { return {roller_radius, sheet_thickness, sheet}; }

}  // namespace nipref::data::seed
