#include <algorithm>
#include <cmath>

#include <nipref/ref/partial_slip/internal/zone_panels.hpp>

namespace nipref::ref {

ZonePanels::ZonePanels(const Row<SlipZone>& zones, const ZoneGrid& grid) {
  Float left = 0;
  for (const auto& [sign, whole] : zones) {
    const int parts = std::max(1, static_cast<int>(std::ceil(static_cast<double>(whole) / longest_panel)));
    for (int part = 0; part < parts; ++part) {
      push_back({sign, left, whole / parts, sign * grid.problem().friction, values_});
      left += back().length;
      values_ += grid.nodes() + 2;
    }
  }
}

ComplexFloat ZonePanels::distance(const ContactPoint& point, GridIndex joint) const {
  const bool is_ahead = joint > point.panel;
  Float between = 0;
  for (GridIndex i = is_ahead ? point.panel + 1 : joint; i < (is_ahead ? joint : point.panel); ++i)
    between += (*this)[i].length;
  return (is_ahead ? point.at.from_right : point.at.from_left) * (*this)[point.panel].length +
         ComplexFloat(between);
}

}  // namespace nipref::ref
