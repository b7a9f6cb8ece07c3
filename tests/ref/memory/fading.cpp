// The memory of a load from infinity: the constants of the proof of its paths, on a mesh in interval arithmetic; its
// values against the residue series, which shares only the symbols with the paths, and against other nodes.

#include <nipref/ref/memory/internal/fading.hpp>

#include "support/decimal.hpp"
#include "support/intervals.hpp"
#include "support/symbol_sizes.hpp"
#include "support/test.hpp"

using namespace nipref::ref;
using nipref::test::exact;

namespace {

constexpr mpfr_prec_t mesh_precision = SymbolSizes::bits;
constexpr Symbol fading_kernels[] = {Symbol::I1, Symbol::I3, Symbol::I4, Symbol::I5};

Interval number(double x) { return Interval(x, mesh_precision); }

/// z = sinh(t + i angle)
struct Hyperbola {
  Hyperbola(const Interval& angle, const Interval& t)
      : z{sinh(t) * cos(angle), cosh(t) * sin(angle)}, slope{cosh(t) * cos(angle), sinh(t) * sin(angle)} {}
  ComplexInterval z, slope;
};

double decay_of(Symbol kernel) { return kernel == Symbol::I1 ? 0 : bounds(kernel).decay; }

/// |G| e^{r Re z}; for `normal` with r = 0 and the whole symbol of I1, (1 - e2)^2/(z Q).
Interval symbol_size(Symbol kernel, const ComplexInterval& z) {
  const SymbolSizes at(z);
  return kernel == Symbol::I1 ? square(abs(at.one - at.e2)) / abs(z * at.q) : at.of(kernel);
}

/// |G z'/z| e^{r Re z}
Interval integrand_size(Symbol kernel, const Hyperbola& at) {
  return symbol_size(kernel, at.z) * abs(at.slope) / abs(at.z);
}

/// The interval [0, 6] in cells, narrow near 0 and wide beyond 3, where Q and the brackets of G are nearly 1.
void over_mesh(const std::function<void(const Interval& t, double width)>& visit) {
  over_cells(
      6, [](double left) { return left < 0.5 ? 1.0 / 256
                                  : left < 3 ? 1.0 / 64
                                             : 1.0 / 32; },
      [&](double left, double right) { visit(cell(left, right), right - left); });
}

/// A bound of the integral of |G z'/z| over both halves of a hyperbola, |t| <= 6.
double edge_integral(Symbol kernel, double angle) {
  double sum = 0;
  over_mesh([&](const Interval& t, double width) {
    const Hyperbola at(number(angle), t);
    sum += 2 * width * highest(integrand_size(kernel, at) * exp(-(number(decay_of(kernel)) * at.z.re)));
  });
  return sum * (1 + 1e-12);
}

Interval half_pi() { return Interval::pi(mesh_precision) / 2; }

/// Checks that two enclosures meet and that neither is much wider than 2 e^{-nats}.
void check_same(const Interval& x, const Interval& y, double nats) {
  CHECK(width_of(x - y) <= 5 * std::exp(-nats));
  CHECK(has_zero(x - y));
}

constexpr mpfr_prec_t fading_bits = 200;

ComplexInterval rate_of(const std::string& real, const std::string& imaginary) {
  return {Interval(exact(real), fading_bits), Interval(exact(imaginary), fading_bits)};
}

/// A real rate as an interval with an imaginary part, for which the paths are taken at all places.
ComplexInterval nearly_real(const std::string& rate) {
  const ComplexInterval real = rate_interval(exact(rate), 100);
  return {real.re, real.im.widened(exp(Interval(-1000L, 64)))};
}

}  // namespace

// Beyond t = 6, where Re z > 110, Q and the bracketed factors of G are 1 to 90 digits. Up to these digits |G z'/z| is
// 4, 2 or 2/|z| times e^{-r Re z} |z'/z|, or |z'|/|z|^2, and |z'/z| <= 1/cos(15/16) < 1.7. The integrals gain
// less than 2 * 1.7 int |z|^{-1} dt < 0.02.
TEST_CASE("memory by contour: the constants of its error hold on an interval mesh, and are not loose") {
  for (const Symbol kernel : fading_kernels) {
    CAPTURE(bounds(kernel).name);
    const double edges = edge_integral(kernel, 1.0 / 16) + edge_integral(kernel, 15.0 / 16);
    CHECK(edges + 0.04 <= 30);
    CHECK(edges >= 5);
  }
  // theta <= 7/16 with psi <= pi/2, theta <= 15/16 with psi <= 1/2, and theta <= 15/16 with psi from 1 to pi/2.
  CHECK(lowest(cos((number(15.0 / 16) + half_pi()) / 2)) >= 0.31);
  CHECK(lowest(sin(number(1.0 / 32))) > 1 / 32.01);
  CHECK(highest(1 / (number(0.31) * sin(number(1.0 / 32)))) <= 104);
  CHECK(highest(1 / sin(number(1.0 / 16))) <= 104);
  CHECK(104 * 30 * std::exp(-10.0) + 104 * 6 / 0.7 * std::exp(-9.0) < 0.5);
  CHECK(lowest(cos(number(0.75))) >= 0.7);
  int cells = 0;
  for (const double angle : {0.25, 0.5, 0.75}) {
    constexpr double width = 1.0 / 256;
    for (double left = std::asinh(2 / std::cos(angle)) - 1e-12; left < 6; left += width) {
      const Hyperbola at(number(angle), cell(left, left + width));
      CHECK(lowest(abs(SymbolSizes(at.z).q)) > 0.78);
      for (const Symbol kernel : fading_kernels) {
        const Interval size = integrand_size(kernel, at);
        CHECK(highest(kernel == Symbol::I1 ? size * exp(cell(left, left + width)) : size) <= 6);
      }
      ++cells;
    }
  }
  CHECK(cells > 300);
}

