#include <nipref/verify/seeds/statements.hpp>
#include <nipref/verify/support/internal/toml_table.hpp>

#include "support/test.hpp"

using namespace nipref;
using verify::FormulaErratum;
using verify::Propagated;
using verify::Settlement;

TEST_CASE("every erratum of a formula is settled: the right one is the truth, the printed one is not") {
  std::set<std::string_view> listed;
  const std::vector<FormulaErratum> errata = verify::formula_errata();
  for (const FormulaErratum& erratum : errata) {
    CAPTURE(erratum.id);
    CHECK(listed.insert(erratum.id).second);
    for (const char* key : {"equation", "printed", "right", "proof"})
      CHECK_FALSE(erratum.entry->text(key).empty());
    const Settlement settlement = verify::settle(erratum);
    CAPTURE(verify::stated_text(settlement.right));
    CAPTURE(verify::stated_text(settlement.truth));
    CHECK(settlement.settled());
    // Not by a hair, or the truth would have to be known better.
    if (settlement.printed) {
      const Propagated apart = verify::fabs(*settlement.printed - settlement.truth);
      CAPTURE(verify::stated_text(*settlement.printed));
      CHECK(apart.value() > 100 * apart.error());
    }
  }
  CHECK(listed.size() == 44);
}

TEST_CASE("an erratum is open if the right formula is not the truth or the printed one is") {
  const Propagated one(1, 0.05), two(2, 0.05);
  CHECK(Settlement{"", two, one, one}.settled());
  CHECK(Settlement{"", {}, one, one}.settled());
  CHECK(Settlement{"", two, {1.09, 0.05}, one}.settled());
  CHECK_FALSE(Settlement{"", two, {1.11, 0.05}, one}.settled());
  CHECK_FALSE(Settlement{"", two, {1.11, 0.05}, {1, 0}}.settled());
  CHECK_FALSE(Settlement{"", one, one, one}.settled());
  CHECK_FALSE(Settlement{"", two, {std::numeric_limits<double>::quiet_NaN(), 0.05}, one}.settled());
}
