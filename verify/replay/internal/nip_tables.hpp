#pragma once
#include <map>
#include <tuple>

#include <nipref/data/problem/nip.hpp>
#include <nipref/data/table/table.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// The columns of a nip's table for a contact: line loads or a converged contact of an elastic or a viscoelastic nip.
template <class Contact>
RowValues row_values(double sheet_thickness, const Contact& contact);

/// A row as line loads give it.
struct ReplayedRow {
  RowValues at_centre;             ///< for the middles of the inputs' intervals
  std::vector<RowValues> corners;  ///< for the corners of the product of these intervals

  /// The interval from the least to the greatest value of a column.
  [[nodiscard]] data::Interval range(const std::string& column) const;
};

/// Calls `solve` at the middle and at the corners of the inputs' intervals.
ReplayedRow replay_row(const std::vector<data::Interval>& inputs,
                       const std::function<RowValues(const std::vector<double>& inputs)>& solve);

/// A row of a nip's table. Some of its printed numbers are the inputs of the line loads that replay the others.
class NipRow {
 public:
  virtual ~NipRow() = default;
  [[nodiscard]] ReplayedNip nip() const { return {replayed_.at_centre, elements_.trailing}; }
  [[nodiscard]] ReplayedCell cell(const std::string& column) const;

 protected:
  struct Elements {
    int leading, trailing;
    auto operator<=>(const Elements&) const = default;
  };
  NipRow(const data::Table& table, std::size_t row) : table_(table), row_(row) {}
  void begin(const Elements& elements, const data::Interval& length) {
    elements_ = elements;
    length_ = length;
    replayed_ = with(elements, length);
  }
  [[nodiscard]] const data::TableCell& printed(const std::string& column) const {
    return table_.cell(row_, column);
  }
  /// The row for other numbers of elements or another length. Each is replayed once and cached.
  [[nodiscard]] const ReplayedRow& with(const Elements& elements, const data::Interval& length) const;
  /// The candidates whose line loads give the printed number of a missed cell.
  [[nodiscard]] std::vector<Elements> meeting(const ReplayedCell& missed,
                                              const std::vector<Elements>& candidates) const;

  [[nodiscard]] virtual ReplayedRow replay(const Elements& elements, const data::Interval& length) const = 0;
  /// Marks a missed cell as an error of the seed if a known mistake of the seed's method gives the printed number.
  virtual void explain(ReplayedCell& missed) const = 0;
  /// The attempts to explain a legible cell, in words. The verdict does not depend on them.
  [[nodiscard]] virtual std::string attempts(const ReplayedCell& missed) const = 0;

  const data::Table& table_;
  std::size_t row_;
  Elements elements_{};
  data::Interval length_{};
  ReplayedRow replayed_;
  std::map<std::string, std::string> inputs_;  ///< the columns that are inputs, with their notes
  std::vector<data::Interval> other_lengths_;  ///< the lengths for which misprints are judged

 private:
  mutable std::map<std::tuple<Elements, double, double>, ReplayedRow> rows_;
};

/// Replays all rows of the table and appends their cells and nips.
void append_rows(Replay& replay, const std::function<std::unique_ptr<NipRow>(std::size_t row)>& replay_of);

/// The method by which a table of the elastic nip was computed.
struct LineLoadTable {
  std::string_view id;
  data::Friction friction;
  int elements_per_side;  ///< the number that reproduces the table; the thesis does not state it
  /// The element, counted from the middle, whose shear is the table's q_max; in most rows it is the largest. 0: any.
  int shear_element = 0;
};

/// Thesis III to X.
std::span<const LineLoadTable> line_load_tables();

/// The method of one table. BadInput if `id` is none of them.
const LineLoadTable& line_load_table(const std::string& id);

/// Replays a table of the elastic nip (thesis III-X) by `elements_per_side` line loads on each side. The inputs of a
/// row are its printed contact length and, with full friction (III-VI), its printed creep. If the length is not
/// printed, it follows from L/B. The material constants are those that reproduce the tables.
Replay replay_line_loads(data::Table table, data::Friction friction, int elements_per_side);

