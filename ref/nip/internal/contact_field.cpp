#include <algorithm>
#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/nip/internal/contact_field.hpp>
#include <nipref/ref/number/enclosure.hpp>

namespace nipref::ref {
namespace {

constexpr int rough_digits = 8;
constexpr int guard = 4;  ///< digits of the quadratures beyond those of the contact

Float power_of_ten(int exponent) { return pow(Float(10), exponent); }

Float shear_of(const FloatStresses& s) { return hypot((s.across - s.along) / 2, s.shear); }

Float largest_difference(const FloatStresses& a, const FloatStresses& b) {
  return std::max({abs(a.across - b.across), abs(a.along - b.along), abs(a.shear - b.shear)});
}

}  // namespace

/// A place where the slopes are 0 and how well it is known.
struct ContactField::Peak {
  Place place;
  Float unsure;
  Float missed;  ///< of the largest shear, where samples alone are known
};

ContactField::ContactField(const FieldSource& coarse, const FieldSource& fine, const Float& scale,
                           const Float& uncertainty, int digits)
    : coarse_(coarse.middle, coarse.half_length, coarse.tractions, {digits + guard, 1, scale}),
      fine_(fine.middle, fine.half_length, fine.tractions, {digits + guard, 1.3, scale}),
      rough_(fine.middle, fine.half_length, fine.tractions, {rough_digits, 1, scale}),
      middle_(fine.middle),
      half_length_(fine.half_length),
      scale_(scale),
      uncertainty_(uncertainty),
      digits_(digits) {}

InnerStresses ContactField::at(const Place& place, bool symmetric, const Float& unit) const {
  const FloatStresses value = fine_.at(place.alpha, place.depth);
  const Float error = 2 * largest_difference(value, coarse_.at(place.alpha, place.depth)) +
                      scale_ * power_of_ten(-digits_ - 2) + uncertainty_;
  const auto estimated = [&](const Float& x) -> Estimate {
    return {to_real(unit * x), to_real(unit * error), digits_};
  };
  const bool no_shear = place.depth == 0 || (symmetric && place.alpha == 0);
  return {estimated(value.across), estimated(value.along),
          no_shear ? Estimate(exact_zero(digits_)) : estimated(value.shear)};
}

/// As far as nothing is singular: the nearer end, half of the contact or of the sheet.
Float ContactField::reach(const Place& place) const {
  const Float to_end = hypot(half_length_ - abs(place.alpha - middle_), 1 - place.depth);
  return std::min({Float(1), half_length_, to_end});
}

ContactField::Place ContactField::best_sample(bool symmetric) const {
  const Float reach = std::min(Float(1), half_length_);
  Place best{middle_, 1};
  Float largest = -1;
  const auto look = [&](const Place& place) {
    const Float here = shear_of(rough_.at(place.alpha, place.depth));
    if (!(here > largest)) return false;
    largest = here;
    best = place;
    return true;
  };
  constexpr int across = 10;
  const int steps = 10 + static_cast<int>(2 * static_cast<double>(half_length_));
  const Float deepest = std::min(Float(1), 2.5 * reach);
  for (int i = symmetric ? 0 : -steps; i <= steps; ++i) {
    const Float alpha = middle_ + half_length_ * sin(pi() * i / (2 * steps));
    for (int j = 0; j <= across; ++j) look({alpha, 1 - deepest * j / across});
  }
  const auto moved = [&](const Float& along, const Float& inwards) {
    const Float alpha = best.alpha + along, depth = std::min(Float(1), best.depth + inwards);
    return look({symmetric ? abs(alpha) : alpha, abs(depth)});
  };
  for (Float step = reach / across; step > std::max(this->reach(best), 1e-6 * reach) / 2000;) {
    if (!(moved(step, 0) || moved(-step, 0) || moved(0, step) || moved(0, -step))) step /= 2;
  }
  return best;
}

/// Slopes by central differences of fourth order with a step that balances what they leave out with the field's
/// digits; on a face along it alone.
ContactField::Peak ContactField::peak(const InnerField& field, const Place& near) const {
  const Float reach = this->reach(near);
  const bool on_face = near.depth == 1;
  const Float step = reach * pow(Float(10), -(digits_ + guard) / Float(5)) / 4;
  const auto value = [&](const Place& at) { return shear_of(field.at(at.alpha, at.depth)); };
  Place at = near;
  Float change = reach;
  for (int round = 0; round < 12; ++round) {
    const Float middle = value(at);
    const auto beside = [&](int i, int j) { return value({at.alpha + i * step, at.depth + j * step}); };
    struct Differences {
      Float slope, curvature;
    };
    const auto along = [&](int i, int j) -> Differences {
      const Float a = beside(i, j), b = beside(-i, -j);
      const Float first = a - b, second = beside(2 * i, 2 * j) - beside(-2 * i, -2 * j);
      return {(8 * first - second) / (12 * step), (a + b - 2 * middle) / (step * step)};
    };
    const Differences x = along(1, 0);
    Float to_x = -x.slope / x.curvature, to_y = 0;
    if (!on_face) {
      const Differences y = along(0, 1);
      const Float mixed = (beside(1, 1) + beside(-1, -1) - beside(1, -1) - beside(-1, 1)) / (4 * step * step);
      const Float determinant = x.curvature * y.curvature - mixed * mixed;
      to_x = (mixed * y.slope - y.curvature * x.slope) / determinant;
      to_y = (mixed * x.slope - x.curvature * y.slope) / determinant;
    }
    const Float now = hypot(to_x, to_y);
    // No maximum with slopes of 0 where the samples have theirs.
    if (!(now < reach / 20) || (!on_face && at.depth + to_y > 1 - 3 * step))
      return {near, reach / 100, middle * 1e-6};
    at = {at.alpha + to_x, at.depth + to_y};
    if (!(now < change / 2) || now < reach * power_of_ten(-digits_)) break;
    change = now;
  }
  return {at, reach * pow(Float(10), -4 * (digits_ + guard) / Float(5)) / 10, 0};
}

GreatestShear ContactField::greatest(bool symmetric, const Float& unit, const Float& length) const {
  const Place sample = best_sample(symmetric);
  const Peak coarse = peak(coarse_, sample);
  Peak fine = peak(fine_, sample);
  // What lies on a line of symmetry does so exactly.
  if (symmetric && abs(fine.place.alpha) < fine.unsure) fine.place.alpha = 0;
  if (abs(fine.place.depth) < fine.unsure) fine.place.depth = 0;
  Estimate value = at(fine.place, symmetric, unit).maximum_shear();
  value.error = to_real(to_float(value.error) + unit * fine.missed);
  const auto place = [&](const Float& here, const Float& other, const Float& in_unit) -> Estimate {
    return {to_real(in_unit * here),
            to_real(in_unit * (2 * abs(here - other) + fine.unsure + power_of_ten(-digits_ - 2))), digits_};
  };
  return {value, place(fine.place.alpha, coarse.place.alpha, length),
          place(fine.place.depth, coarse.place.depth, 1)};
}

ContactField::Place checked_place(const InnerPoint& point, const Float& length) {
  if (!std::isfinite(point.y) || abs(point.y / length) > farthest_inside)
    throw data::BadInput("y", point.y,
                         "must be within 450 sheet thicknesses of the middle on the reference path");
  if (!(std::fabs(point.depth) <= 1))
    throw data::BadInput("depth", point.depth, "must satisfy -1 <= depth <= 1");
  return {point.y / length, point.depth};
}

}  // namespace nipref::ref
