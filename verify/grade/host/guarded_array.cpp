#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <csignal>
#include <new>

#include <nipref/verify/grade/host/guarded_array.hpp>
#include <nipref/verify/grade/internal/protocol.hpp>

namespace nipref::verify::host {
namespace {

constexpr std::size_t guard_size = 0x10000;  // a multiple of all page sizes
constexpr std::size_t array_size = 0x10000;
static_assert(array_size >= protocol::most_points * sizeof(double));
constexpr std::size_t sentinels = 64;

struct Guard {
  char* first;
  std::uint32_t offence;
  std::atomic<bool> open = false;
};

// A signal handler reads these variables, which must need neither locks nor an allocation.
constexpr std::size_t most_guards = 2 * 8 * (protocol::most_arguments + 1);
std::array<Guard, most_guards> guards;
std::atomic<std::size_t> guard_count = 0;
std::atomic<std::uint32_t> noted = 0;

void add_guard(char* first, std::uint32_t offence) {
  const std::size_t number = guard_count;
  if (number == most_guards) throw std::bad_alloc();
  guards[number].first = first;
  guards[number].offence = offence;
  guard_count = number + 1;
}

bool let_pass(const void* address) {
  for (std::size_t i = 0; i < guard_count; ++i) {
    Guard& guard = guards[i];
    if (address < guard.first || address >= guard.first + guard_size) continue;
    note_offence(guard.offence);
    guard.open = true;
    return mprotect(guard.first, guard_size, PROT_READ | PROT_WRITE) == 0;
  }
  return false;
}

void on_fault(int signal, siginfo_t* what, void*) {
  if (let_pass(what->si_addr)) return;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void close_guards() {
  for (std::size_t i = 0; i < guard_count; ++i) {
    if (!guards[i].open.exchange(false)) continue;
    std::fill_n(guards[i].first, guard_size, '\0');
    mprotect(guards[i].first, guard_size, PROT_NONE);
  }
}

}  // namespace

GuardedArray::GuardedArray(std::uint32_t offence) : offence_(offence) {
  void* const memory =
      mmap(nullptr, 2 * guard_size + array_size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  char* const first = static_cast<char*>(memory);
  char* const end = first + guard_size + array_size;
  if (mprotect(first + guard_size, array_size, PROT_READ | PROT_WRITE) != 0) throw std::bad_alloc();
  add_guard(first, offence);
  add_guard(end, offence);
  end_ = reinterpret_cast<double*>(end);
}

std::span<double> GuardedArray::fit(std::size_t count) {
  close_guards();
  count_ = count;
  const std::size_t filled = std::min(count + sentinels, array_size / sizeof(double));
  std::fill_n(end_ - filled, filled, std::bit_cast<double>(protocol::unwritten_bits));
  return {end_ - count, count};
}

void GuardedArray::check() const {
  const std::size_t before = std::min(sentinels, array_size / sizeof(double) - count_);
  const double* const array = end_ - count_;
  if (std::any_of(array - before, array, [](const double& sentinel) {
        return std::bit_cast<std::uint64_t>(sentinel) != protocol::unwritten_bits;
      }))
    note_offence(offence_);
}

void watch_guards() {
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

std::uint32_t offences_noted() { return noted.exchange(0); }

void note_offence(std::uint32_t offence) { noted |= offence; }

}  // namespace nipref::verify::host
