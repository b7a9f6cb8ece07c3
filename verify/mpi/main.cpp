// nipref-mpi audit ...: `nipref audit` by all ranks of an MPI job.
#include <mpi.h>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/mpi/ranks.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>

namespace {

using namespace nipref;

struct Rank {
  int number = 0, of = 1;

  Rank() {
    MPI_Comm_rank(MPI_COMM_WORLD, &number);
    MPI_Comm_size(MPI_COMM_WORLD, &of);
  }
};

void check_verb(const verify::CommandLine& line) {
  if (line.verb != "audit" || line.help || line.version)
    throw data::BadInput("verb", line.verb, "must be audit: nipref itself does all else, and has the help");
  verify::refuse_option(line, "shard", "must be left out: ranks share a run as they come");
}

int lead(const verify::CommandLine& line, int ranks, std::ostream& out) {
  check_verb(line);
  if (ranks == 1) return verify::audit_verb(line, out);
  verify::Progress progress(line.has("quiet"));
  verify::AuditRun run(line);
  verify::hand_out_blocks(run, ranks, progress);
  return run.answer(out);
}

/// Only rank 0 reports a wrong command line.
int follow(int argc, const char* const* argv) try {
  const verify::CommandLine line = verify::parse_command_line(argc, argv);
  check_verb(line);
  verify::stop_gently_on_interrupt();
  verify::do_blocks_of_ranks(verify::AuditWorks(line, false).all());
  return 0;
} catch (const data::BadInput&) {
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const Rank rank;
  const int status = rank.number > 0 ? follow(argc, argv)
                                     : verify::program_status(argc, argv, [&](const auto& line, auto& out) {
                                         return lead(line, rank.of, out);
                                       });
  MPI_Finalize();
  return status;
}
