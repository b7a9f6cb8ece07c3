#include <nipref/verify/cli/audit_run.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {

int audit_verb(const CommandLine& line, std::ostream& out) {
  stop_gently_on_interrupt();
  Progress progress(standard_error(line.has("quiet")));
  AuditRun run(line);
  run.do_blocks(progress);
  return run.answer(out);
}

}  // namespace nipref::verify
