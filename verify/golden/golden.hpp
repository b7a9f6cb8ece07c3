#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nipref/data/table/csv.hpp>
#include <nipref/ref/number/estimate.hpp>
#include <nipref/verify/catalogue/arguments.hpp>

namespace nipref::verify {

/// The bound of the written value as text. It includes the rounding of the value to its text; the text of 0 is exact.
std::string bound_text(const ref::Estimate& reference);

struct GoldenNumber {
  std::string value;  ///< decimal text
  std::string bound;  ///< bound of |value - truth|, decimal text

  /// The number with its bound. It is a NaN if the text of the value is no number.
  [[nodiscard]] ref::Estimate number() const;
};

/// A row of a golden file: the value of a quantity at a point, or all results of a contact, confirmed by other methods.
struct GoldenRow {
  Point arguments;   ///< for a quantity
  Assignments keys;  ///< for a contact: the keys that the sweep varies, with their values
  /// The value of the quantity, or the results of the contact in the order in which the scene wants them.
  std::vector<GoldenNumber> numbers;
  bool proven;               ///< whether all bounds are proven; otherwise some are estimates
  std::string confirmed_by;  ///< the methods, and how closely each confirms the numbers
  // Only for a quantity:
  double scale = 0;         ///< the size against which errors are measured, unit of the quantity
  std::string origin = {};  ///< hard, worst:fast@COMMIT, dense or user

  [[nodiscard]] ref::Estimate number() const { return numbers.front().number(); }  ///< the quantity's value
};

struct GoldenHeader {
  std::vector<std::pair<std::string, std::string>> header;  ///< keys and texts, in the file's order

  /// The text of a key. BadInput that names the key if the header lacks it.
  [[nodiscard]] const std::string& entry(const std::string& key) const;
  [[nodiscard]] int digits() const;
  void set(const std::string& key, const std::string& text);
  [[nodiscard]] std::string header_text() const;
};

/// The header of a file. BadInput with line and column of a comment that is not an entry.
GoldenHeader header_of(const data::CsvFile& csv);

// The fields of files of values. BadInput with line and column of a field that does not hold such a number.

/// A double, decimal or hexadecimal. It must be finite; with `may_be_none` it may also be an infinity or a NaN.
double double_of(const std::filesystem::path& path, const data::CsvField& field, bool may_be_none = false);
/// The value of an argument: a finite double, or the index of a choice.
double argument_of(const std::filesystem::path& path, const Argument& argument, const data::CsvField& field);

/// A file of golden values of one quantity, or of contacts of one kind.
struct GoldenFile : GoldenHeader {
  std::vector<GoldenRow> rows;
  std::vector<std::string> results = {};  ///< names of the contacts' results; empty for a quantity

  /// The quantity whose values the file holds. BadInput if the catalogue has none of that name.
  [[nodiscard]] const Quantity& quantity() const;
};

/// A golden value from the reference's estimate, without a confirmation and an origin.
GoldenRow golden_row(const Quantity& quantity, const Point& point, const ref::Estimate& reference);

/// |a - b|, and the sum of the errors of both, rounded upwards.
struct Gap {
  ref::Float distance, allowed;

  Gap(const ref::Estimate& a, const ref::Estimate& b);
  /// Whether the distance is at most the allowed one, so that both may stand for one number; false for a NaN.
  [[nodiscard]] bool is_covered() const;
};

/// Whether a width is small against the scale: at most a thousandth of a unit in the last place.
bool is_small(const ref::Float& width, double scale);

/// The text of the number with two digits, rounded upwards.
std::string upward_text(const ref::Float& number);

/// The text of a file, as data/golden/README.md describes it.
std::string golden_text(const GoldenFile& file);

/// Reads such a file. BadInput that names file, line and column of the first fault.
GoldenFile read_golden(const std::filesystem::path& path);

/// The file of the golden values of a quantity or of a kind of contacts: data/golden/NAME.csv.
std::filesystem::path golden_path(std::string_view name);

/// A version of all golden values, for others to pin: the SHA-256 of SHA256SUMS; empty if there is no such file.
std::string golden_version();

/// A golden file of any kind as csv, json, cpp or npy, for programs that do not read the CSV. Numbers are rounded to
/// the nearest double, bounds are rounded upwards. BadInput for what read_csv refuses.
std::string exported_golden(const std::filesystem::path& path, std::string_view format);

}  // namespace nipref::verify
