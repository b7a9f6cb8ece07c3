#pragma once
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <csignal>
#include <cstdint>
#include <new>
#include <span>

#include <nipref/verify/grade/internal/exchange.hpp>

namespace nipref::verify::host {

inline constexpr std::size_t thread_count = 4;

// Each array has its place in one piece of memory: a guard, room for sentinels and the array, and a guard.
inline constexpr std::size_t guard_size = 0x10000, room = 0x10000;  // multiples of all page sizes
inline constexpr std::size_t place_size = room + 2 * guard_size;
inline constexpr std::size_t most_places = thread_count * (protocol::most_arguments + 1);
inline constexpr std::size_t sentinels = 64;
static_assert(room >= (protocol::most_points + sentinels) * sizeof(double));

// A signal handler reads these variables, which must need neither locks nor an allocation.
inline char* memory = nullptr;
inline std::array<std::uint32_t, most_places> offences;
inline std::array<std::atomic<bool>, most_places> opened;
inline std::atomic<std::uint32_t> noted = 0;

inline bool open_guards(std::size_t place) {
  opened[place] = true;
  return mprotect(memory + place * place_size, place_size, PROT_READ | PROT_WRITE) == 0;
}

inline void close_guards(std::size_t place) {
  for (char* const guard : {memory + place * place_size, memory + (place + 1) * place_size - guard_size}) {
    std::fill_n(guard, guard_size, '\0');
    mprotect(guard, guard_size, PROT_NONE);
  }
}

/// Returns the offences noted since the last call, as bits of protocol::Noticed.
inline std::uint32_t offences_noted() { return noted.exchange(0); }
inline void note_offence(std::uint32_t offence) { noted |= offence; }

/// An array of doubles between two guards, which are protected memory; the room that it leaves is filled with
/// sentinels. An access to a guard is noted, and the program continues. There can be a set of arrays for each of the
/// threads; they exist until the process ends.
class GuardedArray {
 public:
  /// An array of up to protocol::most_points; `offence` is the protocol::Noticed of an access outside of it.
  explicit GuardedArray(std::uint32_t offence)
      : place_(static_cast<std::size_t>(std::ranges::find(offences, 0U) - offences.begin())) {
    if (place_ == most_places || !open_guards(place_)) throw std::bad_alloc();
    offences[place_] = offence;
    end_ = reinterpret_cast<double*>(memory + (place_ + 1) * place_size - guard_size);
  }

  /// Resizes the array to `count` unwritten doubles, and restores the guards and sentinels.
  std::span<double> fit(std::size_t count) {
    if (opened[place_].exchange(false)) close_guards(place_);
    count_ = count;
    std::fill_n(end_ - count - sentinels, count + sentinels, std::bit_cast<double>(protocol::unwritten_bits));
    return {end_ - count, count};
  }

  /// The array that fit() has returned.
  [[nodiscard]] std::span<const double> array() const { return {end_ - count_, count_}; }

  /// Notes the offence if a sentinel was overwritten.
  void check() const {
    const double* const array = end_ - count_;
    if (std::any_of(array - sentinels, array, [](const double& sentinel) {
          return std::bit_cast<std::uint64_t>(sentinel) != protocol::unwritten_bits;
        }))
      note_offence(offences[place_]);
  }

 private:
  std::size_t place_;
  double* end_;
  std::size_t count_ = 0;
};

inline void on_fault(int signal, siginfo_t* what, void*) {
  const auto place = static_cast<std::size_t>(static_cast<char*>(what->si_addr) - memory) / place_size;
  if (place < most_places && offences[place] != 0 && open_guards(place)) return note_offence(offences[place]);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// From now on accesses to guards are noted; other memory faults still end the process.
inline void watch_guards() {
  void* const reserved =
      mmap(nullptr, most_places * place_size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (reserved == MAP_FAILED) throw std::bad_alloc();
  memory = static_cast<char*>(reserved);
  static std::array<char, 0x10000> stack;
  stack_t alternate{};
  alternate.ss_sp = stack.data();
  alternate.ss_size = stack.size();
  sigaltstack(&alternate, nullptr);
  struct sigaction action {};
  action.sa_sigaction = on_fault;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigaction(SIGSEGV, &action, nullptr);
  sigaction(SIGBUS, &action, nullptr);
}

}  // namespace nipref::verify::host
