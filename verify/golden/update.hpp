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
  GoldenFile file;  ///< as it should be
  std::vector<ChangedRow> changed;
  std::vector<RefusedRow>
      refused;  ///< what should change to them is confirmed by no second method: they stay
};

/// Computes all values of the file again. Rows change whose value the reference's of now does not meet, whose status
/// or scale is another, or, with `all`, every one. Each changed row is confirmed by a second method. Throws Interrupted
/// if the process is.
UpdatedGolden update_golden(const Quantity& quantity, const GoldenFile& file, bool all,
                            const Provenance& provenance, const std::function<void(double part)>& progress);

}  // namespace nipref::verify
