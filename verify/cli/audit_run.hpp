#pragma once
#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/run_folder.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {

/// The points of the quantity's golden values that lie in the ranges, at most `most` of them, evenly taken; none if it
/// has no golden values. BadInput if their file cannot be read.
std::vector<Point> golden_points(const Quantity& quantity, const Ranges& ranges, std::size_t most);

/// The options that determine a quantity's points: --points, or without it `density`, --seed, and the assigned ranges.
/// Golden points are added.
AuditOptions sampling_options(const CommandLine& line, const Quantity& quantity, double density = 1);

/// The audit that a command line asks for, divided into blocks. With --out the findings are kept in a folder, from
/// which a later process continues.
class AuditRun {
 public:
  /// Reads --points, or one of --density, --quick and --thorough, and --seed and --rtol. BadInput for anything wrong in
  /// the command line or the folder. `keeps_points` as for QuantityWork.
  explicit AuditRun(const CommandLine& line, bool keeps_points = false);

  /// The text, in lines, that identifies a run: this program, the command, and the inputs of each work.
  [[nodiscard]] std::string fingerprint() const;

  /// Computes one block after the other, each on all cores, until all are done or the process is interrupted.
  /// OutputError if findings cannot be written to the folder.
  void do_blocks(Progress& progress);
  /// Reads all blocks from these folders of the same run, instead of computing them. BadInput if some are missing.
  void merge(const std::vector<std::filesystem::path>& folders);

  /// The findings of the works that are finished, and those of contacts as far as they go.
  [[nodiscard]] Audited found() const;

  /// The answer: the findings of the finished works. For a shard, or an interrupted run in a folder, it says only how
  /// many blocks are done, and all is well, because launchers end all ranks when one returns a status other than 0.
  [[nodiscard]] VerbAnswer answer(const CommandLine& line) const;

 private:
  Shard shard_;
  Json command_;
  fast::Accuracy accuracy_;
  std::vector<std::unique_ptr<QuantityWork>> quantities_;  ///< the first of the works
  std::unique_ptr<ListWork<ContactAudit>> hard_cases_;     ///< null if contacts are not audited
  std::unique_ptr<ListWork<SceneTally>> scenes_;           ///< null if contacts are not audited
  StoredBlocks stored_{{}};                                ///< the blocks that are done
  std::optional<ShardFile> file_;
  std::size_t there_ = 0;  ///< number of blocks at the start
};

}  // namespace nipref::verify
