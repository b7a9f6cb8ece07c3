#include <deque>
#include <limits>

#include <nipref/ref/number/internal/largest_value.hpp>

namespace nipref::ref {
namespace {

bool is_below(const Interval& x, const Interval& y) { return mpfr_less_p(x.upper(), y.lower()) != 0; }

Float half_width(const Interval& x) { return upper_end(distance_from(middle_of(x), x)); }

/// The numbers of `part` that are in x, too; an empty interval if there are none.
Interval intersection(const Interval& part, const Interval& x) {
  Interval both(part.precision());
  mpfi_intersect(both.get(), part.get(), x.get());
  return both;
}

/// The half-width that the slope's error and the rounding of places leave to the result of Newton's method.
Float least_half_width(const Interval& part, const Interval& slope, const Interval& curvature) {
  return upper_end(magnitude_of(distance_from(middle_of(slope), slope) / curvature)) +
         abs(middle_of(part)) * std::numeric_limits<Float>::epsilon();
}

Interval end_of(const Interval& x, mpfr_srcptr end) {
  Interval result(x.precision());
  mpfi_set_fr(result.get(), end);
  return result;
}

}  // namespace

std::optional<LargestValue> largest_value(const std::function<FunctionOver(const Interval&)>& near,
                                          const Interval& range, const Interval& value_error,
                                          const Interval& slope_error) {
  constexpr int most_parts = 4000;
  const Interval ends =
      larger_of(near(end_of(range, range.lower())).value, near(end_of(range, range.upper())).value);
  Interval reached = ends;
  std::optional<LargestValue> found;
  std::deque<Interval> parts{range};
  for (int done = 0; !parts.empty(); ++done) {
    if (done == most_parts) return std::nullopt;
    const Interval part = parts.front(), middle = interval_of(middle_of(part));
    parts.pop_front();
    const FunctionOver here = near(middle), over = near(part);
    reached = larger_of(reached, here.value);
    const Interval value = here.value + over.slope * (part - middle);
    const bool may_hold_largest = !is_below(value + 2 * value_error, reached) &&
                                  mpfi_has_zero(over.slope.widened(slope_error).get()) != 0;
    if (!may_hold_largest) continue;
    const bool is_concave = mpfr_sgn(over.curvature.upper()) < 0;
    const Interval slope = here.slope.widened(slope_error);
    const Interval rest = is_concave ? intersection(part, middle - slope / over.curvature) : part;
    if (mpfi_is_empty(rest.get()) != 0) continue;
    if (is_concave && half_width(rest) <= 4 * least_half_width(part, slope, over.curvature)) {
      const Interval centre = interval_of(middle_of(rest));
      const LargestValue one{near(centre).value + near(rest).slope * (rest - centre), rest};
      found = found ? LargestValue{larger_of(found->value, one.value), hull(found->place, rest)} : one;
    } else if (2 * half_width(rest) < half_width(part)) {
      parts.push_back(rest);
    } else {
      Interval left(rest.precision()), right(rest.precision());
      mpfi_bisect(left.get(), right.get(), rest.get());
      parts.push_back(left);
      parts.push_back(right);
    }
  }
  if (!found || !is_below(ends + 2 * value_error, reached)) return std::nullopt;
  return LargestValue{larger_of(found->value, reached).widened(value_error), found->place};
}

}  // namespace nipref::ref
