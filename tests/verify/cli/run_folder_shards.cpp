#include <nipref/verify/cli/run_folder.hpp>
#include <nipref/verify/support/internal/process.hpp>

#include "support/paths.hpp"
#include "support/test.hpp"

using namespace nipref;
using verify::Shard;

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
    // Outside of the launcher nothing is taken for a shard.
    CHECK_THROWS_AS(
        static_cast<void>(verify::parse_shard(verify::output_of({"sh", "-c", "printf %s " + shard}).text)),
        data::BadInput);
    ++launchers;
  }
  CHECK(launchers == 5);
}
