#include <nipref/fast/number/internal/instruction_level.hpp>

namespace nipref::fast::internal {

#ifdef NIPREF_X86_LEVELS
namespace {

// clang before version 17 does not know the names of the levels, so that with clang the features of a level are tested.
bool has_v3() {
#ifdef __clang__
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
         __builtin_cpu_supports("bmi2");
#else
  return __builtin_cpu_supports("x86-64-v3");
#endif
}

bool has_v4() {
#ifdef __clang__
  return has_v3() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl");
#else
  return __builtin_cpu_supports("x86-64-v4");
#endif
}

}  // namespace
#endif

bool has_instruction_set(int instruction_set) {
#ifdef NIPREF_X86_LEVELS
  __builtin_cpu_init();
  if (instruction_set == 1) return has_v3();
  if (instruction_set == 2) return has_v4();
#endif
  return instruction_set == 0;
}

constinit int chosen_instruction_set = 0;

namespace {

[[maybe_unused]] const bool upgraded = [] {
  int best = instruction_set_count - 1;
  while (!has_instruction_set(best)) --best;
  chosen_instruction_set = best;
  return best > 0;
}();

}  // namespace

}  // namespace nipref::fast::internal
