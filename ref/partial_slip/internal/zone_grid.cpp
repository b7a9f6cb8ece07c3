#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/ref/partial_slip/internal/zone_grid.hpp>

namespace nipref::ref {
namespace {

constexpr double pi_as_double = std::numbers::pi;

/// Of panels, in half-thicknesses: longer ones need more nodes, shorter ones are more.
constexpr double longest_panel = 3;

/// The angle between a panel and the arc through its ends that rises to the height 2, where the kernels have poles; at most
/// pi, the angle of what lies beyond its ends.
double free_angle(double length) { return 2 * std::atan(4 / length); }

/// The least of x/2 + 1/(2 sqrt(x^2 + 1/4)): the part of the exponent that is left where it is least.
constexpr double least_part = 0.9296;

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

ZoneGrid::ZoneGrid(const SlipProblem& problem, double nats, const Row<SlipZone>& zones)
    : problem_(problem), nats_(nats) {
  double longest = 0;
  for (const SlipZone& zone : zones) {
    const auto length = static_cast<double>(zone.length);
    panels_of_zones_.push_back(std::max(1, static_cast<int>(std::ceil(length / longest_panel))));
    longest = std::max(longest, length / panels_of_zones_.back());
  }
  const double angle = free_angle(longest), reach = std::asinh(4 * pi_as_double / angle);
  const double exponent = nats / least_part;
  const double wanted_step = 4 * pi_as_double * pi_as_double / (exponent * exponent);
  const int nodes = 2 * std::max(2, static_cast<int>(std::ceil(reach / wanted_step)));
  step_ = 2 * reach / nodes;
  steepness_ = angle * exponent / (2 * pi_as_double);
  middle_ = Float(nodes - 1) / 2;
  for (int i = 0; i < nodes; ++i) {
    const PanelPoint point = at(Float(i));
    from_left_.push_back(point.from_left.re);
    from_right_.push_back(point.from_right.re);
    weight_.push_back(slope_at(i));
  }
  for (int sign : {-1, 0, 1}) {
    const ComplexFloat first(problem.shift(sign) - Float(1) / 2, sign == 0 ? -atanh(problem.beta) / pi() : 0);
    for (int i = 0; i <= nodes; ++i)
      points_[static_cast<std::size_t>(sign + 1)].push_back(at(first + ComplexFloat(Float(i))));
  }
}

PanelPoint ZoneGrid::at(const ComplexFloat& place) const {
  const Float s = step_ * (place.re - middle_), t = step_ * place.im;
  const ComplexFloat way(steepness_ * sinh(s) * cos(t), steepness_ * cosh(s) * sin(t)), growth = exp(way);
  const ComplexFloat from_right = ComplexFloat(1) / (ComplexFloat(1) + growth);
  return {growth * from_right, from_right};
}

Float ZoneGrid::place_of(const Float& from_left, const Float& from_right) const {
  return middle_ + asinh(Float(log(from_left / from_right) / steepness_)) / step_;
}

Float ZoneGrid::slope_at(const Float& place) const {
  const PanelPoint point = at(place);
  return steepness_ * cosh(step_ * (place - middle_)) * step_ * point.from_left.re * point.from_right.re;
}

ZonePanels::ZonePanels(const Row<SlipZone>& zones, const ZoneGrid& grid) {
  Float left = 0;
  for (GridIndex zone = 0; zone < zones.count(); ++zone) {
    const auto& [sign, whole] = zones[zone];
    const int parts = grid.panels_of(zone);
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
