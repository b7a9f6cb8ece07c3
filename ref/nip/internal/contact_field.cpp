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

/// Of the middle and of the radius of Mohr's circle.
Estimate of_circle(const InnerStresses& of, long middles, long radii) {
  const Interval across = interval_of(of.across), along = interval_of(of.along);
  const Interval radius = sqrt(square((across - along) / 2) + square(interval_of(of.shear)));
  Estimate result = enclosure_of(middles * (across + along) / 2 + radii * radius, of.across.digits);
  result.proven = of.across.proven && of.along.proven && of.shear.proven;
  return result;
}

}  // namespace

Estimate InnerStresses::maximum_shear() const { return of_circle(*this, 0, 1); }
Estimate InnerStresses::highest() const { return of_circle(*this, 1, 1); }
Estimate InnerStresses::lowest() const { return of_circle(*this, 1, -1); }

/// A point where the gradient is 0.
struct ContactField::Peak {
  SheetPoint point;
  Float point_error;
  Float shear_error;  ///< error of the largest shear where the point is that of the best sample
};

ContactField::ContactField(const FieldSource& coarse, const FieldSource& fine, const Float& scale,
                           const Float& uncertainty, int digits)
    : coarse_(coarse, {digits + guard, 1, scale}),
      fine_(fine, {digits + guard, 1.3, scale}),
      rough_(fine, {rough_digits, 1, scale}),
      middle_(fine.middle),
      half_length_(fine.half_length),
      scale_(scale),
      uncertainty_(uncertainty),
      digits_(digits) {}

InnerStresses ContactField::at(const SheetPoint& point, bool symmetric, const Float& unit) const {
  const FloatStresses value = fine_.at(point);
  const Float error =
      2 * largest_difference(value, coarse_.at(point)) + scale_ * power_of_ten(-digits_ - 2) + uncertainty_;
  const auto estimated = [&](const Float& x) -> Estimate { return {unit * x, unit * error, digits_}; };
  const bool no_shear = point.depth == 0 || (symmetric && point.alpha == 0);
  return {estimated(value.across), estimated(value.along),
          no_shear ? Estimate(exact_zero(digits_)) : estimated(value.shear)};
}

InnerDisplacements ContactField::displacements_at(const SheetPoint& point, const FloatShares& share,
                                                  const Float& uncertain, const Float& unit) const {
  const FloatDisplacements value = fine_.displacements(point, share),
                           other = coarse_.displacements(point, share);
  const auto estimated = [&](const Float& x, const Float& y, bool is_zero) -> Estimate {
    if (is_zero) return exact_zero(digits_);
    return {unit * x, unit * (2 * abs(x - y) + uncertain), digits_};
  };
  const int inwards = point.depth < 0 ? 1 : -1;
  return {estimated(inwards * value.across, inwards * other.across, point.depth == 0),
          estimated(value.along, other.along, point.alpha == 0)};
}

/// The distance over which the field is smooth: to the nearer end, but at most half the contact or half the sheet.
Float ContactField::smooth_radius(const SheetPoint& point) const {
  const Float to_end = hypot(half_length_ - abs(point.alpha - middle_), 1 - point.depth);
  return std::min({Float(1), half_length_, to_end});
}

SheetPoint ContactField::best_sample(bool symmetric) const {
  const Float reach = std::min(Float(1), half_length_);
  SheetPoint best{middle_, 1};
  Float largest = -1;
  const auto is_better = [&](const SheetPoint& point) {
    const Float shear = shear_of(rough_.at(point));
    if (!(shear > largest)) return false;
    largest = shear;
    best = point;
    return true;
  };
  constexpr int across = 10;
  const int steps = 10 + static_cast<int>(2 * static_cast<double>(half_length_));
  const Float deepest = std::min(Float(1), 2.5 * reach);
  for (int i = symmetric ? 0 : -steps; i <= steps; ++i) {
    const Float alpha = middle_ + half_length_ * sin(pi() * i / (2 * steps));
    for (int j = 0; j <= across; ++j) is_better({alpha, 1 - deepest * j / across});
  }
  const auto moved = [&](const Float& along, const Float& inwards) {
    const Float alpha = best.alpha + along, depth = std::min(Float(1), best.depth + inwards);
    return is_better({symmetric ? abs(alpha) : alpha, abs(depth)});
  };
  for (Float step = reach / across; step > std::max(smooth_radius(best), 1e-6 * reach) / 2000;) {
    if (!(moved(step, 0) || moved(-step, 0) || moved(0, step) || moved(0, -step))) step /= 2;
  }
  return best;
}

/// The gradient is computed by central differences of fourth order, with a step that balances their truncation error
/// with the field's digits. On a face only the derivative along it is used.
ContactField::Peak ContactField::peak(const InnerField& field, const SheetPoint& near) const {
  const Float reach = smooth_radius(near);
  const bool on_face = near.depth == 1;
  const Float step = reach * pow(Float(10), -(digits_ + guard) / Float(5)) / 4;
  const auto value = [&](const SheetPoint& at) { return shear_of(field.at(at)); };
  SheetPoint at = near;
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
    // The gradient has no zero near the best sample.
    if (!(now < reach / 20) || (!on_face && at.depth + to_y > 1 - 3 * step))
      return {near, reach / 100, middle * 1e-6};
    at = {at.alpha + to_x, at.depth + to_y};
    if (!(now < change / 2) || now < reach * power_of_ten(-digits_)) break;
    change = now;
  }
  return {at, reach * pow(Float(10), -4 * (digits_ + guard) / Float(5)) / 10, 0};
}

GreatestShear ContactField::greatest(bool symmetric, const Float& unit, const Float& length) const {
  const SheetPoint sample = best_sample(symmetric);
  const Peak coarse = peak(coarse_, sample);
  Peak fine = peak(fine_, sample);
  // A maximum that is on a line of symmetry within its error is exactly on it.
  if (symmetric && abs(fine.point.alpha) < fine.point_error) fine.point.alpha = 0;
  if (abs(fine.point.depth) < fine.point_error) fine.point.depth = 0;
  Estimate value = at(fine.point, symmetric, unit).maximum_shear();
  value.error = at_working_precision(value.error) + unit * fine.shear_error;
  const auto coordinate = [&](const Float& by_fine, const Float& by_coarse,
                              const Float& in_unit) -> Estimate {
    const Float error = 2 * abs(by_fine - by_coarse) + fine.point_error + power_of_ten(-digits_ - 2);
    return {in_unit * by_fine, in_unit * error, digits_};
  };
  return {value, coordinate(fine.point.alpha, coarse.point.alpha, length),
          coordinate(fine.point.depth, coarse.point.depth, 1)};
}

SheetPoint checked_point(const InnerPoint& point, const Float& length) {
  if (!std::isfinite(point.y) || abs(point.y / length) > farthest_inside)
    throw data::BadInput("y", point.y,
                         "must be within 450 sheet thicknesses of the middle on the reference path");
  if (!(std::fabs(point.depth) <= 1))
    throw data::BadInput("depth", point.depth, "must satisfy -1 <= depth <= 1");
  return {point.y / length, point.depth};
}

}  // namespace nipref::ref
