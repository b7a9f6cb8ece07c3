#pragma once
#include <nipref/verify/cli/audit_run.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {

// An audit by the ranks of an MPI job: rank 0 hands blocks out, one at a time to whoever has none, and takes back what was
// found in them; the others do them. So slow blocks are balanced, and a job that ends with one of its ranks, as MPI has it,
// loses the blocks that were being done: with --out the same command goes on.

/// On rank 0, until all blocks are kept or the process is interrupted; all other ranks have left do_blocks_of_ranks() then,
/// whatever is thrown. BadInput for what a rank threw as that; std::runtime_error for all else.
void hand_out_blocks(AuditRun& run, int ranks, Progress& progress);

/// On the other ranks, until rank 0 has nothing left: works are those of the same command line.
void do_blocks_of_ranks(const std::vector<BlockWork*>& works);

}  // namespace nipref::verify
