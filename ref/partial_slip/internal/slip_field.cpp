#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <numbers>
#include <utility>

#include <nipref/ref/partial_slip/internal/slip_field.hpp>

namespace nipref::ref {
namespace {

/// The trapezoidal rule for a principal value lacks cot(pi c) times the remainder.
Float cotangent(const Float& place) { return 1 / tan(Float(pi() * place)); }

}  // namespace

SlipField::SlipField(std::unique_ptr<const SlipContact> contact) : contact_(std::move(contact)) {
  const SlipProblem& problem = contact_->problem();
  for (GridIndex number = 0; number < contact_->panels().count(); ++number) {
    const ZonePanel& panel = contact_->panels()[number];
    remainders_.push_back({problem.shift(panel.sign) - Float(3) / 4, {}});
    auto& [first, values] = remainders_[number];
    for (GridIndex i = 0; i < 2 * contact_->grid().nodes() + 2; ++i) {
      const Place place{number, first + Float(i) / 2};
      const ContactPoint point{number, contact_->grid().at(place.step)};
      const PointSums sums = contact_->sums(point, true);
      const Float e = contact_->panels().place(point).re, cot = cotangent(place.step),
                  normal = 2 * (leading() - e) - sums.normal.re;
      const ComplexFloat value =
          panel.sign != 0
              ? ComplexFloat(normal / (cot + problem.beta * panel.slip_ratio))
              : ComplexFloat(normal, creep() - sums.tangential.re) / ComplexFloat(cot, -problem.beta);
      const OfBoth<Float> remainders{value.re, panel.sign != 0 ? panel.slip_ratio * value.re : value.im};
      for (std::size_t of : {pressure_part, shear_part}) values[of].push_back(remainders[of]);
      samples_.push_back({number, panel.sign, place.step, e, strain_at(place, sums, remainders) - creep(),
                          panel.length * contact_->grid().slope_at(place.step) / 2,
                          tractions(point, remainders)});
    }
  }
}

SlipField::Place SlipField::place_of(const Float& e) const {
  const ZonePanels& panels = contact_->panels();
  GridIndex number = 0;
  while (number + 1 < panels.count() && e >= panels[number + 1].left) ++number;
  const Float nearest = exp(Float(-2 * contact_->grid().nats()));
  const Float x =
      std::clamp(Float((e - panels[number].left) / panels[number].length), nearest, Float(1 - nearest));
  return {number, contact_->grid().place_of(x, 1 - x)};
}

OfBoth<Float> SlipField::remainders(const Place& place) const {
  const ZonePanel& panel = contact_->panels()[place.panel];
  const auto& [first, values] = remainders_[place.panel];
  const Float steps = place.step - first;
  OfBoth<Float> sums{0, 0};
  Float way = steps, over, scratch;
  // In place, as this is most of the work of displacements.
  for (GridIndex i = 0; i < values[pressure_part].count(); ++i) {
    if (way == 0) return {values[pressure_part][i], values[shear_part][i]};
    mpfr_si_div(raw(over), i % 2 == 0 ? 1 : -1, raw(way), MPFR_RNDN);
    add_product(sums[pressure_part], scratch, over, values[pressure_part][i]);
    if (panel.sign == 0) add_product(sums[shear_part], scratch, over, values[shear_part][i]);
    mpfr_sub_d(raw(way), raw(way), 0.5, MPFR_RNDN);
  }
  const Float factor = sin(Float(2 * pi() * steps)) / (2 * pi()), pressure = factor * sums[pressure_part];
  return {pressure, panel.sign == 0 ? factor * sums[shear_part] : panel.slip_ratio * pressure};
}

OfBoth<Float> SlipField::tractions(const ContactPoint& point, const OfBoth<Float>& remainders) const {
  const OfBoth<Vector>& values = contact_->values();
  const GridIndex left = contact_->panels()[point.panel].first + contact_->grid().nodes();
  const auto with_linear = [&](std::size_t of) -> Float {
    return remainders[of] + point.at.from_right.re * values[of](left) +
           point.at.from_left.re * values[of](left + 1);
  };
  return {with_linear(pressure_part), with_linear(shear_part)};
}

OfBoth<Float> SlipField::tractions(const Place& place) const {
  return tractions({place.panel, contact_->grid().at(place.step)}, remainders(place));
}

OfBoth<Float> SlipField::tractions(const Float& e) const {
  return contains(e) ? tractions(place_of(e)) : OfBoth<Float>{0, 0};
}

Float SlipField::strain_at(const Place& place, const PointSums& sums, const OfBoth<Float>& remainders) const {
  if (contact_->panels()[place.panel].sign == 0) return creep();
  return sums.tangential.re + cotangent(place.step) * remainders[shear_part] -
         contact_->problem().beta * remainders[pressure_part];
}

Float SlipField::strain(const Float& e) const {
  if (contains(e)) {
    const Place place = place_of(e);
    return strain_at(place, contact_->sums({place.panel, contact_->grid().at(place.step)}, true),
                     remainders(place));
  }
  Float sum = contact_->smooth().strain(e);
  for_loads(e, [&](const Float& from, const Float& /*pressed*/, const Float& sheared) {
    sum += sheared / (pi() * (from - e));
  });
  return sum;
}

/// The loads lie at the rule's nodes on each panel. The panel with e is split at e, as potentials are logarithmic
/// there.
void SlipField::for_loads(const Float& e, const UseLoad& use) const {
  const ZoneGrid& grid = contact_->grid();
  const ZonePanels& panels = contact_->panels();
  for (GridIndex number = 0; number < panels.count(); ++number) {
    const Float &left = panels[number].left, &length = panels[number].length;
    const bool is_inside = e > left && e < left + length;
    for (GridIndex i = 0; i < grid.nodes(); ++i) {
      const Float &from_left = grid.from_left()[i], &weight = grid.weight()[i];
      const auto use_at = [&](const Float& begin, const Float& part, const OfBoth<Float>& tractions) {
        use(begin + part * from_left, part * weight * tractions[pressure_part],
            part * weight * tractions[shear_part]);
      };
      if (is_inside) {
        use_at(left, e - left, tractions(Float(left + (e - left) * from_left)));
        use_at(e, left + length - e, tractions(Float(e + (left + length - e) * from_left)));
      } else {
        const auto& [pressures, shears] = contact_->values();
        const GridIndex value = panels[number].first + i;
        use_at(left, length,
               tractions(ContactPoint{number, {from_left, grid.from_right()[i]}},
                         {pressures(value), shears(value)}));
      }
    }
  }
}

NormalAndTangential<Float> SlipField::displacement(const Float& e) const {
  auto sum = contact_->smooth().displacement(e);
  for_loads(e, [&](const Float& from, const Float& pressed, const Float& sheared) {
    const Float way = e - from;
    if (way == 0) return;
    const Float logarithm = -log(abs(way)) / pi(), step = (way < 0 ? -1 : 1) * contact_->problem().beta / 2;
    sum.normal += logarithm * pressed + step * sheared;
    sum.tangential += logarithm * sheared - step * pressed;
  });
  return sum;
}

/// In the contact the surface follows the roller.
Float SlipField::normal_displacement(const Float& e) const {
  const Float y = leading() - e;
  return contains(e) ? Float(indentation() - y * y) : displacement(e).normal;
}

Float SlipField::tangential_displacement(const Float& e) const {
  if (!tangential_in_middle_) tangential_in_middle_ = displacement(leading()).tangential;
  return displacement(e).tangential - *tangential_in_middle_;
}

Float SlipField::boundary(GridIndex zone) const {
  Float e = 0;
  for (GridIndex i = 0; i < std::min(zone, zones().count()); ++i) e += zones()[i].length;
  return e;
}

Float SlipField::rolling_resistance() const {
  Float moment = 0;
  for (const Sample& sample : samples_)
    moment += sample.weight * sample.tractions[pressure_part] * (leading() - sample.e);
  return 2 * moment / load();
}

Float SlipField::dissipation() const {
  Float sum = 0;
  for (const Sample& sample : samples_) sum -= sample.weight * sample.tractions[shear_part] * sample.slip;
  return sum;
}

Row<SlipField::Hump> SlipField::humps(std::size_t of) const {
  const auto size = [of](const OfBoth<Float>& tractions) -> Float { return abs(tractions[of]); };
  const auto by_size = [&](const Sample& sample) { return size(sample.tractions); };
  // A maximum that is nearer to a joint cannot be told from the joint.
  const Float nearest = exp(Float(-contact_->grid().nats())) * length();
  // Bits for a place in steps to e^-nats.
  const int bits = static_cast<int>(contact_->grid().nats() / std::numbers::ln2) + 10;
  Row<Hump> humps;
  for (GridIndex i = 1; i + 1 < samples_.count(); ++i) {
    const Sample &before = samples_[i - 1], &here = samples_[i], &after = samples_[i + 1];
    const ZonePanel& panel = contact_->panels()[here.panel];
    if (std::min(here.e - panel.left, panel.left + panel.length - here.e) < nearest ||
        by_size(here) <= by_size(before) || by_size(here) < by_size(after))
      continue;
    const auto [step, negative] = boost::math::tools::brent_find_minima(
        [&](const Float& place) -> Float {
          return -size(tractions(Place{here.panel, place}));
        },
        before.step, after.step, bits);
    humps.push_back({-negative, contact_->panels().place({here.panel, contact_->grid().at(step)}).re});
  }
  // The values where panels meet.
  for (const ZonePanel& panel : contact_->panels())
    humps.push_back({abs(contact_->values()[of](panel.first + contact_->grid().nodes())), panel.left});
  return humps;
}

SlipField::Hump SlipField::largest(std::size_t of) const {
  return std::ranges::max(humps(of), {}, &Hump::size);
}

}  // namespace nipref::ref
