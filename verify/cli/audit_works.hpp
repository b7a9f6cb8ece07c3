#pragma once
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {

/// Of whole contacts: hard cases, and random scenes.
struct ContactAudits {
  std::vector<ContactAudit> hard_cases;
  std::vector<SceneTally> scenes;

  [[nodiscard]] bool kept() const { return all_kept(hard_cases) && all_kept(scenes); }
};

struct Audited {
  std::vector<AuditResult> quantities;
  ContactAudits contacts;
};

/// What `audit` answers, and what stands for it in a report.
Json audits_json(const Audited& audited, fast::Accuracy accuracy);

/// What a command line asks to be audited, as work in blocks.
class AuditWorks {
 public:
  /// How many points, drawn from what, and which accuracy: --points, or one of --density, --quick and --thorough, --seed
  /// and --rtol. BadInput for whatever is wrong in the command line. `keeps_points` as for QuantityWork.
  AuditWorks(const CommandLine& line, bool keeps_points);

  [[nodiscard]] std::vector<BlockWork*> all() const;
  /// What a run of it rests on, as text in lines: this program, the command, the inputs of each work.
  [[nodiscard]] std::string fingerprint() const;

  /// What was found in the blocks that were added, of so many of the works that are finished; the others, but for
  /// contacts, are left out.
  [[nodiscard]] Audited found(std::size_t finished) const;
  /// Prints it as the command line wants it. Gives the exit status.
  int answer(const CommandLine& line, std::ostream& out, std::size_t finished) const;

 private:
  std::vector<std::string> words_;
  fast::Accuracy accuracy_;
  std::vector<std::unique_ptr<QuantityWork>> quantities_;
  std::unique_ptr<HardCasesWork> hard_cases_;  ///< none: contacts were not asked for
  std::unique_ptr<ScenesWork> scenes_;         ///< likewise
};

/// The command line that a fingerprint is of. JsonMisfit if it is none.
CommandLine command_of_fingerprint(const std::string& fingerprint);

}  // namespace nipref::verify
