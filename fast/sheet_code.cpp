#include "fast/sheet_code.hpp"

namespace nipref::fast::internal {

const SheetCode* sheet_code_for(int instruction_set) {
  if (instruction_set == 0) return &baseline::kCode;
#ifdef NIPREF_X86_LEVELS
  __builtin_cpu_init();
  if (instruction_set == 1 && __builtin_cpu_supports("x86-64-v3")) return &v3::kCode;
  if (instruction_set == 2 && __builtin_cpu_supports("x86-64-v4")) return &v4::kCode;
#endif
  return nullptr;
}

namespace {

const SheetCode& best_code() {
  int best = kInstructionSetCount - 1;
  while (sheet_code_for(best) == nullptr) --best;
  return *sheet_code_for(best);
}

}  // namespace

const SheetCode& sheet_code() {
  static const SheetCode& chosen = best_code();
  return chosen;
}

}  // namespace nipref::fast::internal
