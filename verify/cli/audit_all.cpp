#include <fmt/format.h>

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

}  // namespace nipref::verify
