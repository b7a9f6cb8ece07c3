#include <nipref/ref/memory/internal/contour_nodes.hpp>
#include <nipref/ref/memory/internal/fading.hpp>
#include <nipref/ref/number/internal/complex_interval.hpp>

#include "support/decimal.hpp"
#include "support/intervals.hpp"
#include "support/test.hpp"

// Proves what contour_memory() says of its paths on a mesh of cells in interval arithmetic, and compares its values
// with the residue series, which shares nothing with it but the symbols.

using namespace nipref::ref;
using nipref::test::exact;

namespace {

constexpr mpfr_prec_t mesh_precision = 64;
constexpr Symbol fading_kernels[] = {Symbol::normal, Symbol::I3, Symbol::I4, Symbol::I5};

Interval size_of(const ComplexInterval& z) { return sqrt(square(z.real) + square(z.imag)); }
ComplexInterval multiple(long factor, const ComplexInterval& z) { return {factor * z.real, factor * z.imag}; }
ComplexInterval plus_one(const ComplexInterval& z) { return {z.real + 1, z.imag}; }

/// The hyperbola Im t = angle - 1/2 of the first path, 1/2 - angle of the second, at t = Re t + ...
struct Hyperbola {
  Hyperbola(bool up, const Interval& angle, const Interval& t)
      : z{sinh(t) * cos(angle), cosh(t) * sin(angle)}, slope{cosh(t) * cos(angle), sinh(t) * sin(angle)} {
    if (up) return;
    z.imag = Interval(1.5, mesh_precision) - z.imag;
    slope.imag = -slope.imag;
  }
  ComplexInterval z, slope;
};

struct Exponentials {
  explicit Exponentials(const ComplexInterval& z)
      : square{exp(-2 * z.real) * cos(2 * z.imag), -(exp(-2 * z.real) * sin(2 * z.imag))},
        d{plus_one(multiple(4, z * square) - square * square)} {}
  ComplexInterval square;  ///< e^{-2z}
  ComplexInterval d;       ///< 2 e^{-2z} S
};

double decay_of(Symbol kernel) { return kernel == Symbol::normal ? 0 : bounds(kernel).decay; }

/// |G| e^{r Re z}, I1's whole symbol and r = 0 for `normal`: with E = e^{-z}, D = 2 E^2 S it is (1 - E^2)^2/(z D),
/// and otherwise 4/D, 2 (1 - E^2)/(z D), 2 (1 + E^2)/D.
Interval symbol_size(Symbol kernel, const ComplexInterval& z) {
  const Exponentials of(z);
  const Interval over = 1 / size_of(of.d);
  const Interval difference = size_of(plus_one(multiple(-1, of.square)));
  switch (kernel) {
    case Symbol::I3:
      return 4 * over;
    case Symbol::I4:
      return 2 * difference * over / size_of(z);
    case Symbol::I5:
      return 2 * size_of(plus_one(of.square)) * over;
    default:
      return square(difference) * over / size_of(z);
  }
}

/// |G z' v| e^{r Re z}
Interval integrand_size(Symbol kernel, const Hyperbola& at) {
  const Interval divisor = lowest(at.z.imag) >= 0 ? size_of(at.z) : at.z.real;
  return symbol_size(kernel, at.z) * size_of(at.slope) / divisor;
}

/// [0, 6] in cells that are narrow near 0, and wide beyond 3, where D and the brackets of G are nearly 1.
template <class Visit>
void over_mesh(Visit visit) {
  for (double left = 0; left < 6;) {
    const double width = left < 0.5 ? 1.0 / 256 : left < 3 ? 1.0 / 64 : 1.0 / 32;
    visit(cell(left, left + width), width);
    left += width;
  }
}

/// A bound of the integral of |G z' v E| over both halves of a hyperbola, |t| <= 6.
double edge_integral(Symbol kernel, bool up, double angle) {
  double sum = 0;
  over_mesh([&](const Interval& t, double width) {
    const Hyperbola at(up, Interval(angle, mesh_precision), t);
    const double growth = up ? 0 : std::max(0.0, highest(at.z.imag));
    const Interval wave =
        Interval(growth, mesh_precision) - Interval(decay_of(kernel), mesh_precision) * at.z.real;
    sum += 2 * width * highest(integrand_size(kernel, at) * exp(wave));
  });
  return sum * (1 + 1e-12);
}

/// A bound of |G z' v| e^{k t + r Re z} on the path.
double path_maximum(Symbol kernel, bool up) {
  double largest = 0;
  over_mesh([&](const Interval& t, double) {
    const Interval scaled = integrand_size(kernel, Hyperbola(up, Interval(0.5, mesh_precision), t));
    const double bound = highest(kernel == Symbol::normal ? scaled * exp(t) : scaled);
    largest = bound <= largest ? largest : bound;  // a NaN would stay
  });
  return largest;
}

Interval half_pi() { return Interval::pi(mesh_precision) / 2; }

}  // namespace

