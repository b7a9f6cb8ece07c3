#include <algorithm>

#include <nipref/ref/nip/inner_stresses.hpp>
#include <nipref/ref/number/float.hpp>

namespace nipref::ref {
namespace {

using Number = data::WithError<Float>;

Number number_of(const Estimate& x) { return {at_working_precision(x.value), at_working_precision(x.error)}; }

/// Of value +- other, with what roundings do to it and, a thousandth at most, to its error.
Estimate estimate_of(const Number& value, const Number& other, int sign, const InnerStresses& of) {
  const Float sum = value.value + sign * other.value, size = abs(value.value) + abs(other.value);
  const Float error = value.error + other.error + ldexp(size, 2 - bits_of(sum));
  Estimate result{sum, error * (1 + Float(1e-3)), of.across.digits};
  result.proven = of.across.proven && of.along.proven && of.shear.proven;
  return result;
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
  return estimate_of(radius_of(*this), {0, 0}, 1, *this);
}

Estimate InnerStresses::highest() const {
  const WorkingDigits working(digits_beyond(*this));
  return estimate_of(mean_of(*this), radius_of(*this), 1, *this);
}

Estimate InnerStresses::lowest() const {
  const WorkingDigits working(digits_beyond(*this));
  return estimate_of(mean_of(*this), radius_of(*this), -1, *this);
}

}  // namespace nipref::ref
