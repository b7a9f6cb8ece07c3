#include "ref/transform.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "ref/clenshaw.hpp"

namespace nipref::ref {
namespace {

constexpr double ln2 = std::numbers::ln2;
constexpr double top = 2;
constexpr mpfr_prec_t bound_precision = 64;

/// Lower edge y_b of the strip and the integral of |G| along it.
struct LowerEdge {
  double height;
  double integral;
};

LowerEdge lower_edge(const SymbolBounds& symbol, double s) {
  if (symbol.origin == OriginPole::twofold && s > 0) return {0.25, symbol.lower_integral};
  return {-top, symbol.integral};
}

/// Largest double m 2^-k <= limit with m = 4 .. 7, at most 1/4: few steps, so that many arguments share their
/// nodes.
double round_step(double limit) {
  int exponent = 0;
  const double fraction = std::frexp(std::min(limit, 0.25), &exponent);
  return std::ldexp(std::floor(fraction * 8), exponent - 3);
}

/// F rounded up to a multiple of 16, or of about an eighth of itself.
long round_bits(double bits) {
  const double grain = bits <= 256 ? 16 : 32 * std::exp2(std::floor(std::log2(bits / 256)));
  return static_cast<long>(std::ceil(bits / grain) * grain);
}

/// 2 pi/h that brings both aliasing terms below e^{-nats}/8.
double frequency(const SymbolBounds& symbol, double s, double x, double nats) {
  const LowerEdge lower = lower_edge(symbol, s);
  if (symbol.parity == Parity::odd) {
    const double integral = x < 1 ? symbol.moment : symbol.integral;
    return std::max(1.0, (nats + std::log(8 * integral) + 2 * x) / top);
  }
  const double above = (nats + std::log(4 * symbol.integral) - top * x) / (top - s);
  const double below = (nats + std::log(4 * lower.integral) - x * lower.height) / (s - lower.height);
  return std::max({1.0, above, below});
}

struct Plan {
  NodeKey key;
  double cost;  ///< relative time of the sum
};

Plan make_plan(Symbol symbol, Line line, double x, double nats) {
  const SymbolBounds& constants = bounds(symbol);
  const double s = height(line);
  const double step = round_step(2 * std::numbers::pi / frequency(constants, s, x, nats));
  const double summed_nats = std::max(nats - x * s, 1.0);
  const double count = (summed_nats + 40) / (constants.decay * step);
  const double growth = constants.parity == Parity::odd ? std::max(1.0, step * count) : 1.0;
  const long bits = round_bits(summed_nats / ln2 + std::log2(128 * count * growth));
  const double sums = line == Line::real_axis ? 1 : 2;
  return {{symbol, line, step, bits}, sums * count * std::pow(static_cast<double>(bits) + 100, 1.5)};
}

Plan best_plan(Symbol symbol, double x, double nats) {
  const SymbolBounds& constants = bounds(symbol);
  std::optional<Plan> best;
  for (const Line line : {Line::real_axis, Line::one, Line::seven_quarters}) {
    if (constants.parity == Parity::odd && line != Line::real_axis) continue;
    const Plan plan = make_plan(symbol, line, x, nats);
    if (!best || plan.cost < best->cost) best = plan;
  }
  return *best;
}

Interval number(double value) { return {value, bound_precision}; }

/// M e^{-x y}/(e^{2 pi d/h} - 1).
Interval image(double integral, const Interval& x, double edge, double distance, double step) {
  const Interval periods = 2 * Interval::pi(bound_precision) * number(distance) / number(step);
  return number(integral) * exp(-(x * number(edge))) / expm1(periods);
}

Interval power_of_two(long exponent) {
  Interval result(1L, bound_precision);
  mpfi_mul_2si(result.get(), result.get(), exponent);
  return result;
}

Interval even_error(const SymbolBounds& symbol, const Nodes& nodes, const Interval& x) {
  const NodeKey& key = nodes.key;
  const double s = height(key.line);
  const LowerEdge lower = lower_edge(symbol, s);
  const Interval aliasing = (image(symbol.integral, x, top, top - s, key.step) +
                             image(lower.integral, x, lower.height, s - lower.height, key.step)) /
                            2;
  const long recurrences = key.line == Line::real_axis ? 1 : 2;
  const Interval sum(truncation_units + rounding_units * recurrences * (nodes.last + 3), bound_precision);
  return aliasing + exp(-(x * number(s))) * sum * power_of_two(-key.fraction_bits);
}

Interval odd_error(const SymbolBounds& symbol, const Nodes& nodes, const Interval& x) {
  const NodeKey& key = nodes.key;
  const Interval periods = 4 * Interval::pi(bound_precision) / number(key.step);
  const Interval aliasing =
      minimum(number(symbol.integral), number(symbol.moment) * x) * cosh(number(top) * x) / expm1(periods);
  const Interval count(nodes.last + 3, bound_precision);
  const Interval theta = x * number(key.step);
  const Interval one_minus_ratio = -expm1(number(-symbol.decay) * number(key.step));
  const Interval truncation = truncation_units * minimum(number(1), theta * count / one_minus_ratio);
  const Interval rounding = rounding_units * minimum(count, theta * square(count));
  return aliasing + (truncation + rounding) * power_of_two(-key.fraction_bits);
}

/// What the sum over j = 0 .. last has to be completed with: the shifted line's factor, and on the real axis
/// the parts of the residue at 0 that depend on x.
Interval with_origin_terms(const Interval& sum, const SymbolBounds& symbol, const NodeKey& key,
                           const Interval& x) {
  const Interval step(key.step, x.precision());
  if (key.line != Line::real_axis) return exp(-(x * Interval(height(key.line), x.precision()))) * sum;
  switch (symbol.origin) {
    case OriginPole::none:
      return sum;
    case OriginPole::simple:
      return sum + step * x / 4;
    case OriginPole::twofold:
      return sum - step * square(x) / 8 + Interval::pi(x.precision()) / 4 * x;
  }
  return sum;
}

}  // namespace

Interval transform(Symbol symbol, const Exact& x, double nats) {
  const SymbolBounds& constants = bounds(symbol);
  const double size = x.approximate();
  const Plan plan = best_plan(symbol, size, nats);
  const auto set = nodes(plan.key);
  const Angle angle(x.value() * plan.key.step, angle_precision(*set));
  const bool odd = constants.parity == Parity::odd;
  const Real sum = odd ? sine_sum(*set, angle) : wave_sum(*set, angle);
  Interval value(sum, sum, sum.precision());
  value = with_origin_terms(value, constants, plan.key, Interval(x, sum.precision()));
  const Interval wide_x(x, bound_precision);
  return value.widened(odd ? odd_error(constants, *set, wide_x) : even_error(constants, *set, wide_x));
}

}  // namespace nipref::ref
