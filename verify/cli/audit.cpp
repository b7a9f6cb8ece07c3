#include <set>

#include <nipref/verify/audit/render.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/ranges.hpp>
#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/audit_all.hpp>
#include <nipref/verify/cli/changed.hpp>
#include <nipref/verify/cli/interruption.hpp>
#include <nipref/verify/cli/options.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

constexpr const char* contacts = "contacts";

/// Options are for quantities; an absolute number of points for those that are named: what is quick for one
/// takes hours for another.
void refuse_options_without_effect(const CommandLine& line, const Selection& selected) {
  if (line.words.empty() && !line.has("changed"))
    refuse_option(line, "points",
                  "must be left out without names of quantities: --density is for all of them");
  if (!selected.quantities.empty()) return;
  for (const char* const name : {"points", "density", "quick", "thorough", "rtol"})
    refuse_option(line, name, "has no effect on contacts: must be left out");
}

void refuse_options_of_contacts(const CommandLine& line) {
  for (const char* const name : {"scenes", "seed"})
    refuse_option(line, name, "has an effect on contacts only: must be left out");
}

/// Ranges of arguments that one of the quantities does not have, or that are none.
void refuse_ranges(const CommandLine& line, const Selection& selected) {
  if (line.assignments.empty()) return;
  if (selected.has(contacts) || line.has("changed"))
    throw data::BadInput(line.assignments.front().first, line.assignments.front().second,
                         "has an effect on quantities that are named only: must be left out");
  for (const Quantity* quantity : selected.quantities)
    static_cast<void>(parse_ranges(*quantity, line.assignments));
}

/// Quantities and contacts that changed files have a part in.
Selection changed_selection(const CommandLine& line) {
  if (!line.words.empty()) refuse_option(line, "changed", "must be left out beside names");
  const std::set<std::string> subjects =
      touched_subjects(changed_files(line.option("since").value_or("HEAD")));
  Selection selected;
  for (const Quantity& quantity : catalogue()) {
    if (subjects.contains(std::string(quantity.subject))) selected.quantities.push_back(&quantity);
  }
  if (subjects.contains(contacts)) selected.groups.push_back(contacts);
  return selected;
}

}  // namespace

int audit_verb(const CommandLine& line, std::ostream& out) {
  if (!line.has("changed")) refuse_option(line, "since", "must be given with --changed");
  const Selection selected = line.has("changed") ? changed_selection(line) : selection(line, {contacts});
  refuse_options_without_effect(line, selected);
  const bool with_contacts = selected.has(contacts);
  if (!with_contacts) refuse_options_of_contacts(line);
  static_cast<void>(scenes_option(line));  // refused before anything is done
  const AuditOptions options = audit_options(line);
  refuse_ranges(line, selected);
  stop_gently_on_interrupt();
  Progress progress(standard_error(line.has("quiet")));
  progress.begin("audit", selected.quantities.size() + (with_contacts ? 2 : 0));
  const std::vector<AuditResult> results =
      audit_all(selected.quantities, options, progress, line.assignments);
  const ContactAudits of_contacts = with_contacts ? audit_all_contacts(line, progress) : ContactAudits{};
  if (line.json) {
    out << answer_text("audit", audits_json(results, of_contacts, options.accuracy), line.no_times);
  } else {
    if (!results.empty()) out << folded(audit_text(results, options.accuracy));
    if (with_contacts) out << "\n" << folded(contact_audits_text(of_contacts));
    if (results.empty() && !with_contacts) out << "nothing that was changed has a part in a quantity\n";
    out << interruption_text();
  }
  return all_kept(results) && of_contacts.kept() ? 0 : 1;
}

}  // namespace nipref::verify
