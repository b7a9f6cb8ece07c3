#include <nipref/verify/cli/audit_run.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {
namespace {

/// One block after the other, each on all cores, until all are done or the process is interrupted.
void do_blocks(AuditRun& run, Progress& progress) try {
  const std::vector<BlockWork*>& works = run.works();
  progress.begin("audit", works.size());
  std::size_t begun = 0;  // works
  while (const auto at = run.next()) {
    stop_if_interrupted();
    BlockWork& work = *works[at->work];
    for (; begun <= at->work; ++begun) progress.next(works[begun]->name());
    const auto told = [&](double part) {
      progress.at((static_cast<double>(at->block) + part) / static_cast<double>(work.blocks()));
    };
    run.keep(*at, work.found_in(at->block, told));
  }
} catch (const Interrupted&) {
}

}  // namespace

int audit_verb(const CommandLine& line, std::ostream& out) {
  stop_gently_on_interrupt();
  Progress progress(standard_error(line.has("quiet")));
  AuditRun run(line);
  do_blocks(run, progress);
  return run.answer(out);
}

}  // namespace nipref::verify
