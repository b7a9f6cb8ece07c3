#include <nipref/fast/sheet/internal/dispatch.hpp>

namespace nipref::fast::internal {

const SheetCode* sheet_code_for(int instruction_set) {
  if (!has_instruction_set(instruction_set)) return nullptr;
#ifdef NIPREF_X86_LEVELS
  if (instruction_set == 1) return &v3::code;
  if (instruction_set == 2) return &v4::code;
#endif
  return &baseline::code;
}

constinit const SheetCode* best_sheet_code = &baseline::code;

namespace {
[[maybe_unused]] const bool upgraded = (best_sheet_code = sheet_code_for(best_instruction_set())) != nullptr;
}

}  // namespace nipref::fast::internal
