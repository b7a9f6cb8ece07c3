#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace nipref::verify {

/// What two measurements must share to be comparable. Folders are no part of it: a checkout may be anywhere.
struct BaselineKey {
  std::string what;  ///< that was graded: a file's name, of a kernel its own name and that of its file
  std::string quantity;
  std::string where;  ///< the ranges, or a file of points
  std::string seed;
  std::size_t points;
  int sampler;           ///< number of the way in which points are chosen
  std::string compiler;  ///< of this program, and with it the way it rounds
  std::string instruction_set;

  bool operator==(const BaselineKey&) const = default;
};

/// Errors that were found earlier, in a TOML file.
struct Baseline {
  struct Entry {
    BaselineKey key;
    double max_error_ulp;
    std::string reason;  ///< why it was raised last; empty: never
  };
  std::vector<Entry> entries;

  /// BadInput for a file that cannot be read, as input_file.hpp has it, and naming line and key for what is not so.
  static Baseline read(const std::string& path);
  [[nodiscard]] std::string text() const;
};

enum class Comparison {
  not_worse,
  worse,          ///< above 1.5 times what it was and 0.25 ulp more
  not_comparable  ///< no entry has this key
};

struct BaselineComparison {
  Comparison comparison;
  std::string words;  ///< one line: what it was, or which part of the key is another
};

/// Compares the largest error found with that of the same key.
BaselineComparison compare_with(const Baseline& baseline, const BaselineKey& key, double max_error_ulp);

/// Adds an entry, or lowers it; raises it only if there is a reason, which is kept. False if it would have to be
/// raised and there is none.
bool update(Baseline& baseline, const BaselineKey& key, double max_error_ulp,
            const std::optional<std::string>& reason);

}  // namespace nipref::verify
