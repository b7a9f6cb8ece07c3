#pragma once
#include <string>
#include <vector>

#include <nipref/verify/golden/make.hpp>

namespace nipref::verify {

struct ChangedRow {
  std::size_t row;  ///< counted from 1
  GoldenRow before, after;
  std::string why;
};

struct UpdatedGolden {
  GoldenFile file;  ///< with the changed rows
  std::vector<ChangedRow> changed;
  std::vector<RefusedRow>
      refused;  ///< rows that stay as they are because no second method confirms their new values
};

/// Computes all values of the file again. A row changes if the reference's new value contradicts its value, if its
/// status or scale differs, or, with `all`, in any case. A second method confirms each changed row. Throws
/// Interrupted if the process is interrupted.
UpdatedGolden update_golden(const Quantity& quantity, const GoldenFile& file, bool all,
                            const Provenance& provenance, const OnProgress& progress);

}  // namespace nipref::verify
