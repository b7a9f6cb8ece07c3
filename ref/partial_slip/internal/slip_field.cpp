#include <algorithm>
#include <limits>
#include <utility>

#include <nipref/ref/number/internal/bracketed_root.hpp>
#include <nipref/ref/partial_slip/internal/slip_field.hpp>

namespace nipref::ref {
namespace {

/// The derivative's factor: cot(pi c), what the trapezoidal rule lacks of the principal value.
Float cotangent(const Float& place) { return 1 / tan(Float(pi() * place)); }

}  // namespace

SlipField::SlipField(std::unique_ptr<const SlipContact> contact) : contact_(std::move(contact)) {
  const SlipProblem& problem = contact_->problem();
  const GridIndex nodes = contact_->grid().nodes();
  for (GridIndex number = 0; number < contact_->panels().count(); ++number) {
    const auto& panel = contact_->panels()[number];
    Remainder remainder{contact_->shift(panel.sign) - Float(3) / 4, {}};
    for (GridIndex i = 0; i < 2 * nodes + 2; ++i) {
      const Place place{number, remainder.first + Float(i) / 2};
      const PanelPoint at = contact_->grid().at(place.step);
      const PointSums sums = contact_->sums(number, at);
      const Float e = panel.left + panel.length * at.from_left.re;
      const ComplexFloat normal = 2 * (contact_->leading() - e) - sums.normal.re, cot = cotangent(place.step);
      const Float slipping = panel.sign * problem.friction;
      const ComplexFloat value = panel.sign != 0
                                     ? normal / Float(cot.re + problem.beta * slipping)
                                     : ComplexFloat(normal.re, contact_->creep() - sums.tangential.re) /
                                           ComplexFloat(cot.re, -problem.beta);
      remainder.values[pressure_part].push_back(value.re);
      remainder.values[shear_part].push_back(panel.sign != 0 ? Float(slipping * value.re) : value.im);
    }
    remainders_.push_back(std::move(remainder));
    for (GridIndex i = 0; i < 2 * nodes + 2; ++i) {
      const Place place{number, remainders_.back().first + Float(i) / 2};
      samples_.push_back({place, e_of(place), traction(pressure_part, place), traction(shear_part, place),
                          panel.length * contact_->grid().slope_at(place.step) / 2});
    }
  }
}

SlipField::Place SlipField::place_of(const Float& e) const {
  const auto& panels = contact_->panels();
  GridIndex number = 0;
  while (number + 1 < panels.count() && e >= panels[number + 1].left) ++number;
  const Float from_left = (e - panels[number].left) / panels[number].length;
  const Float nearest = exp(Float(-2 * contact_->grid().nats()));
  const Float x = std::clamp(from_left, nearest, Float(1 - nearest));
  return {number, contact_->grid().place_of(x, 1 - x)};
}

Float SlipField::e_of(const Place& place) const {
  const auto& panel = contact_->panels()[place.panel];
  return panel.left + panel.length * contact_->grid().at(place.step).from_left.re;
}

Float SlipField::remainder(std::size_t of, const Place& place) const {
  const Remainder& remainder = remainders_[place.panel];
  const Row<Float>& values = remainder.values[of];
  Float sum = 0;
  for (GridIndex i = 0; i < values.count(); ++i) {
    const Float way = place.step - remainder.first - Float(i) / 2;
    if (way == 0) return values[i];
    sum += (i % 2 == 0 ? values[i] : -values[i]) / way;
  }
  return sin(Float(2 * pi() * (place.step - remainder.first))) / (2 * pi()) * sum;
}

Float SlipField::traction(std::size_t of, const Place& place) const {
  const PanelPoint at = contact_->grid().at(place.step);
  const auto& values = contact_->panels()[place.panel].values[of];
  return remainder(of, place) + at.from_right.re * values[values.count() - 2] +
         at.from_left.re * values.back();
}

Float SlipField::slope(std::size_t of, const Place& place) const {
  const Remainder& remainder = remainders_[place.panel];
  const Row<Float>& values = remainder.values[of];
  Float sum = 0, squares = 0;
  for (GridIndex i = 0; i < values.count(); ++i) {
    const Float way = place.step - remainder.first - Float(i) / 2,
                value = (i % 2 == 0 ? values[i] : -values[i]) / way;
    sum += value;
    squares += value / way;
  }
  const Float angle = 2 * pi() * (place.step - remainder.first);
  const auto& ends = contact_->panels()[place.panel].values[of];
  return cos(angle) * sum - sin(angle) / (2 * pi()) * squares +
         contact_->grid().slope_at(place.step) * (ends.back() - ends[ends.count() - 2]);
}

Float SlipField::traction(std::size_t of, const Float& e) const {
  return contains(e) ? traction(of, place_of(e)) : Float(0);
}

Float SlipField::strain(const Place& place) const {
  const auto& panel = contact_->panels()[place.panel];
  if (panel.sign == 0) return contact_->creep();
  const PointSums sums = contact_->sums(place.panel, contact_->grid().at(place.step));
  return sums.tangential.re + cotangent(place.step) * remainder(shear_part, place) -
         contact_->problem().beta * remainder(pressure_part, place);
}

Float SlipField::strain(const Float& e) const {
  return contains(e) ? strain(place_of(e)) : contact_->sums_outside(e).tangential.re;
}

/// What a pair of line loads at `from` adds but for the smooth kernels.
void SlipField::add_displacement(const Float& e, const Float& from, const Float& load, const Float& sheared,
                                 Displacement& sum) const {
  const Float way = e - from, logarithm = -log(abs(way)) / pi(),
              step = (way < 0 ? -1 : 1) * contact_->problem().beta / 2;
  sum.normal += logarithm * load + step * sheared;
  sum.tangential += logarithm * sheared - step * load;
}

SlipField::Displacement SlipField::displacement(const Float& e) const {
  Displacement sum{0, 0};
  SheetKernels& kernels = contact_->kernels();
  for (GridIndex i = 0; i < contact_->places().count(); ++i) {
    const Float alpha = e - contact_->places()[i], normal = kernels.smooth_normal(alpha),
                coupling = kernels.coupling(alpha);
    const Float &load = contact_->moments()[pressure_part](i), &sheared = contact_->moments()[shear_part](i);
    sum.normal += (normal * load - coupling * sheared) / pi();
    sum.tangential += (coupling * load + (normal + kernels.stretch(alpha)) * sheared) / pi();
  }
  const ZoneGrid& grid = contact_->grid();
  const GridIndex nodes = grid.nodes();
  for (const auto& panel : contact_->panels()) {
    const Float right = panel.left + panel.length;
    // Where e is inside, of both parts: the logarithm is then at an end.
    Row<Float> ends{panel.left, right};
    if (e > panel.left && e < right) ends.insert(ends.begin() + 1, e);
    for (GridIndex part = 1; part < ends.count(); ++part) {
      const Float length = ends[part] - ends[part - 1];
      for (GridIndex i = 0; i < nodes; ++i) {
        const Float from = ends[part - 1] + length * grid.from_left()[i], weight = length * grid.weight()[i];
        if (from == e) continue;
        Float load, sheared;
        if (ends.count() == 2) {
          load = panel.values[pressure_part][i] + grid.from_right()[i] * panel.values[pressure_part][nodes] +
                 grid.from_left()[i] * panel.values[pressure_part][nodes + 1];
          sheared = panel.values[shear_part][i] + grid.from_right()[i] * panel.values[shear_part][nodes] +
                    grid.from_left()[i] * panel.values[shear_part][nodes + 1];
        } else {
          load = traction(pressure_part, from);
          sheared = traction(shear_part, from);
        }
        add_displacement(e, from, weight * load, weight * sheared, sum);
      }
    }
  }
  return sum;
}

Float SlipField::moment() const {
  Float sum = 0;
  for (const Sample& sample : samples_)
    sum += sample.weight * sample.pressure * (contact_->leading() - sample.e);
  return sum;
}

Float SlipField::dissipation() const {
  Float sum = 0;
  for (const Sample& sample : samples_)
    if (contact_->panels()[sample.place.panel].sign != 0)
      sum -= sample.weight * sample.shear * (strain(sample.place) - contact_->creep());
  return sum;
}

Float SlipField::place_of_largest(std::size_t of) const {
  const auto size = [&](GridIndex i) -> Float {
    return abs(of == pressure_part ? samples_[i].pressure : samples_[i].shear);
  };
  GridIndex best = 0;
  for (GridIndex i = 1; i < samples_.count(); ++i)
    if (size(i) > size(best)) best = i;
  const Place& near = samples_[best].place;
  const Float value = of == pressure_part ? samples_[best].pressure : samples_[best].shear;
  const auto rise = [&](const Float& step) -> Float {
    return (value < 0 ? -1 : 1) * slope(of, {near.panel, step});
  };
  const Float before = near.step - Float(3) / 8, after = near.step + Float(3) / 8;
  if (rise(before) > 0 && rise(after) < 0) {
    const auto step = bracketed_root<Float>(rise, before, after, std::numeric_limits<Float>::epsilon() * 1e4);
    if (step) return e_of({near.panel, *step});
  }
  return samples_[best].e;
}

}  // namespace nipref::ref
