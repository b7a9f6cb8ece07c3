#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/cli/shard.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

// A run that is kept in a folder, which may be finished by any number of processes, one after the other or at once:
// run.json says what it is a run of, and each process appends a line for each block that it finishes to a file of its own,
// shard-3-of-8.jsonl, and syncs it. A process that is killed leaves half a line at most, which does not count.

/// Blocks of all work of a run that are there, each with the hash of its line but for times: 8 bytes a block.
class BlocksThere {
 public:
  explicit BlocksThere(const std::vector<BlockWork*>& works);

  [[nodiscard]] bool has(std::size_t work, std::size_t block) const { return hashes_[work][block] != 0; }
  [[nodiscard]] std::size_t count() const;  ///< of all work
  [[nodiscard]] std::size_t of() const;     ///< that there are
  /// False if it is there already. BadInput naming "run" and `where` if it is there, and another one.
  bool add(std::size_t work, std::size_t block, const std::string& line, const std::string& where);
  /// "I1 block 17, I1 blocks 20 to 29 and 7 more": what is missing, in brief; nothing if all is there.
  [[nodiscard]] std::string gaps() const;

 private:
  const std::vector<BlockWork*>& works_;
  std::vector<std::vector<std::uint64_t>> hashes_;
};

/// What run.json has of these folders, which must all have the same: otherwise, or if one is no such folder, BadInput
/// naming "run", the folder, and the first line that differs.
std::string fingerprint_of(const std::vector<std::filesystem::path>& folders);

/// BadInput naming the first line in which the fingerprint of a folder differs from what it must be.
void refuse_other_fingerprint(const std::filesystem::path& folder, const std::string& found,
                              const std::string& expected);

/// Adds every block in the folder to its work, once, whatever the order. BadInput naming file and line for what is not a
/// block of this work, or another one than was there.
void read_blocks(const std::filesystem::path& folder, const std::vector<BlockWork*>& works,
                 BlocksThere& there);

/// A shard's own file.
class ShardFile {
 public:
  /// Makes folder, run.json and file if need be; half a line at the file's end is cut off. BadInput if the folder holds
  /// a run of something else, or another process has the file. OutputError if something cannot be written.
  ShardFile(const std::filesystem::path& folder, const std::string& fingerprint, Shard shard);
  ShardFile(const ShardFile&) = delete;
  ShardFile& operator=(const ShardFile&) = delete;
  ~ShardFile();

  /// Appends the block and waits until it is on the disk. OutputError if that fails.
  void append(const BlockWork& work, std::size_t block, const Json& found);

 private:
  std::string path_;
  int descriptor_;
};

}  // namespace nipref::verify
