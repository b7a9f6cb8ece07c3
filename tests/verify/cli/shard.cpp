#include <doctest/doctest.h>

#include <map>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/cli/run_folder.hpp>

using namespace nipref;
using verify::Shard;

namespace {

using Variables = std::map<std::string, std::string>;

Shard shard_in(const Variables& variables) {
  return verify::parse_shard("env", [&](const std::string& name) {
    const auto found = variables.find(name);
    return found == variables.end() ? std::nullopt : std::optional(found->second);
  });
}

std::string refusal_in(const Variables& variables) {
  try {
    static_cast<void>(shard_in(variables));
  } catch (const data::BadInput& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a shard is i of N, and has every N-th block") {
  const Shard third = verify::parse_shard("3/8");
  CHECK(third == Shard{2, 8});
  CHECK(third.has(2));
  CHECK(third.has(10));
  CHECK_FALSE(third.has(3));
  CHECK(verify::parse_shard("1/1") == Shard{});
  for (const char* const text :
       {"0/8", "9/8", "8", "1/", "/8", "1/0", "-1/8", "1/8/2", "1.5/8", "", "1/1000001", "Env"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(static_cast<void>(verify::parse_shard(text)), data::BadInput);
  }
}

TEST_CASE("launchers say which shard a process is") {
  CHECK(shard_in({{"OMPI_COMM_WORLD_RANK", "3"}, {"OMPI_COMM_WORLD_SIZE", "8"}}) == Shard{3, 8});
  CHECK(shard_in({{"PMI_RANK", "0"}, {"PMI_SIZE", "2"}}) == Shard{0, 2});
  CHECK(shard_in({{"SLURM_PROCID", "7"}, {"SLURM_NTASKS", "8"}}) == Shard{7, 8});
  const Variables array{{"SLURM_ARRAY_TASK_ID", "7"},
                        {"SLURM_ARRAY_TASK_MIN", "1"},
                        {"SLURM_ARRAY_TASK_STEP", "2"},
                        {"SLURM_ARRAY_TASK_COUNT", "4"}};
  CHECK(shard_in(array) == Shard{3, 4});
  CHECK(shard_in({{"JOB_COMPLETION_INDEX", "4"}, {"JOB_COMPLETIONS", "5"}}) == Shard{4, 5});
}

TEST_CASE("each member of an array has all the ranks, and MPI's launchers are tasks of Slurm themselves") {
  Variables both{{"SLURM_ARRAY_TASK_ID", "2"},
                 {"SLURM_ARRAY_TASK_MIN", "0"},
                 {"SLURM_ARRAY_TASK_COUNT", "3"},
                 {"SLURM_PROCID", "1"},
                 {"SLURM_NTASKS", "4"}};
  CHECK(shard_in(both) == Shard{9, 12});
  both.insert({{"OMPI_COMM_WORLD_RANK", "5"}, {"OMPI_COMM_WORLD_SIZE", "6"}});
  CHECK(shard_in(both) == Shard{17, 18});
  // A script of an array without a number of tasks.
  CHECK(shard_in({{"SLURM_ARRAY_TASK_ID", "1"}, {"SLURM_ARRAY_TASK_COUNT", "3"}, {"SLURM_PROCID", "0"}}) ==
        Shard{1, 3});
}

TEST_CASE("no launcher, half of one, and two that contradict each other are refused by name") {
  CHECK(refusal_in({}).find("shard = env: must be started by Open MPI, MPICH, Slurm") == 0);
  CHECK(refusal_in({{"JOB_COMPLETION_INDEX", "4"}}).find("must find JOB_COMPLETIONS set") !=
        std::string::npos);
  CHECK(refusal_in({{"PMI_RANK", "2"}, {"PMI_SIZE", "2"}}).find("must find PMI_RANK below PMI_SIZE") !=
        std::string::npos);
  CHECK(refusal_in({{"PMI_RANK", "x"}, {"PMI_SIZE", "2"}}).find("whole number in PMI_RANK, where x is") !=
        std::string::npos);
  CHECK(refusal_in({{"OMPI_COMM_WORLD_RANK", "3"},
                    {"OMPI_COMM_WORLD_SIZE", "8"},
                    {"PMI_RANK", "1"},
                    {"PMI_SIZE", "8"}})
            .find("OMPI_COMM_WORLD_RANK and _SIZE say 4/8, PMI_RANK and PMI_SIZE say 2/8") !=
        std::string::npos);
  CHECK(refusal_in({{"SLURM_ARRAY_TASK_ID", "9"}, {"SLURM_ARRAY_TASK_COUNT", "3"}}).find("without gaps") !=
        std::string::npos);
}
