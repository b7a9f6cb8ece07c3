#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/run_folder.hpp>
#include <nipref/verify/support/internal/process.hpp>
#include <nipref/verify/support/random.hpp>

#include "support/json_schema.hpp"
#include "support/run_nipref.hpp"

using namespace nipref;
namespace fs = std::filesystem;
using verify::Shard;

namespace {

constexpr auto fingerprint = "{\n  \"of\": \"this\",\n  \"works\": 1\n}\n";

/// A cheap audit of ten blocks.
verify::AuditOptions ten_blocks() {
  verify::AuditOptions options{200, {}, {}};
  options.block = 20;
  return options;
}

/// A process that has just been started, with its knowledge of the run.
struct Process {
  verify::QuantityWork work{verify::find_quantity("I3"), ten_blocks()};
  verify::StoredBlocks there{{&work}};
  std::size_t done = 0;

  /// Does blocks of the shard until `most` blocks are done.
  void run(const fs::path& folder, verify::Shard shard, std::size_t most) {
    verify::ShardFile file(folder, fingerprint, shard);
    there.read(folder);
    for (std::size_t block = 0; block < work.blocks() && done < most; ++block) {
      if (!shard.has(block) || there.has(0, block)) continue;
      file.append(work, block, work.do_block(block, {}));
      ++done;
    }
  }
};

/// The result of all blocks in the folder.
std::string merged(const fs::path& folder) {
  Process merging;
  merging.there.read(folder);
  CHECK(merging.there.gaps() == "");
  return verify::audit_row_json(merging.work.result()).text();
}

}  // namespace

TEST_CASE("a run killed again and again finds what one process finds, and repeats a block a kill at most") {
  const ScratchFolder alone, killed;
  Process one;
  one.run(alone.path(), {}, 10);
  REQUIRE(one.done == 10);
  verify::Random random("kills");
  std::size_t done = 0, kills = 0;
  for (int round = 0; round < 12; ++round) {
    for (const verify::Shard shard : {verify::Shard{0, 2}, verify::Shard{1, 2}}) {
      Process process;
      process.run(killed.path(), shard, random.index(3));
      done += process.done;
      // A kill during a write leaves a part of the last line, or nothing of it.
      const fs::path file = killed.path() / (shard.index == 0 ? "shard-1-of-2.jsonl" : "shard-2-of-2.jsonl");
      const std::string text = text_of_file(file);
      if (process.done == 0 || round > 8) continue;
      const std::size_t start = text.rfind('\n', text.size() - 2) + 1;  // npos + 1 is the file's start
      fs::resize_file(file, start + random.index(text.size() - start));
      ++kills;
    }
  }
  CHECK(kills > 5);
  for (const verify::Shard shard : {verify::Shard{0, 2}, verify::Shard{1, 2}}) {
    Process last;
    last.run(killed.path(), shard, 10);
    done += last.done;
  }
  CHECK(merged(killed.path()) == merged(alone.path()));
  CHECK(done <= 10 + kills);
}

TEST_CASE("gaps, overlaps that differ, and lines of something else are named") {
  const ScratchFolder folder;
  Process process;
  process.run(folder.path(), {0, 2}, 3);
  CHECK(process.there.count() == 0);  // the blocks that were there at the start
  Process again;
  again.there.read(folder.path());
  CHECK(again.there.gaps() == "I3 block 1, I3 block 3, I3 blocks 5 to 9");
  CHECK(again.there.count() == 3);
  CHECK(again.there.of() == 10);

  const std::string done = text_of_file(folder.file("shard-1-of-2.jsonl")),
                    line = done.substr(0, done.find('\n') + 1);
  const auto reading = [&](const std::string& text) {
    folder.write("shard-2-of-2.jsonl", text);
    return refusal_of([&] { Process().there.read(folder.path()); });
  };
  std::string changed = line;
  changed.replace(changed.find("\"points\":") + 9, 1, "9");
  for (const auto& [text, says] : std::vector<std::pair<std::string, std::string>>{
           {line, "accepted"},
           {"{\"work\":\"I3\",\"bl", "accepted"},  // half a line does not count
           {line + changed, "shard-2-of-2.jsonl:2: must have what another line has for I3 block 0"},
           {"rubbish\n", "shard-2-of-2.jsonl:1: must be the line of a block of this run (no JSON)"},
           {"{\"work\":\"I3\",\"block\":10,\"found\":{}}\n", "must be the line of a block"},
           {"{\"work\":\"I7\",\"block\":1,\"found\":{}}\n", "must be the line of a block"}})
    CHECK(contains(reading(text), says));
}

TEST_CASE("a folder takes no other run, and a shard no second process") {
  const ScratchFolder folder;
  const verify::ShardFile file(folder.path(), fingerprint, {0, 2});
  const auto opened = [&](const std::string& run, verify::Shard shard) {
    return refusal_of([&] { const verify::ShardFile second(folder.path(), run, shard); });
  };
  CHECK(contains(opened(fingerprint, {0, 2}), "must be left to the process that is writing"));
  CHECK(opened(fingerprint, {1, 2}) == "accepted");
  std::string other = fingerprint;
  other.replace(other.find("this"), 4, "that");
  CHECK(contains(opened(other, {1, 2}), "there is \"of\": \"this\" where \"of\": \"that\" must be"));
  CHECK(text_of_file(folder.path() / "run.json") == fingerprint);
}

TEST_CASE("a shard is i of N, and has every N-th block") {
  const Shard third = verify::parse_shard("3/8");
  CHECK(third == Shard{2, 8});
  CHECK(third.has(2));
  CHECK(third.has(10));
  CHECK_FALSE(third.has(3));
  CHECK(verify::parse_shard("1/1") == Shard{});
  for (const char* const text :
       {"0/8", "9/8", "8", "1/", "/8", "1/0", "-1/8", "1/8/2", "1.5/8", "", "1/1000001", "env", "1/2x"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(static_cast<void>(verify::parse_shard(text)), data::BadInput);
  }
}

TEST_CASE("the README's words for launchers say which shard a process is") {
  const char* const variables =
      "OMPI_COMM_WORLD_RANK=3 OMPI_COMM_WORLD_SIZE=100 PMI_RANK=3 PMI_SIZE=100 SLURM_PROCID=3 SLURM_NTASKS=100 "
      "SLURM_ARRAY_TASK_ID=3 SLURM_ARRAY_TASK_COUNT=100 JOB_COMPLETION_INDEX=3 JOB_COMPLETIONS=100; printf %s ";
  std::ifstream readme(source_directory() + "/verify/README.md");
  int launchers = 0;
  for (std::string line; std::getline(readme, line);) {
    const std::size_t words = line.rfind("| `$((");
    if (words == std::string::npos) continue;
    CAPTURE(line);
    const std::string shard = line.substr(words + 3, line.rfind('`') - words - 3);
    CHECK(verify::parse_shard(verify::output_of({"sh", "-c", variables + shard}).text) == Shard{3, 100});
    // Without the launcher's variables nothing is taken for a shard.
    CHECK_THROWS_AS(
        static_cast<void>(verify::parse_shard(verify::output_of({"sh", "-c", "printf %s " + shard}).text)),
        data::BadInput);
    ++launchers;
  }
  CHECK(launchers == 5);
}
