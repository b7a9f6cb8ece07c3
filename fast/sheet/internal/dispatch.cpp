#include <nipref/fast/sheet/internal/dispatch.hpp>

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

const SheetCode* best_code() {
  int best = kInstructionSetCount - 1;
  while (sheet_code_for(best) == nullptr) --best;
  return sheet_code_for(best);
}

}  // namespace

constinit const SheetCode* best_sheet_code = &baseline::kCode;

namespace {
[[maybe_unused]] const bool upgraded = (best_sheet_code = best_code()) != nullptr;
}

}  // namespace nipref::fast::internal
