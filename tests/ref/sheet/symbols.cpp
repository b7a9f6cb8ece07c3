#include "support/all_symbols.hpp"
#include "support/intervals.hpp"
#include "support/symbol_sizes.hpp"
#include "support/test.hpp"

// Proves the constants of ref/sheet/internal/symbols.hpp: |G| is enclosed on cells of a mesh in interval arithmetic.
//
// symbol_sizes.hpp has the symbols times e^{r z}, except normal: [2/(1+u) - 2 e^{-z/2} (1 + 2z - e2)/Q]/z with
// u = e^{-3z/2}. The mesh ends at x = 40. Beyond it |1 - Q| <= 170 e^{-80}, and all factors but the leading constants
// are 1 to 30 digits or decrease with x. So |G| e^{r x} stays below its supremum on the mesh, which those constants
// approach, and the integrals gain less than e^{-39}.

using namespace nipref::ref;

namespace {

constexpr mpfr_prec_t precision = SymbolSizes::bits;
constexpr double mesh_end = 40;

/// The lines on which aliasing is bounded.
const Interval low_line(2L, precision);
const Interval high_line = 4 * Interval::pi(precision);

/// sup of |G| e^{r x} on the cell x + iy, y > 0; for `normal` on the line y = 4 pi that of its bound in symbols.hpp.
Interval scaled_modulus(Symbol symbol, const Interval& x, const Interval& y) {
  const SymbolSizes at({x, y});
  if (symbol != Symbol::I1) return at.of(symbol);
  if (mpfi_cmp(y.get(), low_line.get()) > 0) {
    // 2 sinh^2 x - t (sinh 2x + 2x) is e^{x/2} [1 - v (1 + u) + v e^{-2x} - 2 x v (1 - u)]/(1 + u), v = e^{-x/2}.
    const Interval u = exp(-(3 * x) / 2), v = exp(-(x / 2)),
                   rest = v * (u + 1 - exp(-(2 * x)) + 2 * x * (1 - u));
    return 2 * abs(ComplexInterval{1 - rest, Interval(precision)}) / ((u + 1) * abs(at.z * at.q)) +
           4 * v * (1 - u) / ((u + 1) * abs(at.q));
  }
  const auto falling = [&](double k) { return exp(SymbolSizes::number(-k) * at.z); };
  const ComplexInterval one_plus_u = at.one + falling(1.5);
  const ComplexInterval numerator =
      at.q - falling(0.5) * (at.one + SymbolSizes::number(2) * at.z - at.e2) * one_plus_u;
  return 2 * abs(numerator) / abs(at.z * at.q * one_plus_u);
}

/// (1 - e^{-k x})/x on a cell of the real axis. It decreases from its value k at 0.
Interval falling_ratio(double k, double left, double right) {
  const auto at = [k](double x) {
    return x == 0 ? Interval(k, precision)
                  : -expm1(Interval(-k, precision) * Interval(x, precision)) / Interval(x, precision);
  };
  return cell(lowest(at(right)), highest(at(left)));
}

/// sup of min(1, x)^k |G| e^{r x} on a cell of the real axis, k the order of the pole at 0.
Interval scaled_modulus_on_axis(Symbol symbol, double left, double right) {
  const Interval x = cell(left, right);
  const Interval e2 = exp(-(2 * x));
  const Interval q_over_x = falling_ratio(4, left, right) + 4 * e2;
  const Interval pole = right <= 1 ? Interval(1L, precision) : 1 / x;  // min(1, x)/x
  switch (symbol) {
    case Symbol::I3:
      return 4 * pole / q_over_x;
    case Symbol::I4:
      return 2 * pole * falling_ratio(2, left, right) / q_over_x;
    case Symbol::I5:
      return 2 * pole * (e2 + 1) / q_over_x;
    case Symbol::I7:
      return 2 * falling_ratio(2, left, right) / q_over_x;
    case Symbol::I6_alpha_part:
      return 4 * square(pole) / q_over_x;
    case Symbol::I6_eta_part:
      return 2 * square(pole) * (e2 + 1) / q_over_x;
    case Symbol::I1:
      break;
  }
  // normal = (tanh x - tanh(3x/4))/x - 2 tanh x/S: two parts of opposite sign. The first is at most
  // sech^2(3x/4)/4 <= e^{-3x/2} (mean value), the second times e^{3x/2} is 4 e^{-x/2} (1 - e2)/((1 + e2) Q).
  const Interval second = 4 * exp(-(x / 2)) * falling_ratio(2, left, right) / ((e2 + 1) * q_over_x);
  return cell(0, std::max(1.0, highest(second)));
}

void over_mesh(const std::function<void(double left, double right)>& visit) {
  over_cells(
      mesh_end, [](double left) { return left < 4 ? 1.0 / 256 : 1.0 / 32; }, visit);
}

/// Upper bound of sup min(1, x)^k |G(x)| e^{r x}.
double amplitude(Symbol symbol) {
  double largest = 0;
  over_mesh([&](double left, double right) {
    const double bound = highest(scaled_modulus_on_axis(symbol, left, right));
    largest = bound <= largest ? largest : bound;  // a NaN would stay
  });
  return largest;
}

/// Upper bound of int_R |z|^power |G(x + iy)| dx.
double integral_on(Symbol symbol, const Interval& y, int power) {
  double sum = 0;
  over_mesh([&](double left, double right) {
    const Interval x = cell(left, right);
    Interval value = scaled_modulus(symbol, x, y) * exp(-(Interval(bounds(symbol).decay, precision) * x));
    if (power == 1) value = value * abs(ComplexInterval{x, y});
    sum += 2 * highest(value) * (right - left) * (1 + 1e-12);
  });
  return sum + std::exp(-35.0);
}

}  // namespace

TEST_CASE("the constants that bound the symbols hold on an interval mesh") {
  for (const Symbol symbol : all_symbols) {
    const SymbolBounds& constants = bounds(symbol);
    CAPTURE(constants.name);
    CHECK(amplitude(symbol) <= constants.amplitude);
    for (const Interval* line : {&low_line, &high_line}) {
      CHECK(integral_on(symbol, *line, 0) <= constants.integral);
      if (constants.is_odd)
        CHECK(2 * integral_on(symbol, *line, 1) <= constants.moment * mpfi_get_d(line->get()));
    }
  }
}

TEST_CASE("the constants are not loose by more than a factor of two") {
  for (const Symbol symbol : all_symbols) {
    CAPTURE(bounds(symbol).name);
    CHECK(2 * integral_on(symbol, low_line, 0) >= bounds(symbol).integral);
  }
}
