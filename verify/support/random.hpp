#pragma once
#include <cstddef>
#include <cstdint>
#include <random>
#include <string_view>

namespace nipref::verify {

/// Reproducible random numbers: the same seed text gives the same points everywhere. The standard's distributions are not
/// used, since they differ between libraries.
class Random {
 public:
  /// The seed is a text, so that every quantity and every purpose has its own stream.
  explicit Random(std::string_view seed);

  /// Uniform in [0, 1).
  double uniform();
  /// Uniform in [lower, upper).
  double uniform(double lower, double upper);
  /// Log-uniform in [lower, upper), 0 < lower < upper.
  double log_uniform(double lower, double upper);
  /// True with the given probability.
  bool chance(double probability);
  /// Uniform in {0, ..., count - 1}, count > 0.
  std::size_t index(std::size_t count);

 private:
  std::mt19937_64 engine_;
};

}  // namespace nipref::verify
