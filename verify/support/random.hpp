#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string_view>

namespace nipref::verify {

/// Reproducible random numbers: the same seed text gives the same numbers everywhere. The standard's distributions are
/// not used, because they differ between libraries.
class Random {
 public:
  /// The seed is a text, so that every quantity and every purpose has its own stream.
  explicit Random(std::string_view seed) : engine_(hash(seed)) {}

  /// Uniform in [0, 1).
  double uniform() { return std::ldexp(static_cast<double>(engine_() >> 11U), -53); }
  /// Uniform in [lower, upper).
  double uniform(double lower, double upper) { return lower + (upper - lower) * uniform(); }
  /// Log-uniform in [lower, upper), 0 < lower < upper.
  double log_uniform(double lower, double upper) {
    return std::exp(uniform(std::log(lower), std::log(upper)));
  }
  bool chance(double probability) { return uniform() < probability; }
  /// Uniform in {0, ..., count - 1}, count > 0.
  std::size_t index(std::size_t count) {
    return static_cast<std::size_t>(uniform() * static_cast<double>(count));
  }

 private:
  /// FNV-1a, because std::hash may differ between libraries.
  static std::uint64_t hash(std::string_view text) {
    std::uint64_t state = 0xcbf29ce484222325U;
    for (const char letter : text) state = (state ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
    return state;
  }

  std::mt19937_64 engine_;
};

}  // namespace nipref::verify