// Beyond t = 6, where Re z > 110, D and the factors of G in brackets are 1 to 90 digits: there |G z' v| is, but for
// that, 4, 2 or 2/|z| times e^{-r Re z} |z'| v, or |z' v|/|z|, and |z'| v <= 1/cos(15/16) < 1.7. The integrals gain
// less than 2 * 1.7 int |z|^{-1} dt < 0.02, and on the path |z'| v < 1.15, e^t/|z| < 2.1.
TEST_CASE("memory by contour: the constants of its error hold on an interval mesh, and are not loose") {
  for (const Symbol kernel : fading_kernels) {
    CAPTURE(bounds(kernel).name);
    for (const bool up : {true, false}) {
      CAPTURE(up);
      const double edges = edge_integral(kernel, up, 1.0 / 16) + edge_integral(kernel, up, 15.0 / 16);
      CHECK(edges + 0.04 <= 30);
      CHECK(edges >= 5);
      CHECK(path_maximum(kernel, up) <= 5);
    }
  }
}

// For |Im z| <= pi/2 S has no root but 0: with 2z = u + iv, |v| <= pi, sinh 2z = -2z means cosh u sin v = -v, whose
// sides have opposite signs unless v = 0, and then sinh u = -u. Beyond t = 6 |1 - D| < (4 |z| + 1) e^{-2 Re z} is
// small.
TEST_CASE("memory by contour: neither path nor what its strip sweeps meets a root of S") {
  constexpr double turn = 1.0 / 64;
  int cells = 0;
  for (const bool up : {true, false}) {
    for (double angle = 0; angle < 15.0 / 16; angle += turn) {
      over_mesh([&](const Interval& t, double) {
        const Hyperbola at(up, cell(angle, angle + turn), t);
        const Interval height = up ? at.z.imag : -at.z.imag;
        if (highest(height) < lowest(half_pi())) return;
        const Exponentials of(at.z);
        REQUIRE_FALSE((has_zero(of.d.real) && has_zero(of.d.imag)));
        ++cells;
      });
    }
  }
  CHECK(cells > 1000);
}

namespace {

/// A complex number known to so many units 2^-p of itself.
ComplexInterval nearly(const Complex& number, long units, mpfr_prec_t p) {
  ComplexInterval result{Interval(p + 1), Interval(p + 1)};
  mpfi_set_fr(result.real.get(), mpc_realref(number.get()));
  mpfi_set_fr(result.imag.get(), mpc_imagref(number.get()));
  Interval radius = units * size_of(result);
  mpfi_div_2ui(radius.get(), radius.get(), static_cast<unsigned long>(p));
  return {result.real.widened(radius), result.imag.widened(radius)};
}

Interval nearly(const Exact& number, mpfr_prec_t p) {
  Interval unit(number.magnitude(), p + 1);
  mpfi_div_2ui(unit.get(), unit.get(), static_cast<unsigned long>(p));
  return Interval(number, p + 1).widened(unit);
}

/// How far the computed term may be off, in units of 2^-p (1 + |alpha z|) |F|, by the same steps as in
/// contour_memory(). Rounding outwards with a bit more is as far off as rounding to nearest.
double rounding_units(const ContourNode& node, const Exact& alpha, const Exact& rate, mpfr_prec_t p) {
  const ComplexInterval z = nearly(node.z, 2, p), weight = nearly(node.weight, 2, p);
  const Interval a = nearly(alpha, p), r = nearly(rate, p), size = exp(-(a * z.imag)), angle = a * z.real;
  const Interval cosine = cos(angle), sine = sin(angle);
  const ComplexInterval wave{weight.real * cosine - weight.imag * sine,
                             weight.real * sine + weight.imag * cosine};
  const Interval d = r + z.imag, square_of_divisor = square(d) + square(z.real);
  const Interval real = (wave.real * d - wave.imag * z.real) * size / square_of_divisor;
  const Interval imag = (wave.real * z.real + wave.imag * d) * size / square_of_divisor;
  Float width = zero_of_bits(64), other = zero_of_bits(64);
  mpfi_diam_abs(raw(width), real.get());
  mpfi_diam_abs(raw(other), imag.get());
  mpfr_max(raw(width), raw(width), raw(other), MPFR_RNDU);
  const Interval unit = (Interval(alpha.magnitude(), 64) * size_of(z) + 1) * size_of({real, imag});
  const Interval units = Interval(width, width, 64) / (2 * unit);
  return std::ldexp(highest(units), static_cast<int>(p));
}

}  // namespace

