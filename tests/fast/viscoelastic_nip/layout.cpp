#include <doctest/doctest.h>

#include <cmath>

#include <nipref/fast/viscoelastic_nip/internal/layout.hpp>

using namespace nipref::fast;

TEST_CASE("every place of a contact is in a panel, also where rounding has put it beyond its half") {
  for (int i = 1; i <= 300; ++i) {
    const double half_length = 0.01 * std::exp(0.03 * i);
    const ViscoelasticLayout layout(half_length, {1, 1, 3, 3, 1, 1}, 4);
    for (const Half half : {Half::leading, Half::trailing}) {
      const auto at = [&](double e) -> const ViscoelasticPanel& {
        return layout.panels().at(layout.panel_of({half, e}));
      };
      CHECK(at(0).at_end());
      CHECK(at(std::nextafter(half_length, 2 * half_length)).left >= half_length / 2);
      for (const ViscoelasticPanel& panel : layout.panels()) {
        if (panel.half != half) continue;
        const ViscoelasticPanel& found = at(panel.left + panel.width / 3);
        CHECK(found.half == half);
        CHECK(found.left == panel.left);
      }
    }
  }
}
