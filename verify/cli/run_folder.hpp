#pragma once
#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/internal/process.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// The part of this process in a run that several processes share.
struct Shard {
  std::size_t index = 0;  ///< from 0
  std::size_t of = 1;

  /// Whether a block belongs to this process. Blocks are dealt in turn, so that slow ones are spread.
  [[nodiscard]] bool has(std::size_t block) const { return block % of == index; }
  bool operator==(const Shard&) const = default;
};

/// "3/8", the third of eight. BadInput that names "shard" for another text.
Shard parse_shard(const std::string& text);

// A run in a folder, which any number of processes may continue, one after the other or at the same time. run.json
// holds the run's fingerprint. Each process appends a line for each finished block to its own file,
// shard-3-of-8.jsonl, and syncs it. A process that is killed leaves at most an incomplete line, which is ignored.

/// The blocks of a run that have findings. Each is stored as the hash of its line without times, in 8 bytes.
class StoredBlocks {
 public:
  explicit StoredBlocks(std::vector<BlockWork*> works);

  [[nodiscard]] const std::vector<BlockWork*>& works() const { return works_; }
  [[nodiscard]] bool has(std::size_t work, std::size_t block) const { return hashes_[work][block] != 0; }
  [[nodiscard]] bool has_all_of(std::size_t work) const;
  [[nodiscard]] std::size_t count() const;  ///< number of blocks with findings
  [[nodiscard]] std::size_t of() const;     ///< number of all blocks
  /// Adds every block in the folder to its work, once and in any order. BadInput that names file and line for a line
  /// that is no block of these works, or that contradicts an earlier one.
  void read(const std::filesystem::path& folder);
  /// Marks a block that this process has computed.
  void add(std::size_t work, std::size_t block) { hashes_[work][block] = 1; }
  /// The missing blocks in brief, "I1 block 17, I1 blocks 20 to 29 and 7 more"; empty if none is missing.
  [[nodiscard]] std::string gaps() const;

 private:
  /// Marks a block that was read. False if the block has findings already; BadInput if these are different.
  bool add(std::size_t work, std::size_t block, const std::string& line, const std::string& where);

  std::vector<BlockWork*> works_;
  std::vector<std::vector<std::size_t>> hashes_;  ///< 0 for a missing block
};

/// The fingerprint in run.json, which has to be the same in all these folders. Otherwise, or if one is no such folder,
/// BadInput that names "run", the folder, and the first line that differs.
std::string fingerprint_of(const std::vector<std::filesystem::path>& folders);

/// Throws BadInput that names the first line in which a folder's fingerprint differs from the expected one, if it does.
void refuse_other_fingerprint(const std::filesystem::path& folder, const std::string& found,
                              const std::string& expected);

/// The file of one shard.
class ShardFile {
 public:
  /// Makes the folder, run.json and the file if need be, and removes an incomplete line at the file's end. BadInput
  /// if the folder has another run, or another process uses the file. OutputError if something cannot be written.
  ShardFile(const std::filesystem::path& folder, const std::string& fingerprint, Shard shard);

  /// Appends the block and syncs the file. OutputError if that fails.
  void append(const BlockWork& work, std::size_t block, const Json& found);

 private:
  std::string path_;
  std::optional<Descriptor> file_;
};

}  // namespace nipref::verify
