#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace nipref::verify::host {

/// An array of doubles that ends where memory ends that nobody may touch; in front of it lie sentinels, and before
/// those such memory again. Who touches that is noted and goes on. Lives as long as the process.
class GuardedArray {
 public:
  /// Of up to protocol::most_points; `offence`, of protocol::Offences, is what touching too much of it is called.
  explicit GuardedArray(std::uint32_t offence);

  /// The array of `count` doubles, none of them written yet, the guards and sentinels as new.
  std::span<double> fit(std::size_t count);

  /// The same array as it is.
  [[nodiscard]] std::span<const double> array() const { return {end_ - count_, count_}; }

  /// Notes it if the sentinels before the array were written.
  void check() const;

 private:
  double* end_;
  std::size_t count_ = 0;
  std::uint32_t offence_;
};

/// From here on touching a guard is noted; other faults end the process as ever.
void watch_guards();

/// What was noted since the last call, of protocol::Offences.
std::uint32_t offences_noted();

/// Notes more.
void note_offence(std::uint32_t offence);

}  // namespace nipref::verify::host
