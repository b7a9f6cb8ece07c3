#include <nipref/ref/partial_slip/internal/cauchy_sums.hpp>

namespace nipref::ref {
namespace {

/// sum_i loads_i/(distance + nodes_i), from the first load on; in place, as this is most of the work.
OfBoth<ComplexFloat> quotients(const CauchyTerms& terms, const OfBoth<Row<Float>>& loads, GridIndex first,
                               std::size_t kinds) {
  OfBoth<ComplexFloat> sums;
  const Float& height = terms.distance.im;
  const bool is_real = terms.distance.is_real();
  const Float square = height * height;
  Float way, over, load, scratch;
  for (GridIndex i = 0; i < terms.nodes.count(); ++i) {
    mpfr_add(raw(way), raw(terms.distance.re), raw(terms.nodes[i]), MPFR_RNDN);
    if (is_real) {
      mpfr_ui_div(raw(over), 1, raw(way), MPFR_RNDN);
      for (std::size_t of = 0; of < kinds; ++of)
        add_product(sums[of].re, scratch, over, loads[of][first + i]);
      continue;
    }
    mpfr_sqr(raw(over), raw(way), MPFR_RNDN);
    mpfr_add(raw(over), raw(over), raw(square), MPFR_RNDN);
    mpfr_ui_div(raw(over), 1, raw(over), MPFR_RNDN);
    for (std::size_t of = 0; of < kinds; ++of) {
      mpfr_mul(raw(load), raw(over), raw(loads[of][first + i]), MPFR_RNDN);
      add_product(sums[of].re, scratch, load, way);
      mpfr_sub(raw(sums[of].im), raw(sums[of].im), raw(load), MPFR_RNDN);
    }
  }
  for (ComplexFloat& sum : sums) sum.im *= height;
  return sums;
}

}  // namespace

CauchyTerms::CauchyTerms(const ZonePanels& panels, const ZoneGrid& grid, const ContactPoint& point,
                         GridIndex panel, const ContactPoint& from)
    : sign(panel > from.panel || (panel == from.panel && from.at.from_left.re < from.at.from_right.re) ? 1
                                                                                                       : -1),
      distance(panels.distance(point, sign > 0 ? panel : panel + 1) / panels[panel].length),
      nodes(sign > 0 ? grid.from_left() : grid.from_right()) {
  if (point.panel == panel) distance = -distance;
}

OfBoth<ComplexFloat> cauchy_sums(const ZonePanels& panels, const ZoneGrid& grid,
                                 const OfBoth<Row<Float>>& loads, const ContactPoint& point,
                                 bool with_shear) {
  OfBoth<ComplexFloat> sums;
  for (GridIndex i = 0; i < panels.count(); ++i) {
    const ZonePanel& panel = panels[i];
    const CauchyTerms terms(panels, grid, point, i, point);
    const bool sticks = panel.sign == 0;
    OfBoth<ComplexFloat> part = quotients(terms, loads, panel.first, with_shear && sticks ? 2 : 1);
    if (!sticks) part[shear_part] = part[pressure_part] * Float(panel.slip_ratio);
    for (std::size_t of : {pressure_part, shear_part}) sums[of] = sums[of] + part[of] * Float(terms.sign);
  }
  return sums;
}

Row<ComplexFloat> cauchy_hats(const ZonePanels& panels, const ContactPoint& point) {
  // Twice integrated by parts: with f(t) = t ln|t| at the joints, differences over the panels' lengths, and of these again.
  Row<ComplexFloat> hats;
  ComplexFloat before, slope;
  for (GridIndex joint = 0; joint <= panels.count(); ++joint) {
    const ComplexFloat distance = panels.distance(point, joint);
    const bool is_at = distance.is_real() && distance.re == 0;
    ComplexFloat value = is_at ? distance : distance * log(distance) / pi();
    if (joint <= point.panel) value = -value;
    if (joint > 0) {
      const ComplexFloat last = std::exchange(slope, (value - before) / panels[joint - 1].length);
      hats.push_back(joint > 1 ? slope - last : ComplexFloat());
    }
    before = value;
  }
  return hats;
}

}  // namespace nipref::ref
