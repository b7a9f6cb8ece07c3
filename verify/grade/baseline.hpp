#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nipref::verify {

/// The properties that two measurements must have in common to be comparable. The folder of a file is not among them.
struct BaselineKey {
  std::string what;  ///< what was graded: the name of a file, or the names of a kernel and its file
  std::string quantity;
  std::string where;  ///< the ranges, or a file of points
  std::string seed;
  std::size_t points;
  int sampler;           ///< the number of the algorithm that chooses points
  std::string compiler;  ///< of this program; its rounding errors depend on it
  std::string instruction_set;

  bool operator==(const BaselineKey&) const = default;
};

/// Errors of earlier measurements, in a TOML file.
struct Baseline {
  struct Entry {
    BaselineKey key;
    double max_error_ulp;
    std::string reason;  ///< why it was raised last; empty if it was never raised
  };
  std::vector<Entry> entries;

  /// Reads the file. BadInput as of input_file.hpp if this fails; for wrong contents it names line and key.
  static Baseline read(const std::string& path);
  [[nodiscard]] std::string text() const;
};

struct BaselineComparison {
  /// "not worse"; "WORSE" if the error exceeds 1.5 times the earlier one plus 0.25 ulp; "not comparable" if no entry
  /// has the key.
  std::string_view verdict;
  std::string words;  ///< one line: the earlier error, or the part of the key that differs

  [[nodiscard]] bool kept() const { return verdict == "not worse"; }
};

/// Compares the largest error with the earlier one of the same key.
BaselineComparison compare_with(const Baseline& baseline, const BaselineKey& key, double max_error_ulp);

/// Adds an entry, or lowers its error. Raises the error only with a reason, which is stored; without one the entry
/// stays as it is, and the result is false if the error is WORSE.
bool update(Baseline& baseline, const BaselineKey& key, double max_error_ulp,
            const std::optional<std::string>& reason);

}  // namespace nipref::verify
