#include <nipref/data/bad_input.hpp>
#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/fast/sheet/internal/dispatch.hpp>

namespace nipref::fast {

std::string_view instruction_set() { return internal::sheet_code().instruction_set; }

void use_instruction_set(std::string_view name) {
  std::string known;
  for (int number = 0; number < internal::instruction_set_count; ++number) {
    const internal::SheetCode* const code = internal::sheet_code_for(number);
    if (code == nullptr) continue;
    if (name == code->instruction_set) {
      internal::best_sheet_code = code;
      internal::chosen_instruction_set = number;
      return;
    }
    known += (known.empty() ? "" : " or ") + std::string(code->instruction_set);
  }
  throw data::BadInput("isa", name, "must be what this processor has: " + known);
}

}  // namespace nipref::fast
