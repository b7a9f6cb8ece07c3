#pragma once
#include <vector>

#include <nipref/data/table/table.hpp>
#include <nipref/verify/replay/internal/half_space_cell.hpp>

namespace nipref::verify {

// The cells of each table of the half-space papers, with what is known of them.

std::vector<HalfSpaceCell> sliding_die_cells(const data::Table& table);            ///< brock2012-1
std::vector<HalfSpaceCell> rolling_sphere_cells(const data::Table& table);         ///< brock2012-2
std::vector<HalfSpaceCell> sphere_on_normal_axis_cells(const data::Table& table);  ///< brock2013-1
std::vector<HalfSpaceCell> branch_speed_cells(const data::Table& table);           ///< brock2013-2
/// brock2013-3, without the row phi = 0, which is 1 by definition.
std::vector<HalfSpaceCell> sphere_on_axis_in_plane_cells(const data::Table& table);

}  // namespace nipref::verify