// For |Im z| <= pi/2 S has no root but 0: with 2z = u + iv, |v| <= pi, sinh 2z = -2z means cosh u sin v = -v, whose
// sides have opposite signs unless v = 0, and then sinh u = -u. Beyond t = 6 |1 - Q| < (4 |z| + 1) e^{-2 Re z} is
// small.
TEST_CASE("memory by contour: what its strip sweeps meets no root of S") {
  constexpr double turn = 1.0 / 64;
  int cells = 0;
  for (double angle = 0; angle < 15.0 / 16; angle += turn) {
    over_mesh([&](const Interval& t, double) {
      const Hyperbola at(cell(angle, angle + turn), t);
      if (highest(at.z.im) < lowest(half_pi())) return;
      const SymbolSizes of(at.z);
      REQUIRE_FALSE((has_zero(of.q.re) && has_zero(of.q.im)));
      ++cells;
    });
  }
  CHECK(cells > 1000);
}

// |z|/|z - z_p| at random points of the strips and poles beside them: its maximum is below the bound and not far below.
TEST_CASE("memory by contour: no pole is nearer to a path's strip than its error says") {
  std::mt19937_64 random(16);
  std::uniform_real_distribution<double> unit;
  double largest = 0;
  for (int i = 0; i < 200000; ++i) {
    const double psi = unit(random) * std::numbers::pi / 2;
    const MemoryStrip strip = strip_beside(psi);
    const double edge = unit(random) < 0.5 ? 1 : unit(random);
    const double theta = strip.angle + (unit(random) < 0.5 ? -1 : 1) * strip.half_width * edge;
    const double s = 8 * unit(random) * unit(random), t = s + 4 * (unit(random) - 0.5) * unit(random);
    const std::complex<double> z = std::sinh(std::complex<double>(t, theta));
    largest = std::max(largest, std::abs(z) / std::abs(z - std::sinh(std::complex<double>(s, psi))));
    CHECK(std::fabs(theta - psi) >= 1.0 / 16 - 1e-12);
  }
  CHECK(largest <= 104);
  CHECK(largest >= 10);
}

TEST_CASE("memory by contour is what the residue series gives where both can") {
  for (const Symbol kernel : fading_kernels) {
    for (const std::string alpha : {"-200", "-1", "-0.3", "-1e-7", "0.6", "1", "30"}) {
      for (const std::string rate :
           {"1e-9", "0.04", "0.478", "0.481", "0.8", "1.25", "2.0943951", "17", "1e7"}) {
        CAPTURE(bounds(kernel).name, alpha, rate);
        const double nats = 60;
        const ComplexInterval found = steady_memory(kernel, exact(alpha), nearly_real(rate), nats);
        check_same(found.re, steady_memory(kernel, exact(alpha), exact(rate), nats), nats);
        CHECK(has_zero(found.im));
      }
    }
  }
}

TEST_CASE("memory by contour: enclosures of any width, by other nodes, meet") {
  for (const Symbol kernel : fading_kernels) {
    for (const std::string alpha : {"-30", "-0.99", "-0.02", "-1e-7", "0", "1e-30", "0.6", "4"}) {
      for (const auto& [real, imaginary] : {std::pair{"1e-5", "0"},
                                            {"0.7", "0"},
                                            {"1e5", "0"},
                                            {"1e-4", "0.4"},
                                            {"0.3", "-3"},
                                            {"1.125", "2.106"},
                                            {"0.02", "400"},
                                            {"40", "-90"},
                                            {"1e6", "1e7"},
                                            {"3", "1e300"}}) {
        CAPTURE(bounds(kernel).name, alpha, real, imaginary);
        if (kernel == Symbol::I1 && alpha == std::string("0")) continue;
        const ComplexInterval best = steady_memory(kernel, exact(alpha), rate_of(real, imaginary), 60);
        for (const double nats : {1.0, 20.0}) {
          const ComplexInterval rough = steady_memory(kernel, exact(alpha), rate_of(real, imaginary), nats);
          CHECK(has_zero(rough.re - best.re));
          CHECK(has_zero(rough.im - best.im));
        }
        const ComplexInterval other = steady_memory(kernel, exact(alpha), conj(rate_of(real, imaginary)), 60);
        CHECK(has_zero(other.im + best.im));
      }
    }
  }
}

// At small rates the rest beside pi/(4 rate) is counted from the point, at rate 0 from 0: they differ by pi/4 alpha.
TEST_CASE("memory by contour: at rate 0 it is the limit, of odd kernels beside pi/(4 rate)") {
  for (const Symbol kernel : fading_kernels) {
    for (const std::string alpha : {"-7", "-1", "-0.4", "1e-3", "0.8", "3"}) {
      CAPTURE(bounds(kernel).name, alpha);
      const Exact rate = exact("1e-40");
      const Interval large = steady_memory(kernel, exact(alpha), rate, 60);
      const Interval pole = Interval::pi(400) / (4 * Interval(rate, 400));
      const Interval quarter = Interval::pi(400) / 4;
      const bool is_odd = bounds(kernel).is_odd;
      check_same(steady_memory(kernel, exact(alpha), exact("0"), 60),
                 is_odd ? large - pole - quarter * Interval(exact(alpha), 400) : large, 60);
    }
  }
}
