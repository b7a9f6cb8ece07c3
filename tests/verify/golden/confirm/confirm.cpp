#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/golden/confirm/confirm.hpp>
#include <nipref/verify/golden/make.hpp>

#include "support/test.hpp"

using namespace nipref;

TEST_CASE("every quantity of the catalogue has a second method, which confirms its golden values again") {
  for (const verify::Quantity& quantity : verify::catalogue()) {
    CAPTURE(quantity.name);
    REQUIRE(verify::confirmer_of(quantity.name));
    // Un and Vn, which are convolutions over a path, need seconds to begin.
    if (verify::is_slow(quantity) || quantity.name.starts_with("Un") || quantity.name.starts_with("Vn"))
      continue;
    const verify::GoldenFile file = verify::read_golden(verify::golden_path(quantity.name));
    for (std::size_t i = file.rows.size() / 2; i < file.rows.size(); i += 200) {
      verify::GoldenRow row = file.rows[i];
      CHECK(verify::confirm_row(quantity, row) == "");
    }
  }
}
