#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace nipref::verify {

/// Which of so many processes this is, of those that share a run.
struct Shard {
  std::size_t index = 0;  ///< from 0
  std::size_t of = 1;

  /// Whether a block is this one's: one after the other, so that slow ones are spread.
  [[nodiscard]] bool has(std::size_t block) const { return block % of == index; }
  bool operator==(const Shard&) const = default;
};

/// The text of a variable of the environment, or nothing.
using Environment = std::function<std::optional<std::string>(const std::string& name)>;

/// Of this process.
std::optional<std::string> environment(const std::string& name);

/// "3/8", the third of eight, or "env": what the launcher says. Ranks are those of Open MPI (OMPI_COMM_WORLD_RANK and
/// _SIZE) or MPICH and its kin (PMI_RANK and PMI_SIZE), or else tasks of Slurm (SLURM_PROCID and SLURM_NTASKS), for MPI's
/// launchers themselves are tasks of Slurm. Around them may be an array job of Slurm (SLURM_ARRAY_TASK_ID, _MIN, _STEP and
/// _COUNT) or an indexed job of Kubernetes (JOB_COMPLETION_INDEX; JOB_COMPLETIONS, how many there are, is for the pod's
/// own description to set): each of its members has all the ranks. BadInput naming "shard" where none of that is set, two
/// of them contradict each other, or one is not whole.
Shard parse_shard(const std::string& text, const Environment& variable = environment);

}  // namespace nipref::verify
