#include <nipref/fast/sheet/internal/dispatch.hpp>

namespace nipref::fast::internal {

const SheetCode* const sheet_codes[instruction_set_count] = {
#ifdef NIPREF_X86_LEVELS
    &baseline::code, &v3::code, &v4::code
#else
    &baseline::code
#endif
};

}  // namespace nipref::fast::internal
