#pragma once
#include <array>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/data/problem/nip.hpp>

/// The nips of the thesis's tables: inches and psi.
namespace nipref::data::seed {

inline constexpr double roller_radius = 6;

/// The thicknesses of the tables III to VI and VII to X; of XI to XXVI four tables have each thickness.
inline constexpr std::array<double, 4> sheet_thicknesses{1, 0.25, 0.0625, 0.005};

/// The nip of this thickness, with the sheet as the thesis states it.
constexpr ElasticNip nip(double sheet_thickness) { return {roller_radius, sheet_thickness, sheet}; }

}  // namespace nipref::data::seed
