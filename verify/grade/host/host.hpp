#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nipref/verify/grade/internal/exchange.hpp>
#include <nipref/verify/grade/kernel.h>

// The parts of nipref-kernel-host.

namespace nipref::verify::host {

/// A kernel and its state.
struct Kernel {
  nipref_kernel entry{};
  void* state = nullptr;

  [[nodiscard]] int evaluate(std::span<const double* const> arguments, std::span<double> out) const {
    return entry.evaluate(state, out.size(), arguments.data(), out.data());
  }
};

/// Loads the file and gives the kernels that it lists, or the one function `symbol` of `arity` doubles, whose
/// name is not copied; "" for the list.
/// std::runtime_error saying in one line why there are none.
std::vector<Kernel> load_kernels(const std::string& file, const char* symbol, std::uint32_t arity,
                                 std::uint32_t flags);

/// An array of doubles between two guards, which are protected memory; the room that it leaves is filled with
/// sentinels. An access to a guard is noted, and the program continues. There can be a set of arrays for each of the
/// threads; they exist until the process ends.
class GuardedArray {
 public:
  /// An array of up to protocol::most_points; `offence` is the protocol::Noticed of an access outside of it.
  explicit GuardedArray(std::uint32_t offence);

  /// Makes the array one of `count` unwritten doubles and restores the guards and sentinels.
  std::span<double> fit(std::size_t count);

  /// The same array.
  [[nodiscard]] std::span<const double> array() const { return {end_ - count_, count_}; }

  /// Notes the offence if a sentinel was overwritten.
  void check() const;

 private:
  std::size_t place_;
  double* end_;
  std::size_t count_ = 0;
};

inline constexpr std::size_t thread_count = 4;

/// From now on accesses to guards are noted; other memory faults still end the process.
void watch_guards();

/// The offences that were noted since the last call, of protocol::Noticed.
std::uint32_t offences_noted();

void note_offence(std::uint32_t offence);

}  // namespace nipref::verify::host
