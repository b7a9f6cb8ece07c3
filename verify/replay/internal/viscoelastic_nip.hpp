#pragma once
#include <span>
#include <string_view>

#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {

/// What a table of the viscoelastic nip was computed with; the thesis states neither number.
struct ViscoelasticTable {
  std::string_view id;
  int leading_elements;  ///< m1
  /// C_L, half-thicknesses. From 16 on no cell depends on it but the creep at F0 tau = 1e-3 or 1e-2, by what
  /// underflows (viscoelastic_row.hpp): 24 meets that in most tables, 60 in XXIV to XXVI.
  double approach;
};

/// Thesis XI to XXVI.
std::span<const ViscoelasticTable> viscoelastic_tables();

/// nullptr if it is none of them.
const ViscoelasticTable* find_viscoelastic_table(std::string_view id);

/// Of such a table, m2 = m1: each row has its own.
fast::ViscoelasticLineLoadMethod viscoelastic_method(const ViscoelasticTable& how);

/// Replays such a table: each row from its printed L1, with 500 residue terms, at the material constants that
/// reproduce the tables, those of the elastic ones with the thesis's wrong exponent in theta2 (AIII.15).
Replay replay_viscoelastic(data::Table table, const ViscoelasticTable& how);

/// The nip of a row at those constants; `as_defined`: with the solid's own theta2 in place of the thesis's.
data::ViscoelasticNip viscoelastic_nip_of_the_tables(const data::Table& table, std::size_t row,
                                                     bool as_defined);

/// The row's product of speed and relaxation time.
double relaxation_length(const data::Table& table, std::size_t row);

}  // namespace nipref::verify
