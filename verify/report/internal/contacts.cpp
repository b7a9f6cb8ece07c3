#include <fmt/format.h>

#include <nipref/verify/report/internal/sections.hpp>
#include <nipref/verify/support/internal/or_dash.hpp>

namespace nipref::verify {
namespace {

Markup scenes_table(const std::vector<SceneTally>& scenes) {
  TableMarkup table("Stated errors of random contacts against truth, by kind",
                    {"kind", "verdict", "#scenes", "#refused", "#numbers", "#with a truth", "#not covered",
                     "#largest error over statement", "#statement over error, median", "#misses reported",
                     "#misses unreported", "#slowest, s"});
  for (const SceneTally& tally : scenes)
    table.row({{std::string(tally.kind), false, "keep"},
               {verdict_mark(tally.kept()), false, "keep"},
               number_cell(std::to_string(tally.scenes)),
               number_cell(std::to_string(tally.refused)),
               number_cell(std::to_string(tally.numbers)),
               number_cell(std::to_string(tally.numbers - tally.unchecked)),
               number_cell(std::to_string(tally.uncovered)),
               number_cell(fmt::format("{:.3g}", tally.worst.largest_ratio)),
               number_cell(or_dash(tally.median_overestimate(), 3)),
               number_cell(std::to_string(tally.miss_reported)),
               number_cell(std::to_string(tally.miss_unreported)),
               number_cell(fmt::format("{:.2g}", tally.slowest.seconds))});
  return table.markup();
}

/// The scenes that did not keep their statements, to be solved again.
Markup broken_scenes(const std::vector<SceneTally>& scenes) {
  Markup markup;
  for (const SceneTally& tally : scenes) {
    if (tally.failed > 0)
      markup += element("h3", fmt::format("{}: {} scenes failed: {}", tally.kind, tally.failed,
                                          tally.failure.failed)) +
                element("pre", tally.failure.toml);
    if (!tally.kept() && tally.worst.largest_ratio > 0)
      markup += element("h3", fmt::format("{}: error over statement {:.3g}: {}", tally.kind,
                                          tally.worst.largest_ratio, tally.worst.where)) +
                element("pre", tally.worst.toml);
  }
  return markup;
}

Markup witness_markup(const Witness& witness) {
  if (!witness.installed)
    return element(
        "p",
        "An outside witness was skipped: the finite-element program CalculiX is not installed (Debian's calculix-ccx).");
  TableMarkup table(
      "Converged contacts and the finite-element program CalculiX: how far they are apart",
      {"sheet, in", "friction", "verdict", "#load", "#normal displacement", "#tangential displacement"});
  for (const Witnessed& one : witness.contacts)
    table.row({{fmt::format("B = {:g}", one.thickness)},
               {one.gripped ? "full" : "none"},
               {verdict_mark(one.agrees())},
               number_cell(fmt::format("{:.1e} of {:.0e}", one.load, Witnessed::load_limit)),
               number_cell(fmt::format("{:.1e} of {:.0e}", one.normal, Witnessed::normal_limit)),
               number_cell(fmt::format("{:.1e} of {:.0e}", one.tangential, Witnessed::tangential_limit))});
  return table.markup();
}

Markup hard_case_verdict(const ContactAudit& audit) {
  return audit.kept() ? verdict_mark(*audit.kept()) : Markup("- no truth");
}

}  // namespace

Markup contacts_section(const Report& report) {
  return section(
      "contacts", "Whole contacts: stated errors against truth",
      element(
          "p",
          "Random scenes to the ends of their domains. The truth is the reference, the same contact at 1e-13, or an identity: "
          "other units, mirrored, turned, given back. A stated error that does not cover the error breaks the run; one "
          "that is far too large is no good either, so that its median over the error stands here too.") +
          scenes_table(report.scenes) + broken_scenes(report.scenes) + witness_markup(report.witness));
}

Markup hard_cases_section(const Report& report) {
  TableMarkup table("Hard cases of elastic contacts: condition, oscillation, error",
                    {"system", "verdict", "#L/B", "#Poisson", "#unknowns", "#condition", "#oscillation",
                     "#error", "#allowed", "#of kernels", "#of discretisation"});
  for (const ContactAudit& audit : report.hard_cases)
    table.row({{audit.system, false, "keep"},
               {hard_case_verdict(audit), false, "keep"},
               number_cell(fmt::format("{:g}", audit.ratio)),
               number_cell(fmt::format("{:.3g}", audit.poisson)),
               number_cell(std::to_string(audit.unknowns)),
               number_cell(or_dash(audit.condition, 2)),
               number_cell(or_dash(audit.oscillation, 2)),
               number_cell(or_dash(audit.error, 2)),
               number_cell(fmt::format("{:.2g}", audit.allowed)),
               number_cell(or_dash(audit.kernel_error, 2)),
               number_cell(or_dash(audit.discretisation_error, 2))});
  return section(
      "hard-cases", "Hard cases",
      element(
          "p",
          "Contacts thin and thick, sheets compressible and not, many elements and few. Errors of line loads are "
          "relative to the largest, those of converged contacts are of the load; no verdict without a truth.") +
          details("All hard cases", table.markup()));
}

}  // namespace nipref::verify
