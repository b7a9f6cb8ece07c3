#pragma once
#include <nipref/ref/partial_slip/internal/zone_grid.hpp>

namespace nipref::ref {

/// Of panels, in half-thicknesses: longer ones need more nodes, shorter ones are more.
inline constexpr double longest_panel = 3;

/// A part of a zone. It has values of p and of q: what is left of them at the nodes when their linear interpolation between
/// the panel's ends is taken off, then those at its left and right end. Rows of all values are by panels.
struct ZonePanel {
  int sign;
  Float left, length;
  double slip_ratio;  ///< q/p where it slips
  GridIndex first;    ///< value
};

/// A point of a panel.
struct ContactPoint {
  GridIndex panel;
  PanelPoint at;
};

/// Of all zones, from the leading end.
class ZonePanels : public Row<ZonePanel> {
 public:
  ZonePanels(const Row<SlipZone>& zones, const ZoneGrid& grid);

  [[nodiscard]] GridIndex values() const { return values_; }
  [[nodiscard]] Float length() const { return back().left + back().length; }
  [[nodiscard]] ComplexFloat place(const ContactPoint& point) const { return distance(point, 0); }  ///< e
  /// From the left end of panel `joint`, 0 to the number of panels. Its real part is > 0.
  [[nodiscard]] ComplexFloat distance(const ContactPoint& point, GridIndex joint) const;

 private:
  GridIndex values_ = 0;
};

}  // namespace nipref::ref
