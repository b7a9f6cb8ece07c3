#pragma once
#include <span>
#include <string_view>

#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {

/// The method by which a table of the viscoelastic nip was computed; the thesis states neither number.
struct ViscoelasticTable {
  std::string_view id;
  int leading_elements;  ///< m1
  /// C_L, half-thicknesses. From 16 on only the creep at F0 tau = 1e-3 or 1e-2 depends on it, because of an underflow
  /// (viscoelastic_row.hpp): 24 matches it in most tables, 60 in XXIV to XXVI.
  double approach;
};

/// Thesis XI to XXVI.
std::span<const ViscoelasticTable> viscoelastic_tables();

/// The method of one table; nullptr if `id` is none of them.
const ViscoelasticTable* find_viscoelastic_table(std::string_view id);

/// The line loads of such a table with m2 = m1; each row has its own m2.
fast::ViscoelasticLineLoadMethod viscoelastic_method(const ViscoelasticTable& how);

/// Replays such a table by 500 residue terms. The input of a row is its printed L1. The material constants are those
/// that reproduce the tables: the constants of the elastic tables with the thesis's wrong exponent in theta2
/// (AIII.15).
Replay replay_viscoelastic(data::Table table, const ViscoelasticTable& how);

/// The nip of a row with these constants; with `as_defined` it has the solid's theta2 instead of the thesis's.
data::ViscoelasticNip viscoelastic_nip_of_the_tables(const data::Table& table, std::size_t row,
                                                     bool as_defined);

/// The product of the row's speed and its relaxation time.
double relaxation_length(const data::Table& table, std::size_t row);

/// Sets these members of a replay of thesis XI-XXVI:
///   - `corrected`: the continuous contact under the table's load, accurate to 1e-6, of the solid that the thesis defines,
///     with one relaxation time in shear and dilatation;
///   - `corrected_with_seed_material`: the same with the thesis's theta2;
///   - `costs` in L, d0, p_max and muR at the load of the row's replay: "truncation" compares the replay with the same line
///     loads with exact kernels, "discretisation" these with the continuous contact, and "exponent" the continuous
///     contacts with the thesis's theta2 and with the solid's.
void correct_viscoelastic(Replay& replay);

}  // namespace nipref::verify
