#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/ref/partial_slip/internal/zone_grid.hpp>

namespace nipref::ref {
namespace {

constexpr double pi_as_double = std::numbers::pi;

/// The angle between a panel and the arc through its ends that rises to the height 2, where the kernels have poles; at most
/// pi, the angle of what lies beyond its ends.
double free_angle(double length) { return 2 * std::atan(4 / length); }

/// The least of x/2 + 1/(2 sqrt(x^2 + 1/4)): the part of the exponent that is left where it is least.
constexpr double least_part = 0.9296;

}  // namespace

ZoneGrid::ZoneGrid(const SlipProblem& problem, double nats, double longest) : problem_(problem), nats_(nats) {
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
