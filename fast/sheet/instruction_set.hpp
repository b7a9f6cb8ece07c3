#pragma once
#include <string_view>

namespace nipref::fast {

/// The instruction set whose code the sheet kernels run on this processor: "baseline", "v3" or "v4", the last
/// two being the levels x86-64-v3 (AVX2) and x86-64-v4 (AVX-512).
std::string_view instruction_set();

/// Makes the sheet kernels, and all other code that is compiled more than once, run the code for this instruction set
/// instead of the best, as another machine would. It must be called first, from one thread. BadInput "isa" for another
/// name, or for an instruction set that this processor lacks.
void use_instruction_set(std::string_view name);

}  // namespace nipref::fast
