#include <nlohmann/json.hpp>

#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/bench/internal/groups.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/report/report.hpp>

#include "support/test.hpp"

using namespace nipref;

TEST_CASE("hard cases of contacts: errors that ref can tell are within what condition or estimate allow") {
  std::vector<verify::ContactAudit> audits;
  for (std::size_t group = 0; group < verify::hard_case_groups; ++group)
    std::ranges::move(verify::audit_hard_cases(group), std::back_inserter(audits));
  const auto find = [&](const std::string& system, double ratio, double poisson, int unknowns) {
    return std::ranges::any_of(audits, [&](const verify::ContactAudit& audit) {
      return audit.system.find(system) == 0 && audit.ratio == ratio && audit.poisson == poisson &&
             (unknowns == 0 || audit.unknowns == unknowns);
    });
  };
  for (const double ratio : {1e-4, 1e3}) {
    for (const double poisson : {-0.9, 0.5}) {
      CHECK(find("converged, full friction", ratio, poisson, 0));
      CHECK(find("converged, no friction", ratio, poisson, 0));
      CHECK(find("line loads, full friction", ratio, poisson, 1001));
      CHECK(find("line loads, no friction", ratio, poisson, 501));
    }
  }
  CHECK(std::ranges::count_if(audits, [](const auto& audit) { return audit.kept().has_value(); }) > 30);
  CHECK(verify::all_kept(audits));
  for (const verify::ContactAudit& audit : audits) {
    CAPTURE(audit.system, audit.ratio, audit.poisson);
    CHECK(audit.condition.has_value() == (audit.system.find("line loads") == 0));
    CHECK(audit.oscillation.has_value() == (contains(audit.system, "full friction")));
    if (audit.system == "line loads, no friction" && audit.error) {
      // The kernels' part of the error is at most the condition number times a unit of their last digits. Ten elements
      // have an error of a tenth.
      CHECK(*audit.kernel_error <= 1e-15 * *audit.condition);
      if (audit.ratio <= 1) CHECK(*audit.discretisation_error > 0.05);
    }
    if (audit.system.find("converged") == 0) CHECK(audit.allowed < 1e-5);
    // The shears of many line loads with friction zigzag, the converged shear does not.
    if (audit.system == "converged, full friction") CHECK(*audit.oscillation < 0.05);
    if (audit.system == "line loads, full friction" && audit.unknowns == 1001 && audit.ratio <= 1) {
      CHECK(*audit.oscillation > 0.5);
    }
  }
}

TEST_CASE("a contact without an independent truth gets no verdict, what is not known is a dash and null") {
  const verify::ContactAudit alone{"converged, full friction", 30, 0.5, 40, {}, 0.01, 1e-8};
  verify::ContactAudit kept{"line loads, no friction", 30, 0.5, 11, 1e4, {}, 1e-11};
  kept.error = 1e-14;
  verify::ContactAudit broken = kept, no_number = kept;
  broken.error = 1e-10;
  no_number.error = std::nan("");
  CHECK_FALSE(alone.kept());
  CHECK(kept.kept() == true);
  for (const auto& fallen : {broken, no_number}) CHECK(fallen.kept() == false);
  CHECK(verify::all_kept(std::vector{alone, kept}));
  CHECK_FALSE(verify::all_kept(std::vector{alone, kept, broken}));
  const auto json = nlohmann::json::parse(verify::contact_audit_json({alone, kept, broken}).text());
  REQUIRE(json.size() == 3);
  for (const char* unknown : {"condition", "error", "kernel_error", "discretisation_error", "passed"})
    CHECK(json[0].at(unknown).is_null());
  CHECK(json[0].at("oscillation") == 0.01);
  CHECK(json[1].at("oscillation").is_null());
  CHECK(json[1].at("passed") == true);
  CHECK(json[2].at("passed") == false);
  verify::Json members = verify::audits_json({{}, {alone}, {}}, {});
  members.append({{"_of_contacts", true}, {"_of_nothing", false}});
  const std::string text = verify::text_of("audit.txt", members);
  CHECK(contains(text, "no truth"));
  CHECK(!contains(text, "nan"));
}

TEST_CASE("converged contacts at 1e-10 are at least 1e5 times nearer than the thesis's method") {
  // Contacts with Coulomb's friction take the reference long.
  std::vector<verify::BenchRow> rows;
  for (const verify::BenchPart& part : verify::elastic_bench())
    if (is_thorough() || !contains(part.name, "Coulomb"))
      std::ranges::move(part.rows(), std::back_inserter(rows));
  for (const char* sheet : {"B=1 W=100", "B=0.25 W=100", "B=0.0625 W=100", "B=0.005 W=100"}) {
    CAPTURE(sheet);
    const auto error = [&](const std::string& method) {
      const auto row = std::ranges::find_if(rows, [&](const verify::BenchRow& candidate) {
        return candidate.arguments == sheet && candidate.method == method;
      });
      REQUIRE(row != rows.end());
      return row->max_relative_error.value();
    };
    CHECK(error("thesis: m=10, 500 terms") > 1e5 * error("converged 1e-10"));
    CHECK(error("converged 1e-04") < 1e-4);
    CHECK(error("converged 1e-10") < 1e-10);
    CHECK(error("converged 1e-13") < 1e-12);
  }
  CHECK(verify::promised_ratios(rows).size() == 16);  // all ratios of elastic nips in speed.toml
}
