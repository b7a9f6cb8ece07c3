#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace nipref::verify::host {

/// An array of doubles that is followed by a guard, protected memory. Before the array are sentinels, and before these
/// another guard. An access to a guard is recorded, and the program continues. The array exists until the process ends.
class GuardedArray {
 public:
  /// An array of up to protocol::most_points; `offence` is the protocol::Offences of an access outside of it.
  explicit GuardedArray(std::uint32_t offence);

  /// Makes the array one of `count` unwritten doubles and restores the guards and sentinels.
  std::span<double> fit(std::size_t count);

  /// The same array.
  [[nodiscard]] std::span<const double> array() const { return {end_ - count_, count_}; }

  /// Records the offence if a sentinel was overwritten.
  void check() const;

 private:
  double* end_;
  std::size_t count_ = 0;
  std::uint32_t offence_;
};

/// From now on accesses to guards are recorded; other memory faults still end the process.
void watch_guards();

/// The protocol::Offences that were recorded since the last call.
std::uint32_t offences_noted();

/// Records another offence.
void note_offence(std::uint32_t offence);

}  // namespace nipref::verify::host
