#pragma once

#include <nipref/data/material/solids.hpp>
#include <nipref/data/table/table.hpp>
#include <nipref/fast/half_space/direction.hpp>
#include <nipref/fast/half_space/response.hpp>
#include <nipref/verify/catalogue/half_space/internal/printed.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

struct HalfSpaceCell;

/// A table of the papers on half-spaces.
struct HalfSpaceTable {
  std::string_view id;
  std::vector<HalfSpaceCell> (*cells)(const data::Table& table);
  std::string_view method;
};
std::span<const HalfSpaceTable> half_space_tables();
const HalfSpaceTable* find_half_space_table(std::string_view id);  ///< nullptr if it is none of them

/// Replays such a table by the formulas from which it was computed. `corrected` is the result of the correct formulas
/// with the papers' own contour rule; `costs` compares the replay with it. The verdicts are those of
/// assess_half_space.
Replay replay_half_space(data::Table table, const HalfSpaceTable& how);

/// Calls `call` for each cell that is no label of its row, row by row.
void for_each_value(const data::Table& table,
                    const std::function<void(std::size_t row, const data::TableColumn& column)>& call);

/// One possible origin of a cell's number.
struct Attempt {
  data::Interval range;  ///< one number, or the interval that follows from the rounding of another cell
  Verdict if_met;
  std::string how;  ///< the note if it matches
};

/// A cell before its printed number is compared.
struct HalfSpaceCell {
  std::size_t row;  ///< from 0
  std::string column;
  double corrected;
  std::vector<Attempt> attempts;  ///< first the formula from which the table was computed, without rounding
  std::string error;              ///< the error of this formula; empty if it is correct
  /// A proof, independent of the formula, that the printed number is wrong; empty if there is none.
  std::string proof = {};
  /// The value of the exact elliptic contact for the same responses, without friction.
  std::optional<double> exact = {};
};

/// The first of these verdicts that applies:
/// - `match` if the printed number differs from the corrected one by at most one unit of the fourth decimal (the tables
///   have four decimals without trailing zeros, so that 1.21 is 1.2100);
/// - the verdict of the first attempt that differs from the printed number by at most one unit of its last digit:
///   `match` if this is the formula of the table, whether it is correct or not (the note says which), `seed_error` if the
///   table is refuted as a whole or if the cell needs another number as well;
/// - `seed_error` if there is a proof and the table does not mark the cell as doubtful, for then more than the formula is
///   wrong;
/// - `unexplained`.
ReplayedCell assess_half_space(const data::Table& table, const HalfSpaceCell& cell);

/// The cells of a table.
using HalfSpaceCells = std::vector<HalfSpaceCell>(const data::Table& table);
HalfSpaceCells sliding_die_cells, rolling_sphere_cells;          ///< brock2012-1, -2
HalfSpaceCells sphere_on_normal_axis_cells, branch_speed_cells;  ///< brock2013-1, -2
/// brock2013-3, without the row phi = 0, which is 1 by definition.
HalfSpaceCells sphere_on_axis_in_plane_cells;

/// The two bodies of a table of brock2013 as its header states them, GPa and kg/m^3.
struct SphereOnHalfSpace {
  data::IsotropicSolid sphere;
  data::TransverselyIsotropicSolid half_space;
  ScaledModuli scaled;

  explicit SphereOnHalfSpace(const data::Table& table);

  /// v_0, the speed of shear waves in the sphere.
  [[nodiscard]] double speed_unit() const { return std::sqrt(sphere.shear / sphere.density); }

  /// The joint response of both bodies on the line at an angle from the motion; c0 is the speed over that of the
  /// sphere's shear waves. The contact moves over the sphere, as in the paper.
  [[nodiscard]] fast::SurfaceResponse in_contact(data::SymmetryAxis axis, fast::Direction motion,
                                                 double c0) const;
};

}  // namespace nipref::verify
