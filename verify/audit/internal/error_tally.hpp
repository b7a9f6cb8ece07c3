#pragma once
#include <gmpxx.h>

#include <cstdint>
#include <map>

#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// How many numbers >= 0 lie where, and their sum: whatever the order in which they come, and however they are split
/// into tallies that are added up, it is the same to the last bit. Thirty-two bins an octave from 2^-6 on, one below.
class ErrorTally {
 public:
  /// Infinity counts as one; no NaN.
  void add(double number);
  void add(const ErrorTally& more);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// 2^-32 too large at most; infinite if a number is. Of one number at least.
  [[nodiscard]] double mean() const;
  /// At least this share of the numbers does not exceed it: a thirty-second more, or 2^-6, than the smallest of them of
  /// which that is so at most, and no more than the largest. Of one number at least.
  [[nodiscard]] double percentile(double share) const;

  [[nodiscard]] Json json() const;
  /// Of what json() gave. JsonMisfit for anything else.
  static ErrorTally of(const Json& json);

  bool operator==(const ErrorTally&) const = default;

 private:
  std::uint64_t count_ = 0;
  double largest_ = 0;
  mpz_class sum_;                      ///< in units of 2^-32, each number rounded up
  std::map<int, std::uint64_t> bins_;  ///< by number
};

}  // namespace nipref::verify
