#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/fast/sheet/internal/dispatch.hpp>

namespace nipref::fast {

std::string_view instruction_set() { return internal::sheet_code().instruction_set; }

}  // namespace nipref::fast
