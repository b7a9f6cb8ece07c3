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

/// The bound of the value that is written, with the rounding to its text. The text of the value 0 is not rounded.
std::string bound_text(const ref::Estimate& reference);

/// A stored number.
struct GoldenNumber {
  std::string value;  ///< decimal text
  std::string bound;  ///< of |value - truth|, decimal text

  /// The number that these texts are. The text of a value that is none is a NaN.
  [[nodiscard]] ref::Estimate number() const;
};

/// What is stored of a point, a value of a quantity or all results of a contact, which other methods have confirmed.
struct GoldenRow {
  Point arguments;   ///< of a quantity
  Assignments keys;  ///< of a contact's scene, as its sweep has them
  /// One, or those of the results in the order in which the scene wants them.
  std::vector<GoldenNumber> numbers;
  bool proven;               ///< whether all bounds are; otherwise some are estimates
  std::string confirmed_by;  ///< the methods, and how far they leave a number open
  // Of a quantity:
  double scale = 0;         ///< what errors of other values are measured against, unit of the quantity
  std::string origin = {};  ///< hard, worst:fast@COMMIT, dense or user

  [[nodiscard]] ref::Estimate number() const { return numbers.front().number(); }  ///< of a quantity
};

/// What stands above the values of a file.
struct GoldenHeader {
  std::vector<std::pair<std::string, std::string>> header;  ///< keys and their texts, in their order

  /// BadInput naming the key if it is not there.
  [[nodiscard]] const std::string& entry(const std::string& key) const;
  [[nodiscard]] int digits() const;
  void set(const std::string& key, const std::string& text);
  [[nodiscard]] std::string header_text() const;
};

/// The header of a file that was read. BadInput with line and column of what is no entry.
GoldenHeader header_of(const data::CsvFile& csv);

// What files of values hold. BadInput with line and column of what is not there.

/// A double, decimal or hexadecimal, which is finite or, if it `may_be_none`, also an infinity or a NaN.
double double_of(const std::filesystem::path& path, const data::CsvField& field, bool may_be_none = false);
/// The number that stands for an argument.
double argument_of(const std::filesystem::path& path, const Argument& argument, const data::CsvField& field);

/// A file of golden values of one quantity, or of contacts of one kind.
struct GoldenFile : GoldenHeader {
  std::vector<GoldenRow> rows;
  std::vector<std::string> results = {};  ///< names of those of contacts

  /// The quantity whose values the file holds. BadInput if the catalogue has none of that name.
  [[nodiscard]] const Quantity& quantity() const;
};

/// A golden value from the reference's estimate, without a confirmation and an origin.
GoldenRow golden_row(const Quantity& quantity, const Point& point, const ref::Estimate& reference);

/// |a - b|, and the sum of the errors of both, rounded upwards.
struct Gap {
  ref::Float distance, allowed;

  Gap(const ref::Estimate& a, const ref::Estimate& b);
  /// Whether both may stand for one number; a NaN may not.
  [[nodiscard]] bool is_covered() const;
};

/// Whether a width is small against the scale: at most a thousandth of a unit in the last place.
bool is_small(const ref::Float& width, double scale);

/// Two digits, rounded upwards.
std::string upward_text(const ref::Float& number);

/// The text of a file, as data/golden/README.md describes it.
std::string golden_text(const GoldenFile& file);

/// Reads such a file. BadInput that names file, line and column of the first fault.
GoldenFile read_golden(const std::filesystem::path& path);

/// The file of the golden values of a quantity or of a kind of contacts: data/golden/NAME.csv.
std::filesystem::path golden_path(std::string_view name);

/// What to pin: the SHA-256 of SHA256SUMS, and so of all golden values; empty if there is none.
std::string golden_version();

/// A golden file of any kind as csv, json, cpp or npy, for programs that do not read the CSV. Numbers are the doubles
/// nearest to the texts, bounds those above. BadInput as read_csv has it.
std::string exported_golden(const std::filesystem::path& path, std::string_view format);

}  // namespace nipref::verify
