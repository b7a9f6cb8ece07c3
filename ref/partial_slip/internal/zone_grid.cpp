#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/ref/partial_slip/internal/zone_grid.hpp>

namespace nipref::ref {
namespace {

constexpr double pi_as_double = std::numbers::pi;

/// In half-thicknesses. Longer panels need more nodes; shorter panels are more in number.
constexpr double longest_panel = 3;

/// The angle between a panel and the arc through its ends up to the height 2, where the kernels have poles; at most pi,
/// the angle of the other zones.
double free_angle(double length) { return 2 * std::atan(4 / length); }

/// The least value of x/2 + 1/(2 sqrt(x^2 + 1/4)), which is a lower bound of E/D: ref/partial_slip/README.md, The map.
constexpr double least_part = 0.9296;

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
    weight_over_pi_.push_back(weight_.back() / pi());
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

void ZonePanels::set_cauchy_row(Row<ComplexFloat>& row, const ZoneGrid& grid,
                                const ContactPoint& point) const {
  row.grow(values_);
  // The linear interpolations are integrated twice by parts. Their factors are differences, between panels, of the
  // differences of f(t) = t ln|t| over a panel divided by its length.
  const auto potential = [&](GridIndex joint) -> ComplexFloat {
    const ComplexFloat way = distance(point, joint), value = abs(way) == 0 ? way : way * log(way) / pi();
    return joint <= point.panel ? -value : value;
  };
  ComplexFloat before = potential(0), slope;
  Float over;
  for (GridIndex number = 0; number < count(); ++number) {
    const ZonePanel& panel = (*this)[number];
    const ComplexFloat value = potential(number + 1),
                       last = std::exchange(slope, (value - before) / panel.length);
    if (number > 0) row[panel.first + grid.nodes()] = slope - last;
    before = value;
    // Terms weight/(distance + node), with distances from the end of the panel that is nearer to the point.
    const bool is_own = number == point.panel,
               from_left = is_own ? point.at.from_left.re < point.at.from_right.re : number > point.panel;
    const Row<Float>& nodes = from_left ? grid.from_left() : grid.from_right();
    const ComplexFloat way = distance(point, from_left ? number : number + 1) / panel.length,
                       to_end = is_own ? -way : way;
    const Float square = to_end.im * to_end.im, minus_height = -to_end.im;
    // In place, as this is most of the work.
    for (GridIndex i = 0; i < nodes.count(); ++i) {
      auto& [re, im] = row[panel.first + i];
      const Float& weight = grid.weight_over_pi()[i];
      mpfr_add(raw(re), raw(to_end.re), raw(nodes[i]), MPFR_RNDN);
      if (to_end.is_real()) {
        mpfr_div(raw(re), raw(weight), raw(re), MPFR_RNDN);
        mpfr_set_zero(raw(im), 1);
      } else {
        mpfr_sqr(raw(over), raw(re), MPFR_RNDN);
        mpfr_add(raw(over), raw(over), raw(square), MPFR_RNDN);
        mpfr_div(raw(over), raw(weight), raw(over), MPFR_RNDN);
        mpfr_mul(raw(re), raw(re), raw(over), MPFR_RNDN);
        mpfr_mul(raw(im), raw(minus_height), raw(over), MPFR_RNDN);
      }
      if (from_left) continue;
      mpfr_neg(raw(re), raw(re), MPFR_RNDN);
      mpfr_neg(raw(im), raw(im), MPFR_RNDN);
    }
  }
}

}  // namespace nipref::ref
