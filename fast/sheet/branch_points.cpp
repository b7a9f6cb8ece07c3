#include <algorithm>
#include <cmath>
#include <vector>

#include <nipref/fast/sheet/branch_points.hpp>
#include <nipref/fast/sheet/internal/tables.hpp>

namespace nipref::fast {
namespace {

/// Adds the cells of the octaves [1/8, 1/4) and [1/4, 1/2), and the beginnings of the others, down to the denormal numbers.
void add_log_cells(std::vector<double>& points) {
  for (double cell = 0; cell < internal::log_cells; ++cell) {
    const double mantissa = 1 + cell / internal::log_cells;
    points.push_back(mantissa / 4);
    points.push_back(mantissa / 8);
  }
  for (int octave = 4; octave <= 1022; ++octave) points.push_back(std::ldexp(1.0, -octave));
}

/// Adds the midpoints between centres that are `width` apart.
void add_piece_edges(std::vector<double>& points, double begin, double end, double width) {
  for (double edge = begin + width / 2; edge < end; edge += width) points.push_back(edge);
}

/// Adds the edges of the first cells of the exponential or of the phase beyond piece_end.
void add_tail_cells(std::vector<double>& points, double cells_per_unit, int cells) {
  const double first = std::ceil(internal::piece_end * cells_per_unit) + 0.5;
  for (int cell = 0; cell < cells; ++cell) points.push_back((first + cell) / cells_per_unit);
}

std::vector<double> all_points() {
  std::vector<double> points{internal::near_end, internal::fine_end, internal::piece_end,
                             internal::underflown};
  add_log_cells(points);
  add_piece_edges(points, 0, internal::fine_end, 1 / internal::fine_pieces);
  add_piece_edges(points, internal::fine_end, internal::piece_end, 1 / internal::coarse_pieces);
  add_tail_cells(points, internal::common_table.decay_high, internal::exponential_cells);
  add_tail_cells(points, internal::common_table.phase_high, internal::phase_cells);
  std::sort(points.begin(), points.end());
  return points;
}

}  // namespace

std::span<const double> branch_points() {
  static const std::vector<double> all = all_points();
  return all;
}

}  // namespace nipref::fast
