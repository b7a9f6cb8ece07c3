#include <nipref/ref/sheet/roots.hpp>

#include "support/decimal.hpp"
#include "support/test.hpp"

using namespace nipref::ref;

namespace {
using Float120 = nipref::test::Decimal<120>;
using Complex120 = nipref::test::ComplexDecimal<120>;

Complex120 root(long n) {
  const SheetRoot r = sheet_root(n, 100);
  return {Float120(r.re.value_text()), Float120(r.im.value_text())};
}
}  // namespace

TEST_CASE("the roots satisfy sinh 2z + 2z = 0 to their bounds") {
  for (const long n : {1L, 2L, 3L, 17L, 1000L, 1000000L}) {
    CAPTURE(n);
    const Complex120 z = root(n);
    const Float120 slope = abs(4 * cosh(z) * cosh(z));
    CHECK(abs(sinh(2 * z) + 2 * z) <= slope * Float120(sheet_root(n, 100).im.error_text()) * 3);
  }
}

TEST_CASE("the n-th root is the n-th: the argument principle counts n roots below its strip") {
  // Winding number of S around the rectangle 0.2 <= Re z <= 6, 0.2 <= Im z <= (n + 1/8) pi, in double.
  for (const int n : {1, 2, 7}) {
    CAPTURE(n);
    const double top = (n + 0.125) * std::numbers::pi;
    const std::complex<double> corners[] = {{0.2, 0.2}, {6, 0.2}, {6, top}, {0.2, top}, {0.2, 0.2}};
    double turned = 0;
    for (int side = 0; side < 4; ++side) {
      constexpr int steps = 20000;
      auto before = std::sinh(2.0 * corners[side]) + 2.0 * corners[side];
      for (int k = 1; k <= steps; ++k) {
        const auto z = corners[side] + (corners[side + 1] - corners[side]) * (k / double(steps));
        const auto now = std::sinh(2.0 * z) + 2.0 * z;
        turned += std::arg(now / before);
        before = now;
      }
    }
    CHECK(std::lround(turned / (2 * std::numbers::pi)) == n);
    CHECK(root(n).imag() < top);
    CHECK(root(n + 1).imag() > top);
  }
}

TEST_CASE("the first roots are those of the notes, to the digits given there") {
  CHECK(sheet_root(1, 20).re.to_double() == doctest::Approx(1.12536430580093).epsilon(1e-14));
  CHECK(sheet_root(1, 20).im.to_double() == doctest::Approx(2.10619611524533).epsilon(1e-14));
  CHECK(sheet_root(3, 20).re.to_double() == doctest::Approx(1.77554367351104).epsilon(1e-14));
  CHECK(sheet_root(3, 20).im.to_double() == doctest::Approx(8.53668242657591).epsilon(1e-14));
}
