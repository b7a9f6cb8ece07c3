// Memories of complex rates against those of real ones, and against themselves by other nodes.
#include <nipref/ref/memory/internal/fading.hpp>
#include <nipref/ref/memory/internal/oscillating_memory.hpp>

#include "support/decimal.hpp"
#include "support/intervals.hpp"
#include "support/test.hpp"

using namespace nipref::ref;
using nipref::test::exact;

namespace {

constexpr mpfr_prec_t bits = 200;

ComplexInterval rate_of(const std::string& real, const std::string& imaginary) {
  return {Interval(exact(real), bits), Interval(exact(imaginary), bits)};
}

}  // namespace

TEST_CASE("memory of complex rates: on the real axis it is that of real ones") {
  for (const Symbol kernel : {Symbol::normal, Symbol::I3, Symbol::I4, Symbol::I5}) {
    for (const std::string alpha : {"-200", "-1", "-0.3", "-1e-7", "0.6", "30"}) {
      for (const std::string rate : {"1e-5", "0.478", "0.481", "2.0943951", "1e7"}) {
        CAPTURE(static_cast<int>(kernel));
        CAPTURE(alpha);
        CAPTURE(rate);
        const ComplexInterval found = oscillating_memory(kernel, exact(alpha), rate_of(rate, "0"), 50);
        CHECK(has_zero(found.real - steady_memory(kernel, exact(alpha), exact(rate), 50)));
        CHECK(has_zero(found.imag));
        CHECK(width_of(found.real) <= 5 * std::exp(-50.0));
      }
    }
  }
}

TEST_CASE("memory of complex rates: enclosures of any width, by other nodes, meet") {
  for (const Symbol kernel : {Symbol::normal, Symbol::I3, Symbol::I4, Symbol::I5}) {
    for (const std::string alpha : {"-30", "-0.02", "0", "4"}) {
      for (const auto& [real, imaginary] : {std::pair{"1e-4", "0.4"},
                                            {"0.3", "-3"},
                                            {"1.125", "2.106"},
                                            {"0.02", "400"},
                                            {"40", "-90"},
                                            {"1e6", "1e7"},
                                            {"3", "1e300"}}) {
        CAPTURE(static_cast<int>(kernel));
        CAPTURE(alpha);
        CAPTURE(imaginary);
        if (kernel == Symbol::normal && alpha == std::string("0")) continue;
        const ComplexInterval best = oscillating_memory(kernel, exact(alpha), rate_of(real, imaginary), 60);
        for (const double nats : {1.0, 20.0}) {
          const ComplexInterval rough =
              oscillating_memory(kernel, exact(alpha), rate_of(real, imaginary), nats);
          CHECK(has_zero(rough.real - best.real));
          CHECK(has_zero(rough.imag - best.imag));
        }
        const ComplexInterval other =
            oscillating_memory(kernel, exact(alpha), conj(rate_of(real, imaginary)), 60);
        CHECK(has_zero(other.imag + best.imag));
      }
    }
  }
}

// |z|/|z - z_p| at random points of the strips and poles beside them: below its bound, and not far below everywhere.
TEST_CASE("memory of complex rates: no pole is nearer to a path's strip than its error says") {
  std::mt19937_64 random(16);
  std::uniform_real_distribution<double> unit;
  double largest = 0;
  for (int i = 0; i < 200000; ++i) {
    const bool above = i % 2 == 0;
    const double psi = above ? 0.5 + unit(random) * (M_PI / 2 - 0.5) : unit(random) * 0.5;
    const double edge = unit(random) < 0.5 ? 1 : unit(random);
    const double theta = above ? 1.0 / 16 + 6.0 / 16 * edge : 15.0 / 16 - 6.0 / 16 * edge;
    const double s = 8 * unit(random) * unit(random), t = s + 4 * (unit(random) - 0.5) * unit(random);
    const std::complex<double> z = std::sinh(std::complex<double>(t, theta));
    largest = std::max(largest, std::abs(z) / std::abs(z - std::sinh(std::complex<double>(s, psi))));
  }
  CHECK(largest <= 104);
  CHECK(largest >= 10);
}
