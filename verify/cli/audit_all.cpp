#include <nipref/data/bad_input.hpp>
#include <nipref/verify/audit/render.hpp>
#include <nipref/verify/cli/audit_all.hpp>
#include <nipref/verify/cli/golden_points.hpp>
#include <nipref/verify/cli/options.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>

namespace nipref::verify {
namespace {

constexpr double quick = 0.1;
constexpr double thorough = 10;
constexpr double of_report = 0.3;  // so that it takes no more than three minutes

double density_option(const CommandLine& line) {
  constexpr double least = 1e-6, most = 1000;
  if (line.has("quick")) return quick;
  if (line.has("thorough")) return thorough;
  const auto text = line.option("density");
  if (!text) return line.verb == "report" ? of_report : 1;
  const double density = parse_real("density", *text);
  if (density < least || density > most)
    throw data::BadInput("density", *text, "must be a number from 1e-6 to 1000");
  return density;
}

}  // namespace

AuditOptions audit_options(const CommandLine& line) {
  std::string first;
  for (const char* const name : {"points", "density", "quick", "thorough"}) {
    if (!line.option(name) && !line.has(name)) continue;
    if (!first.empty())
      throw data::BadInput(name, line.option(name).value_or("(given)"), "must be left out beside " + first);
    first = name;
  }
  AuditOptions options{points_option(line), accuracy_option(line), {}, density_option(line)};
  options.seed = seed_option(line);
  return options;
}

std::vector<AuditResult> audit_all(const std::vector<const Quantity*>& quantities, AuditOptions options,
                                   Progress& progress, const Assignments& ranges) {
  std::vector<AuditResult> results;
  for (const Quantity* quantity : quantities) {
    if (interrupted()) break;
    progress.next(quantity->name);
    const auto expected = static_cast<double>(options.points_of(*quantity));
    if (!ranges.empty()) options.ranges = parse_ranges(*quantity, ranges);
    options.more_points =
        golden_points(*quantity, options.ranges, options.points_of(*quantity) / golden_share);
    options.progress = [&](std::size_t done) { progress.at(static_cast<double>(done) / expected); };
    try {
      results.push_back(audit(*quantity, options));
    } catch (const Interrupted&) {
      break;
    }
  }
  return results;
}

ContactAudits audit_all_contacts(const CommandLine& line, Progress& progress) {
  progress.next("contacts");
  ContactAudits contacts;
  contacts.hard_cases = audit_contacts([&](const std::string& what) { progress.at(0, what); });
  // A part of its own: how long the hard cases took says nothing of the time left.
  progress.begin("audit contacts", 1);
  progress.next("random scenes");
  contacts.scenes =
      audit_scenes(scenes_option(line), seed_option(line), [&](double part) { progress.at(part); });
  return contacts;
}

std::string contact_audits_text(const ContactAudits& contacts) {
  return contact_audit_text(contacts.hard_cases) + "\n" + scene_tally_text(contacts.scenes);
}

Json audits_json(const std::vector<AuditResult>& results, const ContactAudits& contacts,
                 fast::Accuracy accuracy) {
  const bool is_full = accuracy.rtol() <= fast::Accuracy::best_rtol;
  return {{"rtol", is_full ? Json() : Json(accuracy.rtol())},
          {"rows", audit_json(results)},
          {"contacts", contact_audit_json(contacts.hard_cases)},
          {"scenes", scene_tally_json(contacts.scenes)}};
}

}  // namespace nipref::verify
