#pragma once
#include <nipref/data/material/solids.hpp>
#include <nipref/data/table/table.hpp>
#include <nipref/fast/half_space/direction.hpp>
#include <nipref/fast/half_space/response.hpp>
#include <nipref/verify/catalogue/internal/printed.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// A cell of a half-space's table before its printed number is compared.
struct HalfSpaceCell;
using CellOf = std::function<HalfSpaceCell(std::size_t row, const data::TableColumn& column)>;

/// A table of the papers on half-spaces.
struct HalfSpaceTable {
  std::string_view id;
  CellOf (*cell_of)(const data::Table& table);
  std::string_view method;
};
std::span<const HalfSpaceTable> half_space_tables();

/// Replays a table of the papers by the formulas from which it was computed, with the verdicts of assess_half_space.
/// `corrected` is the result of the correct formulas with the papers' own contour rule; `costs` are the deviations from it.
Replay replay_half_space(data::Table table, const HalfSpaceTable& how);

/// One possible origin of a cell's number.
struct Attempt {
  data::Interval range;  ///< one number, or the interval that follows from the rounding of another cell
  Verdict if_met;
  std::string how;  ///< the note if it matches
};

struct HalfSpaceCell {
  std::size_t row;  ///< from 0
  std::string column;
  double corrected;
  std::vector<Attempt> attempts;  ///< the first: the table's formula without rounding of intermediate values
  std::string error;              ///< the error of the table's formula; empty if the formula is correct
  /// A proof, independent of the formula, that the printed number is wrong; empty if there is none.
  std::string proof = {};
  /// The value of the exact elliptic contact for the same responses, without friction.
  std::optional<double> exact = {};
};

/// Returns the first of these verdicts that applies:
/// - `match` if the printed number differs from the corrected one by at most one unit of the fourth decimal (the tables
///   have four decimals without trailing zeros: 1.21 stands for 1.2100);
/// - the verdict of the first attempt that differs from the printed number by at most one unit of the number's last
///   digit: `match` if the attempt is the table's formula, correct or not (the note says which), `seed_error` if the
///   table is refuted as a whole or if the attempt also needs a number from another cell;
/// - `seed_error` if there is a proof and the table does not mark the cell as doubtful: then the formula is not the only
///   error;
/// - `unexplained`.
ReplayedCell assess_half_space(const data::Table& table, const HalfSpaceCell& cell);

// The cells of each table. The table must outlive them.
CellOf sliding_die_cells(const data::Table& table);              ///< brock2012-1
CellOf rolling_sphere_cells(const data::Table& table);           ///< brock2012-2
CellOf sphere_on_normal_axis_cells(const data::Table& table);    ///< brock2013-1
CellOf branch_speed_cells(const data::Table& table);             ///< brock2013-2
CellOf sphere_on_axis_in_plane_cells(const data::Table& table);  ///< brock2013-3, without the row phi = 0

/// The two bodies of a table of brock2013, as the table's header states them, in GPa and kg/m^3.
struct SphereOnHalfSpace {
  data::IsotropicSolid sphere;
  data::TransverselyIsotropicSolid half_space;
  GivenNumbers scaled;  ///< the scaled moduli, with c_D as printed

  explicit SphereOnHalfSpace(const data::Table& table);

  /// v_0, the speed of shear waves in the sphere.
  [[nodiscard]] double speed_unit() const { return std::sqrt(sphere.shear / sphere.density); }

  /// The response of both bodies in contact along a line, by the angle between the line and the motion. c0 is the speed
  /// divided by that of the sphere's shear waves. The contact moves over the sphere, as in the paper.
  [[nodiscard]] fast::SurfaceResponse in_contact(data::SymmetryAxis axis, fast::Direction motion,
                                                 double c0) const;
};

}  // namespace nipref::verify
