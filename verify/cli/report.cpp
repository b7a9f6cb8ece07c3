#include <algorithm>

#include <nipref/verify/audit/render.hpp>
#include <nipref/verify/bench/render.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/audit_all.hpp>
#include <nipref/verify/cli/bench_all.hpp>
#include <nipref/verify/cli/interruption.hpp>
#include <nipref/verify/cli/machine.hpp>
#include <nipref/verify/cli/options.hpp>
#include <nipref/verify/cli/report.hpp>
#include <nipref/verify/cli/tables.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/replay/render.hpp>

namespace nipref::verify {
namespace {

/// Fast against ref: the quantities, and whole contacts.
struct Audits {
  std::vector<AuditResult> quantities;
  ContactAudits contacts;

  [[nodiscard]] bool kept() const { return all_kept(quantities) && contacts.kept(); }
};

Audits run_audits(const CommandLine& line, const AuditOptions& options, Progress& progress) {
  const auto all = select_quantities({});
  progress.begin("audit", all.size() + 2);
  std::vector<AuditResult> quantities = audit_all(all, options, progress);
  return {std::move(quantities), audit_all_contacts(line, progress)};
}

/// On each quantity's first range only, which is the one that the promised ratios are about, all rows in many
/// digits, and the contacts.
std::vector<BenchRow> essential_rows(const std::vector<BenchRow>& rows) {
  std::vector<BenchRow> essential;
  std::ranges::copy_if(rows, std::back_inserter(essential), [](const BenchRow& row) {
    return row.arguments.find(" in [1e-6,20]") != std::string::npos ||
           row.method.find("digits") != std::string::npos || row.quantity == "elastic-nip" ||
           row.quantity == "viscoelastic-nip" || row.quantity == "half-space";
  });
  return essential;
}

void print_as_text(const BenchReport& speed, const Audits& audits, const Witness& witness,
                   const std::vector<Replay>& tables, std::ostream& out) {
  out << "nipref report\n\n"
      << version_text() << "\nAccuracy: fast against ref at the worst arguments found\n\n"
      << audit_text(audits.quantities, {}) << "\nHard cases of the contacts, and random scenes\n\n"
      << contact_audits_text(audits.contacts)
      << "\nWhat an outside finite-element program makes of converged contacts\n\n"
      << witness_text(witness) << "\nSpeed against error (all ranges: nipref bench)\n\n"
      << bench_text(essential_rows(speed.rows)) << "\n"
      << ratios_text(speed.ratios) << "\nTables of the seeds, replayed\n\n"
      << tables_text(tables, false) << interruption_text();
}

}  // namespace

Json report_json(const BenchReport& speed, const std::vector<AuditResult>& quantities,
                 const ContactAudits& contacts, const Witness& witness, const std::vector<Replay>& tables) {
  return {{"audit", audits_json(quantities, contacts, {})},
          {"witness", witness_json(witness)},
          {"bench", bench_json(speed)},
          {"tables", tables_json(tables)}};
}

int report_verb(const CommandLine& line, std::ostream& out) {
  const AuditOptions options = audit_options(line);
  static_cast<void>(scenes_option(line));  // refused before anything is done
  stop_gently_on_interrupt();
  Progress progress(standard_error(line.has("quiet")));
  // Before the audit, which would build ref's nodes: their cost is measured.
  const BenchReport speed = bench_all({select_quantities({}), bench_groups()}, progress);
  const Audits audits = run_audits(line, options, progress);
  const Witness witness = outside_witness();
  const std::vector<Replay> tables = replay_and_correct(replayable_tables(), progress);
  if (line.json) {
    out << answer_text("report", report_json(speed, audits.quantities, audits.contacts, witness, tables),
                       line.no_times);
  } else {
    print_as_text(speed, audits, witness, tables, out);
  }
  return audits.kept() && witness.agrees() && !fall_short(tables) && all_met(speed, line.has("strict")) ? 0
                                                                                                        : 1;
}

}  // namespace nipref::verify
