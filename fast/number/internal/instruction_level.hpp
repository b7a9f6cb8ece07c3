#pragma once

// Some arithmetic is compiled more than once, for processors that have more instructions. Which of it runs is chosen
// here, once for all of it, when the program starts.

namespace nipref::fast::internal {

/// From the plainest to the best: what every processor has, and the levels x86-64-v3 and x86-64-v4.
inline constexpr int instruction_set_count = 3;

/// Whether this processor has all of that one, and code for it was compiled.
bool has_instruction_set(int instruction_set);

/// The best of this processor.
int best_instruction_set();

/// Whose code runs: the best of this processor's unless use_instruction_set() was called. Before this library's static
/// objects are initialised it may be 0, so that calls need no guard.
extern constinit int chosen_instruction_set;

}  // namespace nipref::fast::internal
