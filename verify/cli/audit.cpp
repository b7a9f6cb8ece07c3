#include <nipref/verify/audit/internal/contacts.hpp>
#include <nipref/verify/audit/render.hpp>
#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/audit_all.hpp>
#include <nipref/verify/cli/interruption.hpp>
#include <nipref/verify/cli/options.hpp>
#include <nipref/verify/cli/verbs.hpp>

namespace nipref::verify {
namespace {

/// Options are for quantities; an absolute number of points for those that are named: what is quick for one
/// takes hours for another.
void refuse_options_without_effect(const CommandLine& line, const Selection& selected) {
  if (line.words.empty())
    refuse_option(line, "points",
                  "must be left out without names of quantities: --density is for all of them");
  if (!selected.quantities.empty()) return;
  for (const char* const name : {"points", "density", "quick", "thorough", "rtol"})
    refuse_option(line, name, "has no effect on contacts: must be left out");
}

}  // namespace

int audit_verb(const CommandLine& line, std::ostream& out) {
  const Selection selected = selection(line, {"contacts"});
  refuse_options_without_effect(line, selected);
  const AuditOptions options = audit_options(line);
  stop_gently_on_interrupt();
  Progress progress(standard_error(line.has("quiet")));
  progress.begin("audit", selected.quantities.size() + selected.groups.size());
  const std::vector<AuditResult> results = audit_all(selected.quantities, options, progress);
  std::vector<ContactAudit> contact_audits;
  if (selected.has("contacts")) {
    progress.next("contacts");
    contact_audits = audit_contacts([&](const std::string& what) { progress.at(0, what); });
  }
  if (line.json) {
    out << answer_text("audit", audits_json(results, contact_audits, options.accuracy), line.no_times);
  } else {
    if (!results.empty()) out << audit_text(results, options.accuracy);
    if (selected.has("contacts")) out << "\n" << contact_audit_text(contact_audits);
    out << interruption_text();
  }
  return all_kept(results) && all_kept(contact_audits) ? 0 : 1;
}

}  // namespace nipref::verify
