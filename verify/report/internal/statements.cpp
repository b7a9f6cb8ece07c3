#include <fmt/format.h>

#include <nipref/verify/report/internal/sections.hpp>

// Claims, limits and errata of formulas.

namespace nipref::verify {
namespace {

Markup claim_verdict(ClaimVerdict verdict) {
  switch (verdict) {
    case ClaimVerdict::holds:
      return element("span", {{"class", "good"}}, "\u2713 holds");
    case ClaimVerdict::fails:
      return element("span", {{"class", "bad"}}, "\u2717 false");
    case ClaimVerdict::holds_in_a_range:
      break;
  }
  return element("span", {{"class", "odd"}}, "~ holds in a range");
}

Markup claim_numbers(const ClaimOutcome& outcome) {
  Markup items;
  for (const ClaimNumber& one : outcome.numbers)
    items += element("li", fmt::format("{}: {}", one.what, stated_text(one.number)));
  return items.html().empty()
             ? Markup()
             : details(fmt::format("{} numbers", outcome.numbers.size()), element("ul", items));
}

Markup settled_mark(bool settled) {
  return settled ? element("span", {{"class", "good"}}, "\u2713 settled")
                 : element("span", {{"class", "bad"}}, "\u2717 NOT SETTLED");
}

Markup approached_mark(bool approached) {
  return approached ? element("span", {{"class", "good"}}, "\u2713 approached")
                    : element("span", {{"class", "bad"}}, "\u2717 MISSED");
}

}  // namespace

Markup claims_section(const Report& report) {
  TableMarkup table("What the seeds say in words", {"statement", "verdict", "why", "where", "numbers"});
  for (const auto& [claim, outcome] : report.claims)
    table.row({{claim.statement, false, "wide"},
               {claim_verdict(outcome.verdict), false, "keep"},
               {outcome.why, false, "wide"},
               {claim.seed + ", " + claim.place},
               {claim_numbers(outcome), false, "wide"}},
              "claim-" + claim.id);
  return section("claims", "Claims of the seeds, checked", table.markup());
}

Markup limits_section(const Report& report) {
  TableMarkup table("Closed forms, and how the converged contact approaches them",
                    {"limit", "verdict", "closed form", "as what goes to 0", "#distance at the last",
                     "#falls with the power", "#must fall with", "source"});
  for (const LimitRow& row : report.limits) {
    const auto measured = row.measured_order();
    table.row({{std::string(row.name), false, "keep"},
               {approached_mark(row.approached()), false, "keep"},
               {std::string(row.statement), false, "wide"},
               {fmt::format("{}, to {:g}", row.size, row.samples.back().size), false, "wide"},
               number_cell(fmt::format("{:.1e}", row.samples.back().distance().value())),
               number_cell(measured ? stated_text(*measured) : "below the error"),
               number_cell(row.order == 0 ? "more than any" : fmt::format("{:g}", row.order)),
               {std::string(row.source), false, "wide"}});
  }
  return section("limits", "Limits known in closed form", table.markup());
}

Markup errata_section(const Report& report) {
  TableMarkup table("Formulas that the seeds print wrong, each settled by a number that neither form made",
                    {"equation", "verdict", "printed", "right", "at", "#as printed", "#as it must be",
                     "#truth", "truth by"});
  for (const auto& [erratum, settlement] : report.errata)
    table.row({{erratum.seed + " " + erratum.equation, false, "keep"},
               {settled_mark(settlement.settled()), false, "keep"},
               {erratum.printed, false, "wide"},
               {erratum.right, false, "wide"},
               {settlement.at, false, "wide"},
               number_cell(settlement.printed ? stated_text(*settlement.printed) : "no number"),
               number_cell(stated_text(settlement.right)),
               number_cell(stated_text(settlement.truth)),
               {erratum.proof, false, "wide"}},
              "erratum-" + erratum.id);
  return section("errata", "Errata of formulas", table.markup());
}

}  // namespace nipref::verify
