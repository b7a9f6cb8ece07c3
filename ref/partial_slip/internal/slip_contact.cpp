#include <algorithm>
#include <utility>

#include <nipref/ref/partial_slip/internal/slip_contact.hpp>
#include <nipref/ref/partial_slip/internal/slip_field.hpp>

namespace nipref::ref {

SlipContact::SlipContact(std::shared_ptr<const ZoneGrid> grid, SheetKernels& kernels,
                         const Row<SlipZone>& zones)
    : grid_(std::move(grid)),
      zones_(zones),
      panels_(zones, problem().friction),
      smooth_(panels_, *grid_, kernels) {
  count_unknowns();
  count_equations();
}

void SlipContact::count_unknowns() {
  const GridIndex nodes = grid_->nodes();
  const auto add = [&](const Float& size) -> ZonePanel::Source {
    sizes_.push_back(size * problem().unit);
    return {sizes_.count() - 1};
  };
  for (ZonePanel& panel : panels_) {
    for (std::size_t of : {pressure_part, shear_part}) {
      panel.values[of].grow(nodes + 2);
      panel.sources[of].grow(nodes + 2);
      for (GridIndex i = 0; i < nodes; ++i)
        panel.sources[of][i] =
            of == pressure_part || panel.sign == 0
                ? add(sqrt(grid_->from_left()[i] * grid_->from_right()[i]))
                : ZonePanel::Source{panel.sources[pressure_part][i].column, panel.slip_ratio};
    }
  }
  for (GridIndex right = 1; right < panels_.count(); ++right) {
    ZonePanel &before = panels_[right - 1], &after = panels_[right];
    const ZonePanel::Source value = add(1);
    const bool sticks = before.sign == 0 && after.sign == 0;
    const double ratio = before.sign == 0 ? after.slip_ratio : before.slip_ratio;
    before.sources[pressure_part][nodes + 1] = after.sources[pressure_part][nodes] = value;
    before.sources[shear_part][nodes + 1] = after.sources[shear_part][nodes] =
        sticks ? add(1) : ZonePanel::Source{value.column, ratio};
  }
  leading_column_ = add(1).column;
  if (!problem().creep) creep_column_ = add(1).column;
}

void SlipContact::count_equations() {
  const GridIndex last = grid_->nodes();
  for (GridIndex panel = 0; panel < panels_.count(); ++panel) {
    for (GridIndex i = 0; i <= last; ++i) {
      for (GridIndex part = 0; part < (panels_[panel].sign == 0 ? 2 : 1); ++part) {
        Equation equation{{panel, i}, std::nullopt, part, 0};
        const bool goes_on = panel > 0 && (part == 0 || panels_[panel - 1].sign == 0);
        if (2 * i != last)
          equation.less = {panel, 2 * i < last ? i + 1 : i - 1};
        else if (goes_on)
          equation.at = {panel, 0}, equation.less = {panel - 1, last};
        const PanelPoint& at = point(equation.at).at;
        equation.scale = 1 / sqrt(abs(at.from_left * at.from_right));
        equations_.push_back(std::move(equation));
      }
    }
  }
}

void SlipContact::set(const Vector& unknowns) {
  leading_ = unknowns(leading_column_);
  creep_ = problem().creep ? *problem().creep : unknowns(creep_column_);
  for (ZonePanel& panel : panels_) {
    for (std::size_t of : {pressure_part, shear_part}) {
      for (GridIndex i = 0; i < panel.values[of].count(); ++i) {
        const auto& [column, factor] = panel.sources[of][i];
        if (column >= 0) panel.values[of][i] = factor * unknowns(column);
      }
      panel.loads[of].clear();
      for (GridIndex i = 0; i < grid_->nodes(); ++i)
        panel.loads[of].push_back(grid_->weight()[i] * panel.values[of][i] / pi());
    }
  }
  smooth_.set(panels_);
}

Vector SlipContact::unknowns_of(const SlipField& other) const {
  Vector unknowns(sizes_.count());
  const Float nearest = exp(Float(-other.contact().grid().nats()));
  const GridIndex nodes = grid_->nodes();
  for (const ZonePanel& panel : panels_) {
    const OfBoth<Float> at_left = other.tractions(panel.left),
                        at_right = other.tractions(panel.left + panel.length);
    const auto put = [&](GridIndex value, std::size_t of, const Float& traction) {
      const auto& [column, factor] = panel.sources[of][value];
      if (column >= 0) unknowns(column) = traction / factor;
    };
    for (std::size_t of : {shear_part, pressure_part}) {
      put(nodes, of, at_left[of]);
      put(nodes + 1, of, at_right[of]);
    }
    for (GridIndex i = 0; i < nodes; ++i) {
      // Next to an end, where the other grid is not precise, what is left is like the root of the distance.
      const Float &left = grid_->from_left()[i], &right = grid_->from_right()[i],
                  &distance = std::min(left, right), known = std::max(distance, nearest),
                  part = sqrt(distance / known);
      const Float from_left = left < right ? known : Float(1 - known);
      const OfBoth<Float> tractions = other.tractions(panel.left + panel.length * from_left);
      for (std::size_t of : {shear_part, pressure_part})
        put(i, of, part * (tractions[of] - (1 - from_left) * at_left[of] - from_left * at_right[of]));
    }
  }
  unknowns(leading_column_) = other.contact().leading();
  if (creep_column_ >= 0) unknowns(creep_column_) = other.contact().creep();
  return unknowns;
}

PointSums SlipContact::smooth_part(const ContactPoint& point) const {
  const bool is_inside = point.panel >= 0 && point.panel < panels_.count();
  const ComplexFloat e = panels_.place(point);
  PointSums sums = is_inside ? smooth_.at(e) : smooth_.beside(e.re);
  const GridIndex left = grid_->nodes();
  const auto hats = cauchy_hats(panels_, point);
  for (GridIndex i = 1; i < hats.count(); ++i) {
    sums.normal = sums.normal + hats[i] * panels_[i].values[pressure_part][left];
    sums.tangential = sums.tangential + hats[i] * panels_[i].values[shear_part][left];
  }
  if (!is_inside) return sums;
  const auto& values = panels_[point.panel].values;
  const auto linear = [&](std::size_t of) {
    return point.at.from_right * values[of][left] + point.at.from_left * values[of][left + 1];
  };
  return {sums.normal + linear(shear_part) * problem().beta,
          sums.tangential - linear(pressure_part) * problem().beta};
}

PointSums SlipContact::sums(const ContactPoint& point, bool with_tangential) const {
  const auto [normal, tangential] = smooth_part(point);
  const auto [pressed, sheared] = cauchy_sums(panels_, *grid_, point, with_tangential);
  return {normal + pressed, tangential + sheared};
}

ContactPoint SlipContact::point(const PointIndex& index) const {
  return {index.panel, grid_->points(panels_[index.panel].sign)[index.point]};
}

ComplexFloat SlipContact::left_side(const ContactPoint& point) const {
  const bool sticks = panels_[point.panel].sign == 0;
  const auto [normal, tangential] = sums(point, sticks);
  const ComplexFloat rest = normal + (panels_.place(point) - leading_) * Float(2);
  return sticks ? ComplexFloat(rest.re - tangential.im, rest.im + tangential.re - creep_) : rest;
}

Vector SlipContact::residual() const {
  Row<Row<ComplexFloat>> left_sides(panels_.count());
  for (GridIndex panel = 0; panel < panels_.count(); ++panel)
    for (GridIndex i = 0; i <= grid_->nodes(); ++i) left_sides[panel].push_back(left_side(point({panel, i})));
  const Row<Condition> last = conditions();
  Vector result(equations_.count() + last.count());
  GridIndex row = 0;
  for (const auto& [at, less, part, scale] : equations_) {
    ComplexFloat value = left_sides[at.panel][at.point];
    if (less) value = value - left_sides[less->panel][less->point];
    result(row++) = (part == 0 ? value.re : value.im) * scale;
  }
  for (const auto& [terms, wanted] : last) result(row++) = value_of(terms) - wanted;
  return result;
}

Float SlipContact::value_of(const Row<Condition::Term>& terms) const {
  Float sum = 0;
  for (const auto& [panel, of, value, factor] : terms) sum += factor * panels_[panel].values[of][value];
  return sum;
}

/// Where slip is followed by stick, the coefficient of the root that would slip the wrong way beyond the boundary is 0.
Row<SlipContact::Condition> SlipContact::conditions() const {
  Row<Condition> result;
  for (GridIndex panel = 1; panel < panels_.count(); ++panel) {
    const ZonePanel& before = panels_[panel - 1];
    if (before.sign == 0 || panels_[panel].sign != 0) continue;
    const Float scale = pow(grid_->from_left()[0], Float(-Float(1) / 2 - problem().shift(before.sign)));
    result.push_back(
        {{{panel, shear_part, 0, scale}, {panel, pressure_part, 0, -before.slip_ratio * scale}}, 0});
  }
  result.push_back(problem().length ? Condition{{}, *problem().length - panels_.length()}
                                    : resultant(pressure_part, problem().load));
  if (!problem().creep) result.push_back(resultant(shear_part, problem().shear));
  return result;
}

SlipContact::Condition SlipContact::resultant(std::size_t of, const Float& wanted) const {
  Condition condition{{}, wanted / problem().unit};
  for (GridIndex panel = 0; panel < panels_.count(); ++panel) {
    const Float length = panels_[panel].length / problem().unit;
    for (GridIndex i = 0; i < grid_->nodes(); ++i)
      condition.terms.push_back({panel, of, i, length * grid_->weight()[i]});
    for (GridIndex end : {0, 1}) condition.terms.push_back({panel, of, grid_->nodes() + end, length / 2});
  }
  return condition;
}

Float SlipContact::integral(std::size_t of) const {
  return value_of(resultant(of, 0).terms) * problem().unit;
}

}  // namespace nipref::ref
