#include <algorithm>

#include <nipref/ref/nip/inner_stresses.hpp>
#include <nipref/ref/number/float.hpp>

namespace nipref::ref {
namespace {

using Number = data::WithError<Float>;

Number number_of(const Estimate& x) { return {at_working_precision(x.value), at_working_precision(x.error)}; }

/// With half a unit in the last place added to the error.
Estimate estimate_of(const Number& x, int digits) {
  const Float rounding = ldexp(abs(x.value), 2 - bits_of(x.value));
  return {x.value, x.error + rounding, digits};
}

/// So many that the stresses are not rounded.
int digits_beyond(const InnerStresses& s) {
  const auto bits = std::max({bits_of(s.across.value), bits_of(s.along.value), bits_of(s.shear.value)});
  return static_cast<int>(bits * 3 / 10) + 3;
}

Number mean_of(const InnerStresses& s) {
  const Number across = number_of(s.across), along = number_of(s.along);
  return {(across.value + along.value) / 2, (across.error + along.error) / 2};
}

/// The distance of two points changes by no more than both points move.
Number radius_of(const InnerStresses& s) {
  const Number across = number_of(s.across), along = number_of(s.along), shear = number_of(s.shear);
  return {hypot((across.value - along.value) / 2, shear.value),
          hypot((across.error + along.error) / 2, shear.error)};
}

}  // namespace

Estimate InnerStresses::maximum_shear() const {
  const WorkingDigits working(digits_beyond(*this));
  return estimate_of(radius_of(*this), across.digits);
}

Estimate InnerStresses::highest() const {
  const WorkingDigits working(digits_beyond(*this));
  const Number mean = mean_of(*this), radius = radius_of(*this);
  return estimate_of({mean.value + radius.value, mean.error + radius.error}, across.digits);
}

Estimate InnerStresses::lowest() const {
  const WorkingDigits working(digits_beyond(*this));
  const Number mean = mean_of(*this), radius = radius_of(*this);
  return estimate_of({mean.value - radius.value, mean.error + radius.error}, across.digits);
}

}  // namespace nipref::ref
