#include <fmt/format.h>

#include <nipref/verify/audit/render.hpp>
#include <nipref/verify/cli/audit_all.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {

std::vector<AuditResult> audit_all(const std::vector<const Quantity*>& quantities, AuditOptions options) {
  Progress progress;
  std::vector<AuditResult> results;
  for (const Quantity* quantity : quantities) {
    options.progress = [&](std::size_t done) {
      progress.show(fmt::format("audit {}: {} of about {} points", quantity->name, done,
                                options.points == 0 ? quantity->audit_points : options.points));
    };
    results.push_back(audit(*quantity, options));
  }
  return results;
}

Json audits_json(const std::vector<AuditResult>& results, const std::vector<ContactAudit>& contacts,
                 fast::Accuracy accuracy) {
  const bool is_full = accuracy.rtol() <= fast::Accuracy::best_rtol;
  return {{"rtol", is_full ? Json() : Json(accuracy.rtol())},
          {"rows", audit_json(results)},
          {"contacts", contact_audit_json(contacts)}};
}

}  // namespace nipref::verify