/// The nip of a table of the elastic nip with the constants that reproduce the tables, seed::sheet_of_the_tables.
data::ElasticNip nip_of_the_tables(const data::Table& table);

/// The method by which a table of the viscoelastic nip was computed. The thesis states neither m1 nor C_L.
struct ViscoelasticTable {
  std::string_view id;
  int leading_elements;  ///< m1
  /// C_L, the distance before the nip at which the loads start, in half-thicknesses. From 16 on only the creep depends on
  /// it, at F0 tau = 1e-3 or 1e-2, by an underflow (underflown_creep): 25 matches that creep in most tables and 24 does
  /// not in XXI; 60 matches it in XXIV to XXVI.
  double approach;
  /// The last sum of (6.23) ends with its first term below this part of the instantaneous theta1 + theta2. Its terms are
  /// about (2/(pi n)^2) (b/(F0 tau)) e^(-lambda (t - T)), so that 4450 sqrt(b/(F0 tau)) of them remain of long memories.
  /// The term that ends the sum is added to it: without this term two cells mu_R are missed. The other sums, whose
  /// terms fall exponentially, have 500 terms here; no cell tells whether they ended in the same way.
  double smallest_term = 1e-8;
};

/// Thesis XI to XXVI.
std::span<const ViscoelasticTable> viscoelastic_tables();

/// The method of one table; nullptr if `id` is none of them.
const ViscoelasticTable* find_viscoelastic_table(std::string_view id);

/// The line loads of a viscoelastic table with m2 = m1; each row has its own m2.
data::ViscoelasticLineLoads viscoelastic_method(const ViscoelasticTable& how);

/// Replays a table of the viscoelastic nip by 500 residue terms. The input of a row is its printed L1. The material
/// constants are those that reproduce the tables: the constants of the elastic tables with the thesis's wrong exponent
/// in theta2 (AIII.15).
Replay replay_viscoelastic(data::Table table, const ViscoelasticTable& how);

/// The nip of a row with these constants. With `as_defined` theta2 is the solid's own instead of the thesis's.
data::ViscoelasticNip viscoelastic_nip_of_the_tables(const data::Table& table, std::size_t row,
                                                     bool as_defined);

/// The product of the row's speed and relaxation time.
double relaxation_length(const data::Table& table, std::size_t row);

/// The input from which a row of a viscoelastic table is replayed.
struct ViscoelasticRowInput {
  std::string column;             ///< the cell from which the length follows
  data::Interval leading_length;  ///< the L1 that follows from this cell, in
  int trailing_elements;          ///< m2, from the ratio of the printed lengths
  /// The printed length that agrees with this L1 and bounds it most narrowly: mostly L, of which L1 is half.
  std::string narrowest_column = {};
  data::Interval narrowest = leading_length;
  /// The part of `leading_length` that agrees with all these lengths and with d0 - d1 = L1^2/(2R).
  data::Interval agreed = leading_length;
};

/// Takes L1 as the input if L1 is printed and not doubtful, otherwise L, L2, L/B or d2. m2 is the number of elements
/// that agrees with most of the printed lengths. If several numbers do, it is the first from m1 downwards for which
/// no load is tensile; this is the choice of the thesis (section 2.5).
ViscoelasticRowInput viscoelastic_row_input(const data::Table& table, std::size_t row,
                                            const data::ViscoelasticNip& nip,
                                            data::ViscoelasticLineLoads method);

/// The name, among a row's values, of the creep ratio of a machine on which e^(-180.2) underflows. The whole bracket of
/// a sign term's memory (AII.20) is lost with this factor. The smallest number of the IBM 360 is 16^-65.
inline constexpr std::string_view underflown_creep = "creep with underflow";

/// The row as line loads give it for the middle of the input's interval and for its ends.
ReplayedRow replay_viscoelastic_row(const data::ViscoelasticNip& nip,
                                    const data::ViscoelasticLineLoads& method,
                                    const data::Interval& leading_length);

}  // namespace nipref::verify
