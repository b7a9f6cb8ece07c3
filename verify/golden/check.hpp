#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/verify/golden/golden.hpp>
#include <nipref/verify/support/json.hpp>
#include <nipref/verify/support/on_progress.hpp>
#include <nipref/verify/support/sha256.hpp>

namespace nipref::verify {

/// SHA-256 digests by file name, as a folder's SHA256SUMS lists them in the format of sha256sum.
using Checksums = std::map<std::string, std::string>;

/// Reads the folder's SHA256SUMS; empty if there is none. BadInput if the file has another format.
Checksums checksums_of(const std::filesystem::path& folder);
std::string checksums_text(const Checksums& sums);

inline constexpr auto checksums_name = "SHA256SUMS";

enum class GoldenFault {
  wrong,         ///< the reference's value, or fast's, contradicts the golden value
  too_wide,      ///< the bounds are too wide for a comparison
  text_changed,  ///< a file does not have its checksum
  missing        ///< a quantity of the catalogue has no golden values
};

/// The name of the fault: wrong, too-wide, text-changed, missing.
std::string_view name(GoldenFault fault);

struct GoldenFailure {
  GoldenFault fault;
  std::optional<std::size_t> row;  ///< counted from 1; nothing for a fault of the whole file
  std::string what;                ///< one line
};

struct CheckOptions {
  /// Whether the reference computes the values of all rows again. Otherwise it computes evenly spaced rows, a quarter
  /// as many as the quantity has audit points, but at least six; slow quantities have few audit points.
  bool all = false;
  std::size_t every = 1;  ///< > 0; one row of each group of `every` rows is compared
  OnProgress progress = {};
};

struct CheckedGolden {
  std::filesystem::path path;
  std::string quantity;        ///< empty if the file cannot be read
  std::size_t rows = 0;        ///< number of rows compared with fast
  std::size_t recomputed = 0;  ///< number of rows compared with the reference
  bool hashed = false;         ///< whether the file has a checksum
  std::vector<GoldenFailure> failures = {};

  [[nodiscard]] bool kept() const { return failures.empty(); }
};

/// Calls `check` for one row of each group of `options.every` rows, and asks it to compare with the reference in
/// `by_ref` of these calls, evenly spaced, or in all of them with `options.all`.
CheckedGolden checked_rows(
    const GoldenHeader& file, std::size_t rows, std::size_t by_ref, const CheckOptions& options,
    const std::function<std::vector<GoldenFailure>(std::size_t row, bool by_ref)>& check);

/// Computes the values of a file again and compares. A row is wrong if the reference's value differs from it by more
/// than the sum of both bounds, or fast's value by more than its promise. A row is too wide if the bounds exceed a
/// thousandth of a unit in the last place of the scale.
CheckedGolden check_rows(const Quantity& quantity, const GoldenFile& file, const CheckOptions& options);

/// Checks a file of a quantity or of contacts: first its checksum, if the folder's SHA256SUMS has one, and then its
/// rows. If the file cannot be read, the result is text-changed where the checksum is wrong; otherwise BadInput.
CheckedGolden check_golden(const std::filesystem::path& path, const CheckOptions& options);

/// The files that the folder's SHA256SUMS lists but that do not exist, and the golden files that it does not list.
std::vector<GoldenFailure> check_folder(const std::filesystem::path& folder);

/// Whether the i-th of `count` items is among `wanted` evenly spaced ones.
inline bool is_taken(std::size_t i, std::size_t count, std::size_t wanted) {
  return wanted >= count || (i * wanted) / count != ((i + 1) * wanted) / count;
}

Json failure_json(const GoldenFailure& failure);
Json checked_file_json(const CheckedGolden& file);

}  // namespace nipref::verify
