#pragma once
#include <string_view>

namespace nipref::fast {

/// The instruction set whose code the sheet kernels run on this processor: "baseline", "v3" or "v4", the last
/// two being the levels x86-64-v3 (AVX2) and x86-64-v4 (AVX-512).
std::string_view instruction_set();

/// Has the sheet kernels, and all else that is compiled more than once, run the code of that one instead of the best, as
/// another machine would. To be called before
/// anything else is, from one thread. BadInput naming "isa" for another name, or one that this processor does not
/// have.
void use_instruction_set(std::string_view name);

}  // namespace nipref::fast
