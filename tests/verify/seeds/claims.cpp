#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include <nipref/verify/seeds/claims.hpp>
#include <nipref/verify/seeds/internal/claim_checks.hpp>

using namespace nipref;
using verify::Claim;
using verify::ClaimOutcome;
using verify::ClaimVerdict;

namespace {

const std::map<std::string, ClaimOutcome>& outcomes() {
  static const auto all = [] {
    std::map<std::string, ClaimOutcome> checked;
    for (const Claim& claim : verify::claims()) checked.emplace(claim.id, verify::check(claim));
    return checked;
  }();
  return all;
}

/// The number of a claim whose words begin so.
double number(const std::string& id, const std::string& beginning) {
  for (const verify::ClaimNumber& one : outcomes().at(id).numbers) {
    if (one.what.starts_with(beginning)) return one.value;
  }
  FAIL("no such number: ", beginning);
  return 0;
}

bool near(double value, double truth, double unit) { return std::fabs(value - truth) <= unit; }

}  // namespace

TEST_CASE("every check has its claim, and every claim says where it stands") {
  std::set<std::string_view> checked, said;
  for (auto* const part : {&verify::friction_claims, &verify::shear_claims, &verify::rolling_claims,
                           &verify::half_space_claims}) {
    for (const auto& [id, check] : part()) checked.insert(id);
  }
  const std::vector<Claim> claims = verify::claims();
  for (const Claim& claim : claims) {
    CAPTURE(claim.id);
    CHECK(said.insert(claim.id).second);
    CHECK((claim.seed == "thesis" || claim.seed == "brock2012" || claim.seed == "brock2013"));
    CHECK_FALSE(claim.place.empty());
    CHECK_FALSE(claim.statement.empty());
  }
  CHECK(checked == said);
}

TEST_CASE(
    "claims are decided by their numbers, which other programs found too: what falls, and what stands") {
  const std::map<std::string, ClaimVerdict> expected{
      {"thesis-creep-with-friction", ClaimVerdict::fails},
      {"thesis-one-reversal", ClaimVerdict::holds_in_a_range},
      {"thesis-peak-without-friction", ClaimVerdict::holds_in_a_range},
      {"thesis-friction-on-indentation", ClaimVerdict::holds_in_a_range},
      {"thesis-length-without-friction", ClaimVerdict::holds},
      {"thesis-elastic-extremes", ClaimVerdict::holds},
      {"brock2012-speed", ClaimVerdict::holds},
      {"brock2012-strip", ClaimVerdict::holds_in_a_range},
      {"brock2013-rayleigh-roots", ClaimVerdict::fails},
      {"brock2013-limit-at-45", ClaimVerdict::fails}};
  for (const auto& [id, verdict] : expected) {
    CAPTURE(id);
    CHECK(outcomes().at(id).verdict == verdict);
    CHECK_FALSE(outcomes().at(id).numbers.empty());
  }
  // As other programs found them.
  CHECK(near(number("thesis-creep-with-friction", "chi_0, B = 0.25 in, W = 100"), -2.157e-4, 1e-7));
  CHECK(near(number("thesis-creep-with-friction", "chi_inf, B = 0.25 in, W = 100"), 1.609e-4, 1e-7));
  CHECK(near(number("thesis-one-reversal", "2Y/L"), 0.828, 1e-3));
  CHECK(near(number("thesis-sign-of-creep", "L/B at which the creep vanishes, nu = 0.3333, full"), 0.466923,
             1e-6));
  CHECK(near(number("thesis-largest-resistance", "F0 tau/L of the largest mu_R, B = 0.005 in, W = 50"), 0.408,
             1e-3));
  CHECK(near(number("thesis-largest-resistance", "F0 tau/L of the largest mu_R, B/L to 0"), 0.4505, 5e-5));
  CHECK(near(number("thesis-largest-resistance", "largest mu_R R/L, B/L to 0"), 0.0766108, 5e-8));
  CHECK(near(number("thesis-largest-resistance", "L1/L there"), 0.552197, 5e-6));
  CHECK(near(number("thesis-resistance-of-short-memory", "F0 tau/(2R)"), 8.33e-6, 1e-8));
  CHECK(near(number("brock2012-ellipse-at-rest", "axes of the exact"), 0.39989, 1e-5));
  CHECK(near(number("brock2012-strip", "exp(-pi/2P), nu = 1/3, c = 0.3"), 2.0e-8, 1e-9));
  CHECK(near(number("brock2013-no-root", "Rayleigh root"), 0.42835, 1e-5));
  CHECK(near(number("brock2013-limit-at-45", "smallest speed"), 0.4989960517, 1e-8));
}
