#pragma once
#include <string_view>

namespace nipref::fast {

/// The instruction set whose code the sheet kernels run on this processor: "baseline", "v3" or "v4", the last
/// two being the levels x86-64-v3 (AVX2) and x86-64-v4 (AVX-512).
std::string_view instruction_set();

}  // namespace nipref::fast
