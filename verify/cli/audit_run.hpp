#pragma once
#include <cstddef>
#include <optional>
#include <ostream>
#include <vector>

#include <nipref/verify/cli/audit_works.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/run_folder.hpp>
#include <nipref/verify/cli/shard.hpp>

namespace nipref::verify {

struct BlockAt {
  std::size_t work, block;
};

/// The blocks of an audit, handed out and taken back: with --out in a folder, in which it goes on where it was.
class AuditRun {
 public:
  /// BadInput for whatever is wrong in the command line or the folder.
  explicit AuditRun(const CommandLine& line, bool keeps_points = false);

  [[nodiscard]] const std::vector<BlockWork*>& works() const { return all_; }
  /// One that is not there, each once, in order; nothing when all have been handed out.
  std::optional<BlockAt> next();
  /// Keeps what was found in one that was handed out. OutputError if the folder does not take it.
  void keep(BlockAt at, const BlockFindings& found);
  /// Does one block after the other, each on all cores, until all are done or the process is interrupted.
  void do_blocks(Progress& progress);

  /// What was found in the works that are finished.
  [[nodiscard]] Audited found() const { return works_.found(finished()); }

  /// Of a shard or an interrupted run in a folder what it did, with status 0: launchers end all ranks when one gives
  /// another. Otherwise what was found in the works that are finished.
  int answer(std::ostream& out) const;

 private:
  [[nodiscard]] std::size_t finished() const;  ///< works, the first ones
  void write_shard(std::ostream& out) const;

  CommandLine line_;
  Shard shard_;
  AuditWorks works_;
  std::vector<BlockWork*> all_;
  std::optional<ShardFile> file_;
  std::optional<BlocksThere> there_;      ///< at the start
  std::vector<std::size_t> blocks_done_;  ///< of each work
  BlockAt at_{0, 0};                      ///< what is looked at next
  std::size_t done_ = 0;
};

}  // namespace nipref::verify
