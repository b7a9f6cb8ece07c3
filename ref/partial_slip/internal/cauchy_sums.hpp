#pragma once
#include <nipref/ref/partial_slip/internal/zone_grid.hpp>

namespace nipref::ref {

// Cauchy's integrals 1/pi int t(e')/(e' - e) de' of p and q over the contact.

/// The grid's rule has terms sign weight/(distance + nodes)/pi for a panel: `nodes` are distances from one of its ends, and
/// `distance` is that of e from there to the other side, all over the panel's length.
struct CauchyTerms {
  int sign;
  ComplexFloat distance;
  const Row<Float>& nodes;

  /// From the end that is nearer to `from`.
  CauchyTerms(const ZonePanels& panels, const ZoneGrid& grid, const ContactPoint& point, GridIndex panel,
              const ContactPoint& from);
};

/// The rule's sums; of q only where it is wanted. `loads` are the values at the nodes times the rule's weights over pi. In a panel
/// the sums lack what the value at the point adds.
OfBoth<ComplexFloat> cauchy_sums(const ZonePanels& panels, const ZoneGrid& grid,
                                 const OfBoth<Row<Float>>& loads, const ContactPoint& point, bool with_shear);

/// The integrals of the function that is 1 at a joint of panels, 0 at the others and linear between them, by the panels to the
/// right of the joints; 0 for the first.
Row<ComplexFloat> cauchy_hats(const ZonePanels& panels, const ContactPoint& point);

}  // namespace nipref::ref
