#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/grade/condition.hpp>

namespace nipref::verify {
namespace {

constexpr int digits = 40;
constexpr double step = 0x1p-20;

/// f(..., x (1 + step), ...) - f(..., x (1 - step), ...)
double difference(const Quantity& quantity, const Point& point, std::size_t argument) {
  Point above = point, below = point;
  above[argument] *= 1 + step;
  below[argument] *= 1 - step;
  ref::Real change = ref_value(quantity, above, digits).value;
  mpfr_sub(change.get(), change.get(), ref_value(quantity, below, digits).value.get(), MPFR_RNDN);
  return mpfr_get_d(change.get(), MPFR_RNDN);
}

}  // namespace

std::optional<double> condition_number(const Quantity& quantity, const Point& point) try {
  const double value = ref_value(quantity, point, digits).to_double();
  if (value == 0) return std::nullopt;
  double sum = 0;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const ArgumentKind kind = quantity.arguments[i].kind;
    if (kind == ArgumentKind::choice || kind == ArgumentKind::index || point[i] == 0) continue;
    sum += std::fabs(difference(quantity, point, i) / (2 * step) / value);
  }
  return sum;
} catch (const data::BadInput&) {
  return std::nullopt;
}

}  // namespace nipref::verify
