#pragma once
#include <nipref/ref/partial_slip/internal/zone_grid.hpp>

namespace nipref::ref {

/// Of panels, in half-thicknesses: longer ones need more nodes, shorter ones are more.
inline constexpr double longest_panel = 3;

/// A part of a zone. The values of p and q are what is left of them at the nodes when their linear interpolation between the
/// panel's ends is taken off, then those at its left and right end.
struct ZonePanel {
  /// Which unknown a value is, times a factor; none where it is 0.
  struct Source {
    GridIndex column = -1;
    double factor = 1;
  };

  GridIndex zone;
  int sign;
  Float left, length;
  double slip_ratio;  ///< q/p where it slips
  OfBoth<Row<Source>> sources = {};
  OfBoth<Row<Float>> values = {};
  OfBoth<Row<Float>> loads = {};  ///< those at the nodes, times the weights of the grid over pi
};

/// A point of a panel. Beside the contact the panel is -1 or their number, `at` the distance from the contact's end.
struct ContactPoint {
  GridIndex panel;
  PanelPoint at;
};

/// Of all zones, from the leading end.
class ZonePanels : public Row<ZonePanel> {
 public:
  ZonePanels(const Row<SlipZone>& zones, double friction);

  [[nodiscard]] Float length() const { return back().left + back().length; }
  /// e of a point.
  [[nodiscard]] ComplexFloat place(const ContactPoint& point) const;
  /// From the left end of panel `joint`, 0 to the number of panels. A complex point has it with a real part > 0.
  [[nodiscard]] ComplexFloat distance(const ContactPoint& point, GridIndex joint) const;

 private:
  [[nodiscard]] Float length_of(GridIndex panel) const;
};

}  // namespace nipref::ref
