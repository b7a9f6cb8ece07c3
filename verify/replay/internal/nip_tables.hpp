#pragma once
#include <nipref/data/problem/nip.hpp>
#include <nipref/data/table/table.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {

/// Replays all rows of the table and appends their cells and nips, which replay_of(row) gives as cell(column) and nip().
void append_rows(Replay& replay, const auto& replay_of) {
  struct Row {
    ReplayedNip nip;
    std::vector<ReplayedCell> cells;
  };
  const auto rows = parallel_mapped(replay.table.rows.size(), [&](std::size_t row) {
    const auto one = replay_of(row);
    Row replayed{one.nip(), {}};
    for (const data::TableColumn& column : replay.table.columns)
      if (!column.is_key) replayed.cells.push_back(one.cell(column.name));
    return replayed;
  });
  for (const Row& row : rows) {
    replay.nips.push_back(row.nip);
    replay.cells.insert(replay.cells.end(), row.cells.begin(), row.cells.end());
  }
}

/// The method by which a table of the elastic nip was computed.
struct LineLoadTable {
  std::string_view id;
  data::Friction friction;
  int elements_per_side;  ///< the number that reproduces the table; the thesis does not state it
  /// The element from the middle outwards whose shear the table calls the largest, which in most rows it is; 0: any.
  int shear_element = 0;
};

/// Thesis III to X.
std::span<const LineLoadTable> line_load_tables();

/// The method of one table. BadInput if `id` is none of them.
const LineLoadTable& line_load_table(const std::string& id);

/// Replays a table of the elastic nip (thesis III-X) by `elements_per_side` line loads on each side. The inputs of a
/// row are its printed contact length and, with full friction (III-VI), its printed creep. A length that is not
/// printed follows from L/B. The material constants are those that reproduce the tables.
Replay replay_line_loads(data::Table table, data::Friction friction, int elements_per_side);

/// The size of the shear of each element of one side, from the middle outwards, with full friction.
std::vector<double> shear_of_side(const data::ElasticNip& nip, const fast::LineLoadMethod& method,
                                  double length, double creep);

/// The nip of such a table with these constants, seed::sheet_of_the_tables.
data::ElasticNip nip_of_the_tables(const data::Table& table);

/// The method by which a table of the viscoelastic nip was computed; the thesis states neither number.
struct ViscoelasticTable {
  std::string_view id;
  int leading_elements;  ///< m1
  /// C_L, half-thicknesses. From 16 on only the creep at F0 tau = 1e-3 or 1e-2 depends on it, because of an underflow
  /// (underflown_creep): 25 matches it in most tables, 24 does not in XXI; 60 in XXIV to XXVI.
  double approach;
  /// The part of theta1 + theta2 at once below which a term of the last sum of (6.23) ends it. The terms are about
  /// (2/(pi n)^2) (b/(F0 tau)) e^(-lambda (t - T)), so that 4450 sqrt(b/(F0 tau)) of them are left of long memories. The
  /// small one is added before the sum ends: without it two cells mu_R are lost.
  /// Nothing tells whether the other sums, which fall exponentially, ended so too: they have 500 terms.
  double smallest_term = 1e-8;
};

/// Thesis XI to XXVI.
std::span<const ViscoelasticTable> viscoelastic_tables();

/// The method of one table; nullptr if `id` is none of them.
const ViscoelasticTable* find_viscoelastic_table(std::string_view id);

/// The line loads of such a table with m2 = m1; each row has its own m2.
data::ViscoelasticLineLoads viscoelastic_method(const ViscoelasticTable& how);

/// Replays such a table by 500 residue terms. The input of a row is its printed L1. The material constants are those
/// that reproduce the tables: the constants of the elastic tables with the thesis's wrong exponent in theta2
/// (AIII.15).
Replay replay_viscoelastic(data::Table table, const ViscoelasticTable& how);

/// The nip of a row with these constants; with `as_defined` it has the solid's theta2 instead of the thesis's.
data::ViscoelasticNip viscoelastic_nip_of_the_tables(const data::Table& table, std::size_t row,
                                                     bool as_defined);

/// The product of the row's speed and its relaxation time.
double relaxation_length(const data::Table& table, std::size_t row);

/// The input from which a row of a viscoelastic table is replayed.
struct ViscoelasticRowInput {
  std::string column;             ///< the cell from which the length follows
  data::Interval leading_length;  ///< the L1 that follows from it, in
  int trailing_elements;          ///< m2, from the ratio of the printed lengths
  /// The printed length that agrees with it and bounds L1 most narrowly, mostly L, of which L1 is half.
  std::string narrowest_column = {};
  data::Interval narrowest = leading_length;
  /// What all agreeing lengths and d0 - d1 = L1^2/(2R) leave of `leading_length`.
  data::Interval agreed = leading_length;
};

/// The cell is L1 if it is printed and not doubtful, otherwise L, L2, L/B or d2. m2 is the number of elements that
/// agrees with all printed lengths. If several numbers do, it is the first from m1 downwards without tension, the
/// choice of the thesis (section 2.5).
ViscoelasticRowInput viscoelastic_row_input(const data::Table& table, std::size_t row,
                                            const data::ViscoelasticNip& nip,
                                            data::ViscoelasticLineLoads method);

/// The name, among a row's values, of the creep ratio of a machine on which e^(-180.2) underflows, and with it the
/// whole bracket of a sign term's memory (AII.20). The smallest number of the IBM 360 is 16^-65.
inline constexpr std::string_view underflown_creep = "creep with underflow";

/// The row that line loads give at the middle of the input's interval and at its ends.
ReplayedRow replay_viscoelastic_row(const data::ViscoelasticNip& nip,
                                    const data::ViscoelasticLineLoads& method,
                                    const data::Interval& leading_length);

}  // namespace nipref::verify
