#pragma once

// Some arithmetic is compiled once for each of several instruction sets. When the program starts, this file chooses the
// instruction set whose code runs.

namespace nipref::fast::internal {

/// The instruction sets in ascending order: that of every processor, and the levels x86-64-v3 and x86-64-v4.
inline constexpr int instruction_set_count = 3;

/// Whether this processor has the whole instruction set, and code for it was compiled.
bool has_instruction_set(int instruction_set);

/// The instruction set whose code runs: the best one, unless use_instruction_set() was called. Until the static objects
/// of this library are initialised it is 0, which every processor has, so that calls need no guard.
extern constinit int chosen_instruction_set;

}  // namespace nipref::fast::internal
