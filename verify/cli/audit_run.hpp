#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/run_folder.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {

/// The points of the quantity's golden values that lie in the ranges, at most `most` of them, evenly taken; none if it
/// has no golden values. BadInput if their file cannot be read.
std::vector<Point> golden_points(const Quantity& quantity, const Ranges& ranges, std::size_t most);

/// Which points of a quantity are drawn: by the options points and seed, or a density in place of points, and by the
/// ranges that are assigned. Golden points are among them.
AuditOptions sampling_options(const CommandLine& line, const Quantity& quantity, double density = 1);

/// The JSON of an audit, by itself and within a report.
Json audits_json(const Audited& audited, fast::Accuracy accuracy);

/// The audit that a command line asks for, divided into blocks.
class AuditWorks {
 public:
  /// Reads --points, or one of --density, --quick and --thorough, and --seed and --rtol. BadInput for anything wrong
  /// in the command line. `keeps_points` as for QuantityWork.
  AuditWorks(const CommandLine& line, bool keeps_points);

  [[nodiscard]] std::vector<BlockWork*> all() const;
  /// The text, in lines, that identifies a run: this program, the command, and the inputs of each work.
  [[nodiscard]] std::string fingerprint() const;

  /// The findings of the first `finished` works, and those of contacts as far as they go.
  [[nodiscard]] Audited found(std::size_t finished) const;
  /// Prints the findings in the form that the command line asks for, and returns the exit status.
  int answer(const CommandLine& line, std::ostream& out, std::size_t finished) const;

 private:
  std::vector<std::string> words_;
  fast::Accuracy accuracy_;
  std::vector<std::unique_ptr<QuantityWork>> quantities_;
  std::unique_ptr<HardCasesWork> hard_cases_;  ///< null if contacts are not audited
  std::unique_ptr<ScenesWork> scenes_;         ///< null if contacts are not audited
};

/// Does the blocks of an audit. With --out their findings are kept in a folder, from which a later process continues.
class AuditRun {
 public:
  /// BadInput for anything wrong in the command line or the folder.
  explicit AuditRun(const CommandLine& line, bool keeps_points = false);

  /// Computes one block after the other, each on all cores, until all are done or the process is interrupted. OutputError
  /// if findings cannot be written to the folder.
  void do_blocks(Progress& progress);

  /// The findings of the works that are finished.
  [[nodiscard]] Audited found() const { return works_.found(finished()); }

  /// Prints the findings of the finished works. For a shard, or an interrupted run in a folder, prints what this
  /// process did and returns status 0, because launchers end all ranks when one of them returns another status.
  int answer(std::ostream& out) const;

 private:
  [[nodiscard]] std::size_t finished() const;  ///< works, the first ones

  CommandLine line_;
  Shard shard_;
  AuditWorks works_;
  std::vector<BlockWork*> all_;
  StoredBlocks stored_;  ///< those that are done
  std::optional<ShardFile> file_;
  std::size_t there_ = 0;  ///< number of blocks at the start
};

}  // namespace nipref::verify
