#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/data/table/table.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/replay/row.hpp>

namespace nipref::verify {

/// What a row of a viscoelastic table is replayed from.
struct ViscoelasticRowInput {
  std::string column;             ///< the cell that fixes the length; empty: none is, it is the table's load
  data::Interval leading_length;  ///< L1 that follows from it, in
  int trailing_elements;          ///< m2, from the ratio of the printed lengths
};

/// The cell is L1 if it is printed and in no doubt, otherwise L, L2, L/B or d2. m2 is the number of which all
/// printed lengths are multiples; where several would do, the first from m1 down that leaves no tension, as
/// the thesis chose it (2.5).
ViscoelasticRowInput viscoelastic_row_input(const data::Table& table, std::size_t row,
                                            const data::ViscoelasticNip& nip,
                                            fast::ViscoelasticLineLoadMethod method);

/// Name among a row's values for the creep ratio as a machine gives it on which e^(-180.2) underflows and
/// takes the whole bracket of a sign term's memory with it, (AII.20): the IBM 360's smallest number is
/// 16^-65.
inline constexpr std::string_view underflown_creep = "creep with underflow";

/// The row as the line loads give it, at the middle of the input's interval and at its ends.
ReplayedRow replay_viscoelastic_row(const data::ViscoelasticNip& nip,
                                    const fast::ViscoelasticLineLoadMethod& method,
                                    const data::Interval& leading_length);

/// The columns that a contact gives.
struct ViscoelasticNumbers {
  double load, leading_length, trailing_length, indentation, peak_pressure, creep_ratio, rolling_resistance;
};
RowValues viscoelastic_row_values(const data::ViscoelasticNip& nip, const ViscoelasticNumbers& numbers);
RowValues viscoelastic_row_values(const data::ViscoelasticNip& nip,
                                  const fast::ViscoelasticLineLoadMethod& method,
                                  const fast::ViscoelasticLineLoads& loads);

}  // namespace nipref::verify
