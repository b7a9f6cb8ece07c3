#pragma once

// The sheet arithmetic is compiled once for each instruction set (arithmetic/sheet_code.cpp); this is the
// table of its entry points. They expect checked arguments: finite, and not 0 where the component is
// infinite.

#include <stddef.h>

#include "fast/sheet_domain.hpp"
#include "fast/sheet_tables.hpp"

namespace nipref::fast::internal {

inline constexpr int kBatchComponents = 5;   ///< I1, I3, I4, I5, I7
inline constexpr int kScalarComponents = 6;  ///< and eta_part_of_I6

struct SheetCode {
  const char* instruction_set;
  bool (*all_in_domain)(const double*, size_t, Domain);
  double (*scalar[kScalarComponents][kTierCount])(double);
  void (*batch[kBatchComponents][kTierCount])(const double*, double*, size_t);
  double (*scalar_i6[kTierCount])(double, double);
  void (*batch_i6[kTierCount])(const double*, const double*, double*, size_t);
};

namespace baseline {
extern const SheetCode kCode;
}
namespace v3 {
extern const SheetCode kCode;
}
namespace v4 {
extern const SheetCode kCode;
}

/// From the plainest to the best.
inline constexpr int kInstructionSetCount = 3;

/// The code for an instruction set, or null where this processor does not have it.
const SheetCode* sheet_code_for(int instruction_set);

/// The code for the best instruction set of this processor. Before this library's static objects are
/// initialised it may be the baseline's, so that calls need no guard.
extern constinit const SheetCode* best_sheet_code;
inline const SheetCode& sheet_code() { return *best_sheet_code; }

}  // namespace nipref::fast::internal
