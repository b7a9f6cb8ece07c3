#include <nipref/verify/audit/internal/contacts.hpp>
#include <nipref/verify/audit/render.hpp>
#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/audit_all.hpp>
#include <nipref/verify/cli/options.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {

int audit_verb(const CommandLine& line, std::ostream& out) {
  const Selection selected = selection(line, {"contacts"});
  const AuditOptions options{points_option(line, 0), accuracy_option(line), {}};
  const std::vector<AuditResult> results = audit_all(selected.quantities, options);
  Progress progress;
  const auto contact_audits =
      selected.has("contacts")
          ? audit_contacts([&](const std::string& what) { progress.show("audit " + what); })
          : std::vector<ContactAudit>{};
  if (line.json) {
    out << answer_text("audit", audits_json(results, contact_audits, options.accuracy), line.no_times);
  } else {
    if (!results.empty()) out << audit_text(results, options.accuracy);
    if (selected.has("contacts")) out << "\n" << contact_audit_text(contact_audits);
  }
  return all_kept(results) && all_kept(contact_audits) ? 0 : 1;
}

}  // namespace nipref::verify