TEST_CASE("memory by contour: a term is at most 55, and 64 units cover its rounding") {
  // (1 + |alpha z|) times the wave. On the first path, w = |alpha z|; it falls from w = 2 on.
  const Interval s = sin(Interval(0.5, mesh_precision));
  for (double w = 0; w < 4; w += 1.0 / 64)
    CHECK(highest((cell(w, w + 1.0 / 64) + 1) * exp(-(s * cell(w, w + 1.0 / 64)))) < 2);
  // On the second |alpha| < 1. While Im z >= 0:
  const Interval half(0.5, mesh_precision);
  over_mesh([&](const Interval& t, double) {
    const Hyperbola at(false, half, t);
    if (highest(at.z.imag) < 0) return;
    CHECK(highest(size_of(at.z)) < 2.8);
    CHECK(highest(at.z.imag) < 1.03);
  });
  // Afterwards, with m = -Im z, |z|^2 <= (m + 3/2)^2 cot^2(1/2) + m^2, whose coefficients are below those of (3.2 + 2.1
  // m)^2; and |z| <= Re z/cos(1/2) for the denominator.
  const Interval cotangent = square(cos(half) / sin(half));
  CHECK(highest(cotangent + 1) < 2.1 * 2.1);
  CHECK(highest(3 * cotangent) < 2 * 2.1 * 3.2);
  CHECK(highest(9 * cotangent / 4) < 3.2 * 3.2);
  CHECK(highest(1 / cos(half)) < 1.2);
  // |F| times the rest is at most 5, see above.
  const double wave = contour_term / 5;
  CHECK(highest(exp(Interval(1.03, mesh_precision)) * Interval(3.8, mesh_precision)) < wave);
  CHECK(highest(Interval(2.1, mesh_precision) * exp(Interval(-1L, mesh_precision)) +
                Interval(4.2, mesh_precision)) < wave);
  // The parts of the error of contour_memory() and of oscillating_memory(), over e^{-nats}.
  CHECK(15 * std::exp(-5.0) + 6 * std::exp(-4.0) + 0.25 < 1);
  CHECK(104 * 30 * std::exp(-10.0) + 104 * 6 / 0.7 * std::exp(-9.0) < 0.5);

  double most = 0;
  constexpr mpfr_prec_t p = 128;
  for (const Symbol kernel : fading_kernels) {
    for (const std::string alpha : {"1e-9", "0.3", "0.999"}) {
      for (const std::string rate : {"0", "1e-9", "0.04", "1.25", "17", "1e7"}) {
        for (const bool ahead : {true, false}) {
          for (long block = 0; block < 4; ++block) {
            const auto nodes =
                contour_nodes({kernel, ahead ? Contour::up : Contour::down, 1.0 / 32, p, block});
            for (const ContourNode& node : *nodes)
              most = std::max(most, rounding_units(node, exact((ahead ? "" : "-") + alpha), exact(rate), p));
          }
        }
      }
    }
  }
  CHECK(most <= contour_rounding);
  CHECK(most >= 8);
}

