#include <nipref/fast/sheet/internal/dispatch.hpp>

namespace nipref::fast::internal {

const SheetCode* sheet_code_for(int instruction_set) {
  if (instruction_set == 0) return &baseline::code;
#ifdef NIPREF_X86_LEVELS
  __builtin_cpu_init();
  if (instruction_set == 1 && __builtin_cpu_supports("x86-64-v3")) return &v3::code;
  if (instruction_set == 2 && __builtin_cpu_supports("x86-64-v4")) return &v4::code;
#endif
  return nullptr;
}

namespace {

const SheetCode* best_code() {
  int best = instruction_set_count - 1;
  while (sheet_code_for(best) == nullptr) --best;
  return sheet_code_for(best);
}

}  // namespace

constinit const SheetCode* best_sheet_code = &baseline::code;

namespace {
[[maybe_unused]] const bool upgraded = (best_sheet_code = best_code()) != nullptr;
}

}  // namespace nipref::fast::internal
