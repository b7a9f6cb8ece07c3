#include <nipref/fast/nip/internal/panels.hpp>

#include "support/test.hpp"

using namespace nipref::fast;

TEST_CASE("panels leave no gap, each at least a quarter as wide as the one before, one if all is short") {
  for (const double half_length : {1e-8, 0.3, 1.4, 1.6, 20.0, 1e4}) {
    for (const std::complex<double> rate : {0.0, 1e-3, 2.0, 1e5}) {
      for (const double decay : {0.0, 0.8, std::numbers::pi}) {
        CAPTURE(half_length, rate.real());
        const auto cut = panels(half_length, {23, decay, 2, {rate}});
        CHECK(cut.front().left == 0);
        CHECK(cut.front().at_end);
        CHECK(cut.back().about_middle);
        CHECK(cut.back().left + cut.back().right == doctest::Approx(2 * half_length));
        for (std::size_t i = 1; i < cut.size(); ++i) {
          CHECK(cut[i].left == cut[i - 1].right);
          CHECK(!cut[i].at_end);
          CHECK(!cut[i - 1].about_middle);
          if (i > 1) CHECK(cut[i].width() >= cut[i - 1].width() / 4);
        }
        if (half_length < 1.5 && std::abs(rate) * half_length < 4) CHECK(cut.size() == 1);
        CHECK(is_layer(rate, cut) == (cut.size() > 1 && std::abs(rate) * cut.front().right > 1));
      }
    }
  }
}

TEST_CASE("panels have more terms where singularities are nearer, fewer where the ends are forgotten") {
  const auto terms = [](double half_length) { return panels(half_length, {23, 3.14, 2, {}}).front().terms; };
  CHECK(terms(0.1) < terms(1));
  CHECK(terms(1) < terms(1.4));
  const auto cut = panels(1000, {23, 3.14, 2, {}});
  REQUIRE(cut.size() > 3);
  CHECK(cut[cut.size() - 2].terms < cut[1].terms);
  // In the last panel the effect of the ends is below rounding.
  CHECK(3.14 * cut.back().left > 36.7);
}