TEST_CASE("memory of complex rates: the constants 104, 0.78 and 6 of its error hold in interval arithmetic") {
  const auto number = [](double x) { return Interval(x, mesh_precision); };
  // theta <= 7/16 with psi <= pi/2, and theta <= 15/16 with psi <= 1/2.
  CHECK(lowest(cos((number(7.0 / 16) + half_pi()) / 2)) >= 0.31);
  CHECK(lowest(cos((number(15.0 / 16) + number(0.5)) / 2)) >= 0.31);
  CHECK(lowest(sin(number(1.0 / 32))) > 1 / 32.01);
  CHECK(highest(1 / (number(0.31) * sin(number(1.0 / 32)))) <= 104);
  CHECK(highest(1 / sin(number(1.0 / 16))) <= 104);
  int cells = 0;
  for (const double angle : {0.25, 0.75}) {
    constexpr double width = 1.0 / 256;
    for (double left = std::asinh(2 / std::cos(angle)) - 1e-12; left < 6; left += width) {
      const Hyperbola at(true, number(angle), cell(left, left + width));
      CHECK(lowest(size_of(Exponentials(at.z).d)) > 0.78);
      for (const Symbol kernel : fading_kernels) {
        const Interval size = integrand_size(kernel, at);
        CHECK(highest(kernel == Symbol::normal ? size * exp(cell(left, left + width)) : size) <= 6);
      }
      ++cells;
    }
  }
  CHECK(cells > 300);
}

namespace {

/// Whether two enclosures meet, each not wider than 2 e^{-nats} by much.
void check_same(const Interval& x, const Interval& y, double nats) {
  CHECK(width_of(x - y) <= 5 * std::exp(-nats));
  CHECK(has_zero(x - y));
}

}  // namespace

TEST_CASE("memory by contour is what the residue series gives where both can") {
  for (const Symbol kernel : fading_kernels) {
    for (const std::string rate : {"0", "1e-9", "0.04", "1.25", "2.0943951", "3.1415926", "17", "1e7"}) {
      CAPTURE(bounds(kernel).name);
      CAPTURE(rate);
      for (const double nats : {50.0, 90.0}) {
        check_same(contour_memory(kernel, exact("1"), exact(rate), nats),
                   steady_memory(kernel, exact("1"), exact(rate), nats), nats);
        check_same(contour_memory(kernel, exact("-1"), exact(rate), nats),
                   steady_memory(kernel, exact("-1"), exact(rate), nats), nats);
      }
    }
  }
}

TEST_CASE("memory by contour: enclosures of any width, by other nodes, meet") {
  for (const Symbol kernel : fading_kernels) {
    for (const std::string alpha : {"-0.99", "-0.3", "-1e-7", "1e-30", "1e-3", "0.6"}) {
      for (const std::string rate : {"1e-5", "0.7", "1e5"}) {
        CAPTURE(bounds(kernel).name);
        CAPTURE(alpha);
        CAPTURE(rate);
        const Interval best = contour_memory(kernel, exact(alpha), exact(rate), 75);
        for (const double nats : {1.0, 5.0, 20.0, 40.0}) {
          const Interval rough = contour_memory(kernel, exact(alpha), exact(rate), nats);
          CHECK(has_zero(rough - best));
        }
      }
    }
  }
}

// What is left beside pi/(4 rate) counts from the point, at rate 0 from 0: pi/4 alpha lies between.
TEST_CASE("memory by contour: at rate 0 it is the limit, of odd kernels beside pi/(4 rate)") {
  for (const Symbol kernel : fading_kernels) {
    for (const std::string alpha : {"-7", "-1", "-0.4", "1e-3", "0.8", "3"}) {
      CAPTURE(bounds(kernel).name);
      CAPTURE(alpha);
      const Exact rate = exact("1e-40");
      const Interval large = steady_memory(kernel, exact(alpha), rate, 60);
      const Interval infinite = Interval::pi(400) / (4 * Interval(rate, 400));
      const Interval quarter = Interval::pi(400) / 4;
      const bool is_odd = bounds(kernel).parity == Parity::odd;
      check_same(steady_memory(kernel, exact(alpha), exact("0"), 60),
                 is_odd ? large - infinite - quarter * Interval(exact(alpha), 400) : large, 60);
    }
  }
}
