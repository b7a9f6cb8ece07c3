#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/verify/golden/golden.hpp>

namespace nipref::verify {

enum class GoldenFault {
  wrong,         ///< the reference, or fast within its promise, does not meet the value
  useless,       ///< a bound so wide that nothing can be said
  text_changed,  ///< a file is not what its checksum says
  missing        ///< a quantity of the catalogue has no golden values
};

/// wrong, useless, text-changed, missing.
std::string_view name(GoldenFault fault);

struct GoldenFailure {
  GoldenFault fault;
  std::optional<std::size_t> row;  ///< counted from 1; none: of the file
  std::string what;                ///< one line
};

struct CheckOptions {
  /// Reference values are made anew at every row. Otherwise at a quarter as many rows, evenly taken and six at least, as
  /// the quantity has audit points, which are few where a value takes seconds.
  bool all = false;
  /// Of the rows every so many-th is looked at, > 0.
  std::size_t every = 1;
  std::function<void(double part)> progress = {};  ///< 0 to 1; may be empty
};

struct CheckedGolden {
  std::filesystem::path path;
  std::string quantity;        ///< empty if the file cannot be read
  std::size_t rows = 0;        ///< that were compared with fast
  std::size_t recomputed = 0;  ///< and with the reference
  bool hashed = false;         ///< there was a checksum
  std::vector<GoldenFailure> failures = {};

  [[nodiscard]] bool kept() const { return failures.empty(); }
};

/// Compares the values of a file with what is computed now. A row is wrong if the reference's value lies farther from
/// it than both bounds together, or fast's farther than promised; it is useless if the bounds are more than a
/// thousandth of a unit in the last place of the scale.
CheckedGolden check_rows(const Quantity& quantity, const GoldenFile& file, const CheckOptions& options);

/// The same of a file, its checksum first, which must be in SHA256SUMS beside it if there is one. A file that cannot be
/// read is text-changed if its checksum says so; otherwise BadInput.
CheckedGolden check_golden(const std::filesystem::path& path, const CheckOptions& options);

/// What the SHA256SUMS of the folder of golden values lists or lacks: files that are not there, and files that are not
/// listed.
std::vector<GoldenFailure> check_folder(const std::filesystem::path& folder);

/// Whether both numbers can be of one truth: their distance is at most the sum of their errors.
bool intersect(const ref::Estimate& a, const ref::Estimate& b);

}  // namespace nipref::verify
