#include <nipref/verify/witness/witness.hpp>

#include "support/test.hpp"

using namespace nipref;

TEST_CASE("an outside finite-element program confirms converged contacts") {
  const verify::Witness witness = verify::outside_witness();
  MESSAGE(verify::witness_json(witness).text());
  CHECK(witness.agrees());
  if (witness.installed) CHECK(witness.contacts.size() == 4);
}

TEST_CASE("a witness that differs in anything does not agree, and says so") {
  const verify::Witnessed good{0.25, true, 1e-6, 1e-6, 1e-5};
  CHECK(verify::Witness{true, {good}}.agrees());
  for (const auto member :
       {&verify::Witnessed::load, &verify::Witnessed::normal, &verify::Witnessed::tangential}) {
    verify::Witnessed bad = good;
    bad.*member = 1e-3;
    CHECK_FALSE(verify::Witness{true, {good, bad}}.agrees());
    CHECK(contains(verify::witness_json({true, {bad}}).text(), "\"agrees\": false"));
  }
  CHECK(verify::witness_json({}).is_null());
}
