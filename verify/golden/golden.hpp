#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nipref/ref/number/estimate.hpp>
#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// A value that was made once, confirmed by a second method, and is kept.
struct GoldenRow {
  Point arguments;
  std::string value;  ///< decimal text
  std::string bound;  ///< of |value - truth|, decimal text
  double scale;       ///< what errors of other values are measured against, unit of the quantity
  bool proven;        ///< whether bound is a proven one; otherwise it is an estimate
  std::string
      confirmed_by;    ///< the second method, and the largest distance from the value that it leaves open
  std::string origin;  ///< hard, worst:fast@COMMIT, dense or user

  /// The number that value is, with bound.
  [[nodiscard]] ref::Estimate number() const;
};

/// A file of golden values of one quantity.
struct GoldenFile {
  std::vector<std::pair<std::string, std::string>> header;  ///< keys and their texts, in their order
  std::vector<GoldenRow> rows;

  /// BadInput naming the key if it is not there.
  [[nodiscard]] const std::string& entry(const std::string& key) const;
  /// The quantity of the catalogue that the file is about; BadInput if it is none.
  [[nodiscard]] const Quantity& quantity() const;
  [[nodiscard]] int digits() const;
  void set(const std::string& key, const std::string& text);
};

/// A golden value out of what the reference says; `scale` as above. The rest is empty.
GoldenRow golden_row(const Quantity& quantity, const Point& point, const ref::Estimate& reference);

/// Text of a file as data/golden/README.md describes it.
std::string golden_text(const Quantity& quantity, const GoldenFile& file);

/// BadInput with file, line and column for what is not so.
GoldenFile read_golden(const std::filesystem::path& path);

/// Where the golden values of the quantity are: QUANTITY.csv of data/golden.
std::filesystem::path golden_path(const Quantity& quantity);

}  // namespace nipref::verify
