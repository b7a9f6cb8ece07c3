#include <fmt/format.h>
#include <fmt/ostream.h>

#include <nlohmann/json.hpp>

#include "verify/audit_all.hpp"
#include "verify/catalogue.hpp"
#include "verify/render_audit.hpp"
#include "verify/verb_options.hpp"
#include "verify/verbs.hpp"

namespace nipref::verify {

int audit_verb(const CommandLine& line, std::ostream& out) {
  const auto quantities = select_quantities(line.words);
  const AuditOptions options{points_option(line, AuditOptions{}.points), accuracy_option(line), {}};
  const std::vector<AuditResult> results = audit_all(quantities, options);
  if (line.json) {
    fmt::print(out, "{}\n", audit_json(results).dump(2));
  } else {
    fmt::print(out, "{}", audit_text(results, options.accuracy));
  }
  return all_kept(results) ? 0 : 1;
}

}  // namespace nipref::verify
