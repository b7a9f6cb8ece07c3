#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/ref/sheet/internal/clenshaw.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/internal/residues.hpp>
#include <nipref/ref/sheet/internal/transform.hpp>

namespace nipref::ref {
namespace {

constexpr double step_limit = 0.25;
constexpr mpfr_prec_t bound_precision = 64;

/// F, rounded up to a multiple of 16, or of about an eighth of itself if that is more.
long round_bits(double bits) {
  const double grain = bits <= 256 ? 16 : 32 * std::exp2(std::floor(std::log2(bits / 256)));
  return static_cast<long>(std::ceil(bits / grain) * grain);
}

/// The m of the line Im z = 4 pi m on which the aliasing error is bounded; 0 stands for Im z = 2, which costs less up
/// to some hundred digits (measured). For more digits m is so large that the largest step is possible for x up to 5.
/// The number of nodes then grows like nats, not like nats^2.
long lines_passed(double nats) {
  constexpr double few = 300, most_frequency = 2 * std::numbers::pi / step_limit - 5;
  if (nats <= few) return 0;
  return static_cast<long>(std::ceil(nats / (4 * std::numbers::pi * most_frequency)));
}

/// Im z of the line on which the aliasing error is bounded.
double top_of(long lines) { return lines == 0 ? 2 : 4 * std::numbers::pi * static_cast<double>(lines); }

/// A bound of int |z G(z)| |dz| along Im z = top.
double moment(const SymbolBounds& symbol, double top) { return symbol.moment * top / 2; }

/// The step and fraction bits for which each part of the error is below about e^{-nats}, times min(1, x) for odd
/// symbols.
NodeKey node_key(Symbol symbol, double x, double nats, double top) {
  const SymbolBounds& constants = bounds(symbol);
  const bool odd = constants.is_odd;
  const double integral = odd && x < 1 ? moment(constants, top) : constants.integral;
  const double frequency = std::max(1.0, (nats + std::log(8 * integral) + top * x) / top);
  // As only a few steps occur, many arguments share their nodes.
  const double step = of_few_bits(std::min(2 * std::numbers::pi / frequency, step_limit), 3);
  const double count = (nats + 40) / (constants.decay * step);
  const double growth = odd ? std::max(1.0, step * count) : 1.0;
  return {symbol, step, round_bits(nats / std::numbers::ln2 + std::log2(128 * count * growth))};
}

// The bounds below are computed as logarithms to base 2 in double, which are sums of terms below 1e6. Rounding changes
// them by less than 1e-9, which `slack` covers. A sum of two bounds is bounded by twice the larger one.
constexpr double slack = 1e-6;

/// log2 of cosh(Y x)/(e^{2 pi Y/h} - 1), Y = top: the denominator is at least e^{2 pi Y/h}/4.
double log2_image(double x, double step, double top) {
  return (top * x - 2 * std::numbers::pi * top / step) / std::numbers::ln2 + 2;
}

double log2_even_error(const SymbolBounds& symbol, const Nodes& nodes, double x, double top) {
  const double aliasing = std::log2(symbol.integral) + log2_image(x, nodes.key.step, top);
  const long units = truncation_units + rounding_units * (nodes.last + 3);
  const double sum = std::log2(static_cast<double>(units)) - static_cast<double>(nodes.key.fraction_bits);
  return std::max(aliasing, sum) + 1 + slack;
}

double log2_odd_error(const SymbolBounds& symbol, const Nodes& nodes, const Exact& exact_x, double top) {
  const NodeKey& key = nodes.key;
  const double x = exact_x.approximate();
  const double log2_x = exact_x.log2_magnitude();
  const double aliasing = std::min(std::log2(symbol.integral), std::log2(moment(symbol, top)) + log2_x) +
                          log2_image(x, key.step, top);
  const double log2_count = std::log2(static_cast<double>(nodes.last + 3));
  const double log2_theta = log2_x + std::log2(key.step);
  const double one_minus_ratio = -std::expm1(-symbol.decay * key.step);
  const double truncation =
      std::log2(truncation_units) + std::min(0.0, log2_theta + log2_count - std::log2(one_minus_ratio));
  const double rounding = std::log2(rounding_units) + std::min(log2_count, log2_theta + 2 * log2_count);
  const double sum = std::max(truncation, rounding) + 1 - static_cast<double>(key.fraction_bits);
  return std::max(aliasing, sum) + 1 + slack;
}

/// 2^x rounded up to an integer exponent.
Interval power_of_two(double exponent) {
  Interval result(1L, bound_precision);
  mpfi_mul_2si(result.get(), result.get(), static_cast<long>(std::ceil(exponent)));
  return result;
}

/// Adds to the sum over j = 0 .. last the parts of the residue at 0 that depend on x.
Interval with_origin_terms(const Interval& sum, const SymbolBounds& symbol, const NodeKey& key,
                           const Interval& x) {
  const Interval step(key.step, x.precision());
  if (symbol.pole == 0) return sum;
  if (symbol.pole == 1) return sum + step * x / 4;
  return sum - step * square(x) / 8 + Interval::pi(x.precision()) / 4 * x;
}

}  // namespace

Interval transform(Symbol symbol, const Exact& x, double nats) {
  const SymbolBounds& constants = bounds(symbol);
  const double size = x.approximate();
  const long lines = lines_passed(nats);
  const double top = top_of(lines);
  const NodeKey key = node_key(symbol, size, nats, top);
  const auto set = nodes(key);
  const Angle angle(x.value() * key.step, angle_precision(*set));
  const bool odd = constants.is_odd;
  const Float sum = odd ? sine_sum(*set, angle) : cosine_sum(*set, angle);
  Interval value(sum, sum, bits_of(sum));
  value = with_origin_terms(value, constants, key, Interval(x, bits_of(sum)));
  if (lines > 0) value = value + passed_poles(symbol, x, key.step, lines, nats);
  return value.widened(power_of_two(odd ? log2_odd_error(constants, *set, x, top)
                                        : log2_even_error(constants, *set, size, top)));
}

}  // namespace nipref::ref
