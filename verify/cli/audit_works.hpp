#pragma once
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {

/// What a command line asks to be audited, as work in blocks.
class AuditWorks {
 public:
  /// BadInput for whatever is wrong in the command line.
  explicit AuditWorks(const CommandLine& line);

  [[nodiscard]] std::vector<BlockWork*> all() const;
  /// What a run of it rests on, as text in lines: this program, the command, the inputs of each work.
  [[nodiscard]] std::string fingerprint() const;

  /// Prints what was found in the blocks that were added, as the command line wants it, of so many of the works that are
  /// finished; the others, but for contacts, are left out. Gives the exit status.
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
