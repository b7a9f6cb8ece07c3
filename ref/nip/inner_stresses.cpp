#include <algorithm>
#include <utility>

#include <nipref/ref/nip/inner_stresses.hpp>
#include <nipref/ref/number/internal/float.hpp>

namespace nipref::ref {
namespace {

struct Judged {
  Float value, error;

  Judged(Float the_value, Float the_error) : value(std::move(the_value)), error(std::move(the_error)) {}
  explicit Judged(const Estimate& x) : value(to_float(x.value)), error(to_float(x.error)) {}
  /// With what half a unit in the last place makes of it.
  [[nodiscard]] Estimate estimated(int digits) const {
    const Float rounding = ldexp(abs(value), 2 - mpfr_get_prec(value.get()));
    return {to_real(value), to_real(error + rounding), digits};
  }
};

/// Enough not to round what is known.
int digits_beyond(const InnerStresses& s) {
  const auto bits =
      std::max({s.across.value.precision(), s.along.value.precision(), s.shear.value.precision()});
  return static_cast<int>(bits * 3 / 10) + 3;
}

Judged mean_of(const InnerStresses& s) {
  const Judged across(s.across), along(s.along);
  return {(across.value + along.value) / 2, (across.error + along.error) / 2};
}

/// The distance of two points changes by no more than both points move.
Judged radius_of(const InnerStresses& s) {
  const Judged across(s.across), along(s.along), shear(s.shear);
  return {hypot((across.value - along.value) / 2, shear.value),
          hypot((across.error + along.error) / 2, shear.error)};
}

}  // namespace

Estimate InnerStresses::maximum_shear() const {
  const WorkingDigits working(digits_beyond(*this));
  return radius_of(*this).estimated(across.digits);
}

Estimate InnerStresses::highest() const {
  const WorkingDigits working(digits_beyond(*this));
  const Judged mean = mean_of(*this), radius = radius_of(*this);
  return Judged(mean.value + radius.value, mean.error + radius.error).estimated(across.digits);
}

Estimate InnerStresses::lowest() const {
  const WorkingDigits working(digits_beyond(*this));
  const Judged mean = mean_of(*this), radius = radius_of(*this);
  return Judged(mean.value - radius.value, mean.error + radius.error).estimated(across.digits);
}

}  // namespace nipref::ref
