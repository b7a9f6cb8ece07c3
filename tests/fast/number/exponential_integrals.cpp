#include <nipref/fast/number/internal/exponential_integrals.hpp>

#include "support/test.hpp"

namespace nipref::fast::internal {

using Complex = std::complex<double>;

TEST_CASE("Ei satisfies its equation for complex arguments, and has the values of tables on the real axis") {
  CHECK(scaled_Ei(1.0).real() == approx(std::exp(-1) * 1.8951178163559368, 1e-14));
  CHECK(scaled_Ei(10.0).real() == approx(std::exp(-10) * 2492.2289762418777, 1e-14));
  for (const double size : {0.4, 2.4, 2.6, 12.0, 49.0, 51.0, 300.0}) {
    for (const double angle : {-1.5, -0.5, 0.1, 0.3, 1.2}) {
      CAPTURE(size, angle);
      // f = e^-z Ei z obeys f' = 1/z - f.
      const Complex z = std::polar(size, angle);
      const double step = 0.003;
      const Complex slope = (45.0 * (scaled_Ei(z + step) - scaled_Ei(z - step)) -
                             9.0 * (scaled_Ei(z + 2 * step) - scaled_Ei(z - 2 * step)) +
                             (scaled_Ei(z + 3 * step) - scaled_Ei(z - 3 * step))) /
                            (60 * step);
      CHECK(std::abs(slope - (1.0 / z - scaled_Ei(z))) < 1e-9);
    }
  }
}

}  // namespace nipref::fast::internal
