#include <nipref/fast/nip/internal/layer.hpp>
#include <nipref/fast/sheet/kernels.hpp>

#include "support/test.hpp"

using namespace nipref::fast;
using Complex = std::complex<double>;

TEST_CASE("Dawson's integral has the values of tables, and satisfies D' = 1 - 2 z D for complex arguments") {
  const auto complex_dawson = [](Complex z) {
    return -std::sqrt(std::numbers::pi) / 2 / (z * z) * LayerPressure(z * z)(1);
  };
  const auto dawson = [&](double x) { return complex_dawson(x).real(); };
  CHECK(dawson(0.1) == approx(0.09933599239785286114, 4e-16));
  CHECK(dawson(0.5) == approx(0.42443638350202229593, 4e-16));
  CHECK(dawson(1) == approx(0.53807950691276841914, 4e-16));
  CHECK(dawson(3) == approx(0.17827103061055829, 1e-15));
  CHECK(dawson(10) == approx(0.05025384718759852803, 1e-15));
  for (const double size : {0.3, 2.0, 6.3, 6.4, 30.0}) {
    for (const double angle : {-0.78, -0.4, 0.0, 0.3, 0.7}) {
      CAPTURE(size, angle);
      const auto at = complex_dawson;
      const Complex z = std::polar(size, angle);
      const double step = 1e-3 / size;
      // A central difference of sixth order.
      const Complex slope =
          (45.0 * (at(z + step) - at(z - step)) - 9.0 * (at(z + 2 * step) - at(z - 2 * step)) +
           (at(z + 3 * step) - at(z - 3 * step))) /
          (60 * step);
      CHECK(std::abs(slope - (1.0 - 2.0 * z * at(z))) < 1e-9 * (1 + size));
    }
  }
}
