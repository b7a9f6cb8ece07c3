#include <nipref/data/bad_input.hpp>
#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/fast/sheet/internal/dispatch.hpp>

namespace nipref::fast {

const internal::SheetCode* const internal::sheet_codes[instruction_set_count] = {
#ifdef NIPREF_X86_LEVELS
    &baseline::code, &v3::code, &v4::code
#else
    &baseline::code
#endif
};

std::string_view instruction_set() { return internal::sheet_code().instruction_set; }

void use_instruction_set(std::string_view name) {
  std::string known;
  for (int number = 0; number < internal::instruction_set_count; ++number) {
    if (!internal::has_instruction_set(number)) continue;
    const char* const known_name = internal::sheet_codes[number]->instruction_set;
    if (name == known_name) {
      internal::chosen_instruction_set = number;
      return;
    }
    known += (known.empty() ? "" : " or ") + std::string(known_name);
  }
  throw data::BadInput("isa", name, "must be what this processor has: " + known);
}

}  // namespace nipref::fast
