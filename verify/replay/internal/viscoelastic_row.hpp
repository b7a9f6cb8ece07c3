#pragma once
#include <string>
#include <string_view>

#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/data/table/table.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {

/// The input from which a row of a viscoelastic table is replayed.
struct ViscoelasticRowInput {
  std::string column;             ///< the cell from which the length follows; empty for the table's load
  data::Interval leading_length;  ///< the L1 that follows from it, in
  int trailing_elements;          ///< m2, from the ratio of the printed lengths
};

/// The cell is L1 if it is printed and not doubtful, otherwise L, L2, L/B or d2. m2 is the number of elements that
/// agrees with all printed lengths. If several numbers do, it is the first from m1 downwards without tension, the
/// choice of the thesis (2.5).
ViscoelasticRowInput viscoelastic_row_input(const data::Table& table, std::size_t row,
                                            const data::ViscoelasticNip& nip,
                                            fast::ViscoelasticLineLoadMethod method);

/// The name, among a row's values, of the creep ratio of a machine on which e^(-180.2) underflows, and with it the
/// whole bracket of a sign term's memory (AII.20). The smallest number of the IBM 360 is 16^-65.
inline constexpr std::string_view underflown_creep = "creep with underflow";

/// The row that line loads give at the middle of the input's interval and at its ends.
ReplayedRow replay_viscoelastic_row(const data::ViscoelasticNip& nip,
                                    const fast::ViscoelasticLineLoadMethod& method,
                                    const data::Interval& leading_length);

/// The columns of a contact.
struct ViscoelasticNumbers {
  double load, leading_length, trailing_length, indentation, peak_pressure, creep_ratio, rolling_resistance;
};
RowValues viscoelastic_row_values(const data::ViscoelasticNip& nip, const ViscoelasticNumbers& numbers);
RowValues viscoelastic_row_values(const data::ViscoelasticNip& nip,
                                  const fast::ViscoelasticLineLoadMethod& method,
                                  const fast::ViscoelasticLineLoads& loads);

}  // namespace nipref::verify
