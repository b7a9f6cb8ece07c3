#include <nipref/fast/number/internal/dense.hpp>

namespace nipref::fast::internal {

const DenseCode& dense_code() {
#ifdef NIPREF_X86_LEVELS
  if (chosen_instruction_set > 0) return v3::dense_code;
#endif
  return baseline::dense_code;
}

}  // namespace nipref::fast::internal
