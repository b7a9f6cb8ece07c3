#pragma once
#include <nipref/verify/cli/audit_run.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {

// An audit by the ranks of an MPI job. Rank 0 gives each idle rank one block and receives its findings, so that slow
// blocks are balanced. If a rank fails, MPI ends the whole job, which loses the blocks in progress only: with --out
// the same command continues the audit.

/// The part of rank 0. It returns when all blocks are finished or the process is interrupted. All other ranks have
/// left do_blocks_of_ranks() then, also if it throws: BadInput if a rank threw BadInput, std::runtime_error for other
/// errors.
void hand_out_blocks(AuditRun& run, int ranks, Progress& progress);

/// The part of the other ranks, until rank 0 has no more blocks. The works are those of the same command line.
void do_blocks_of_ranks(const std::vector<BlockWork*>& works);

}  // namespace nipref::verify
