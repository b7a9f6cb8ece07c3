#include <charconv>

#include <nipref/verify/seeds/internal/solved.hpp>
#include <nipref/verify/seeds/statements.hpp>
#include <nipref/verify/support/internal/toml_table.hpp>

#include "support/table_rows.hpp"

using namespace nipref;
using verify::CheckedClaim;
using verify::Json;
using verify::LimitRow;
using verify::LimitSample;
using verify::Propagated;
using verify::Settlement;
using verify::Statement;

namespace {

const std::map<std::string, CheckedClaim>& outcomes() {
  static const auto all = [] {
    std::map<std::string, CheckedClaim> checked;
    for (const Statement& claim : verify::claims()) checked.emplace(claim.id, verify::check(claim));
    return checked;
  }();
  return all;
}

/// The number of a claim whose description begins with these words.
double number(const std::string& id, const std::string& beginning) {
  for (const verify::ClaimNumber& one : outcomes().at(id).numbers) {
    if (one.what.starts_with(beginning)) return one.number.value();
  }
  FAIL("no such number: ", beginning);
  return 0;
}

/// The unit of the last digit of a double's shortest decimal.
double unit_of(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific);
  const std::string decimal(text.data(), end.ptr);
  const std::size_t power = decimal.find('e'), decimals = decimal.starts_with('-') ? 3 : 2;
  return std::pow(
      10.0, std::stod(decimal.substr(power + 1)) - static_cast<double>(std::max(power, decimals) - decimals));
}

/// Checks that `error` is a number in JSON, and that the value has no digit far below it.
void check_stated(const Json& value, const Json& error) {
  CAPTURE(value.line(), error.line());
  REQUIRE_FALSE(error.is_null());
  const double number = std::stod(value.line()), size = std::stod(error.line());
  CHECK(std::isfinite(number));
  CHECK(size >= 0);
  // The unit of the value's last digit is that of the error's first. Rounding adds at most half of it to the error.
  CHECK((number == 0 || unit_of(number) > size / 20));
}

/// Two samples of a limit of 1: the first is `before` above it, the second `last` below it.
LimitRow row_with(double order, double before, double last, double error = 0) {
  return {"limit.test",
          "",
          "",
          "size",
          order,
          {LimitSample{0.2, {1 + before, error}, Propagated::exact(1)},
           LimitSample{0.1, {1 - last, error}, Propagated::exact(1)}}};
}

}  // namespace

TEST_CASE("every claim says where it stands") {
  std::set<std::string_view> ids;
  const std::vector<Statement> claims = verify::claims();
  for (const Statement& claim : claims) {
    CAPTURE(claim.id);
    CHECK(ids.insert(claim.id).second);
    const std::string& seed = claim.entry->text("seed");
    CHECK((seed == "thesis" || seed == "brock2012" || seed == "brock2013"));
    CHECK_FALSE(claim.entry->text("place").empty());
    CHECK_FALSE(claim.entry->text("statement").empty());
  }
  CHECK(ids.size() == 39);
}

TEST_CASE("claims are decided by their numbers, which other programs found too and which have errors") {
  SUBCASE(
      "claims are decided by their numbers, which other programs found too: what falls, and what stands") {
    const auto rows = table_rows("verify/seeds/claims.txt");
    CHECK(rows.size() > 40);
    for (const auto& row : rows) {
      CAPTURE(row[0], row[1]);
      if (row.size() == 2) {
        CHECK(verify::name_of(outcomes().at(row[0]).verdict) == row[1]);
        CHECK_FALSE(outcomes().at(row[0]).numbers.empty());
      } else {
        CHECK(std::fabs(number(row[0], row[1]) - std::stod(row.at(2))) <= std::stod(row.at(3)));
      }
    }
  }
  SUBCASE("every number has an error, and no more digits than it bears out") {
    const auto checked = verify::mapped(std::views::values(outcomes()), std::identity());
    for (const Json& claim : verify::claims_json(checked).items()) {
      CAPTURE(claim.at("id").as_text());
      for (const Json& number : claim.at("numbers").items()) {
        check_stated(number.at("value"), number.at("error"));
        CHECK((std::stod(number.at("error").line()) > 0 || number.at("origin").as_text() != "computed"));
      }
    }
  }
}

TEST_CASE("every erratum of a formula is settled: the right one is the truth, the printed one is not") {
  std::set<std::string_view> listed;
  const std::vector<Settlement> settlements = verify::settle_all(verify::formula_errata());
  for (const Settlement& settlement : settlements) {
    const Statement& erratum = settlement.erratum;
    CAPTURE(erratum.id);
    CHECK(listed.insert(erratum.id).second);
    for (const char* key : {"equation", "printed", "right", "proof"})
      CHECK_FALSE(erratum.entry->text(key).empty());
    CAPTURE(verify::stated_text(settlement.right), verify::stated_text(settlement.truth));
    CHECK(settlement.settled());
    // The printed value is clearly wrong. Otherwise the truth would have to be known better.
    if (settlement.printed) {
      const Propagated apart = verify::fabs(*settlement.printed - settlement.truth);
      CAPTURE(verify::stated_text(*settlement.printed));
      CHECK(apart.value() > 100 * apart.error());
    }
  }
  for (const Json& row : verify::errata_json(settlements).items()) {
    CAPTURE(row.at("id").as_text());
    check_stated(row.at("right_value"), row.at("right_error"));
    check_stated(row.at("truth"), row.at("truth_error"));
    if (!row.at("printed_value").is_null()) check_stated(row.at("printed_value"), row.at("printed_error"));
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
  CHECK_FALSE(Settlement{"", two, {not_a_number, 0.05}, one}.settled());
}

TEST_CASE("the solvers approach every limit with the power of the first term that it leaves out") {
  const std::vector<LimitRow> rows = verify::approach_all(verify::limits());
  CHECK(rows.size() >= 15);
  for (const LimitRow& row : rows) {
    CAPTURE(std::string(row.name), row.measured_order().value_or(0).value());
    CHECK(row.approached());
    CHECK(row.samples.back().distance().value() < 0.01);
  }
  for (const Json& row : verify::limits_json(rows).items()) {
    CAPTURE(row.at("name").as_text());
    if (!row.at("measured_order").is_null())
      check_stated(row.at("measured_order"), row.at("measured_order_error"));
    for (const Json& sample : row.at("samples").items()) {
      for (const char* name : {"found", "limit", "distance"})
        check_stated(sample.at(name), sample.at(std::string(name) + "_error"));
    }
  }
}

TEST_CASE("a limit approached too slowly, too fast, not at all, or within the error's haze is missed") {
  CHECK(row_with(2, 0.04, 0.01).approached());
  CHECK(row_with(2, 0.04, 0.01).measured_order()->value() == doctest::Approx(2));
  CHECK_FALSE(row_with(2, 0.04, 0.02).approached());
  CHECK_FALSE(row_with(1, 0.04, 0.01).approached());
  CHECK_FALSE(row_with(1, 0.02, 0.02).approached());
  CHECK_FALSE(row_with(2, 0.04, 0.01, 0.005).approached());
  CHECK(row_with(0, 0.04, 0.0001).approached());
  CHECK_FALSE(row_with(0, 0.04, 0.01).approached());
}
