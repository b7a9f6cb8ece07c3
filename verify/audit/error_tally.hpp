#pragma once
#include <gmpxx.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

namespace nipref::verify {

/// A histogram of numbers >= 0 and their sum. Both are the same to the last bit for any order of the numbers and any
/// division into tallies that are added. One bin holds all numbers up to 2^-6; above there are 32 bins in each octave.
class ErrorTally {
 public:
  /// The number may be infinite, but not a NaN.
  void add(double number);
  void add(const ErrorTally& more);

  [[nodiscard]] std::uint64_t count() const;
  /// The mean, at most 2^-32 too large; infinite if a number is infinite. There must be a number.
  [[nodiscard]] double mean() const;
  /// The percentile, rounded up to the end of its bin, but at most the largest number. There must be a number.
  [[nodiscard]] double percentile(double share) const;

  /// See stored.hpp.
  static void members(auto& self, const auto& each) {
    each("largest", self.largest_, "sum", self.sum_, "bins", self.bins_);
  }

  bool operator==(const ErrorTally&) const = default;

 private:
  double largest_ = 0;
  mpz_class sum_;                      ///< in units of 2^-32, each number rounded up
  std::map<int, std::uint64_t> bins_;  ///< counts, by number of the bin
};

/// Whether no promise is broken. A finding without a reference value to compare with breaks none.
template <class Found>
bool all_kept(const std::vector<Found>& all) {
  return std::ranges::none_of(all, [](const Found& one) { return one.kept() == false; });
}

}  // namespace nipref::verify
