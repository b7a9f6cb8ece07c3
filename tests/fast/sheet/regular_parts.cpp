#include <nipref/fast/sheet/internal/regular_parts.hpp>
#include <nipref/fast/sheet/kernels.hpp>

#include "support/test.hpp"

using namespace nipref;

TEST_CASE("a kernel plus the logarithm is the sum of both, and one smooth function through 0 and 1/2") {
  const auto check = [](const auto& regular, const auto& kernel) {
    const auto at = [&](double alpha) {
      double value[] = {alpha};
      regular(value, value);
      return value[0];
    };
    for (const double alpha : {1e-3, 0.1, 0.49, 0.51, 2.0, 11.0, 30.0}) {
      CAPTURE(alpha);
      CHECK(at(alpha) == at(-alpha));
      CHECK(std::fabs(at(alpha) - (kernel(alpha) + std::log(alpha))) <
            1e-15 * (1 + std::fabs(std::log(alpha))));
    }
    CHECK(std::fabs(at(0) - at(1e-9)) < 1e-15);
    CHECK(std::fabs(at(0.5) - at(std::nextafter(0.5, 0))) < 5e-16);
    CHECK(std::fabs(at(0.01) - at(0) - (at(0.02) - at(0)) / 4) < 1e-7);  // even
    std::vector<double> none;
    regular(none, none);
  };
  check([](auto& alpha, auto& value) { fast::internal::regular_I1(alpha, value); },
        [](double alpha) { return fast::I1(alpha); });
  check([](auto& alpha, auto& value) { fast::internal::regular_I6(alpha, value); },
        [](double alpha) { return fast::I6(alpha, 0); });
}
