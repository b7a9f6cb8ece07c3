// Runs a plugin for the program that grades it: nipref-kernel-host FILE SYMBOL ARITY FLAGS SECONDS. exchange.hpp
// describes how the two communicate. The host is a separate program so that no fault of the plugin affects nipref.

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cfenv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <numeric>
#include <random>
#include <string>
#include <thread>

#include <nipref/verify/grade/host/guarded_array.hpp>
#include <nipref/verify/grade/host/plugin_file.hpp>

#if defined(__SANITIZE_ADDRESS__)
extern "C" const char* __asan_default_options();
/// A plugin that ends the process need not free its memory.
extern "C" const char* __asan_default_options() { return "detect_leaks=0"; }
#endif

namespace {

using namespace nipref::verify;
using namespace nipref::verify::host;
using Clock = std::chrono::steady_clock;
using protocol::Exchange;
using protocol::Request;

/// The duration for which threads call the kernel, so that their calls overlap. The first calls last longer, so that
/// the system switches between the threads in the middle of a call even on a single core.
constexpr std::chrono::milliseconds time_together_at_first(20), time_together(1);
constexpr int first_times = 8;

/// Forbids core dumps, as crashes are expected, and limits the size of files.
void limit_resources() {
  constexpr rlim_t largest_file = 64 << 20;
  const rlimit none{0, 0}, file{largest_file, largest_file};
  setrlimit(RLIMIT_CORE, &none);
  setrlimit(RLIMIT_FSIZE, &file);
  std::signal(SIGXFSZ, SIG_IGN);
}

/// Maps the shared memory, which is standard input at the start, and then makes standard input empty.
Exchange& shared_memory() {
  void* const memory = mmap(nullptr, sizeof(Exchange), PROT_READ | PROT_WRITE, MAP_SHARED, STDIN_FILENO, 0);
  if (memory == MAP_FAILED || close(STDIN_FILENO) != 0 || open("/dev/null", O_RDONLY) != STDIN_FILENO)
    _exit(2);
  return *static_cast<Exchange*>(memory);
}

/// Copies the text, cut to the size of `to`.
void copy(const std::string& text, std::span<char> to) {
  const std::size_t size = text.copy(to.data(), to.size() - 1);
  to[size] = '\0';
}

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

/// Returns how this thread's floating-point environment differs from the default, as bits of protocol::Noticed, and
/// restores the default. The flags of exceptions do not count.
std::uint32_t environment_changes() {
  std::uint32_t changes = std::fegetround() == FE_TONEAREST ? 0U : protocol::rounding;
  const auto add = [&](bool changed, std::uint32_t what) { changes |= changed ? what : 0U; };
  std::fenv_t now{};
  std::fegetenv(&now);
#if defined(__x86_64__) && defined(__GLIBC__)
  const std::uint32_t sse = now.__mxcsr ^ 0x1f80U, x87 = now.__control_word ^ 0x037fU;
  add((sse & 0x6000) != 0, protocol::rounding);
  add((sse & 0x8000) != 0, protocol::flush_to_zero);
  add((sse & 0x0040) != 0, protocol::denormals_are_zero);
  add((sse & 0x1f80) != 0 || (x87 & 0x003f) != 0, protocol::traps);
  add((x87 & 0x0300) != 0, protocol::x87_precision);
#elif defined(__aarch64__) && defined(__GLIBC__)
  // One bit flushes both arguments and results.
  add((now.__fpcr >> 24 & 1) != 0, protocol::flush_to_zero | protocol::denormals_are_zero);
  add((now.__fpcr >> 8 & 0x9f) != 0, protocol::traps);
#endif
  std::fesetenv(FE_DFL_ENV);
  return changes;
}

/// Looks at the size of standard output, which is a file that only this process writes.
bool printed_something() {
  std::fflush(nullptr);
  struct stat output {};
  if (fstat(STDOUT_FILENO, &output) != 0 || output.st_size == 0) return false;
  return ftruncate(STDOUT_FILENO, 0) == 0;
}

/// Numbers of points in the order in which they are given to the kernel.
using Order = std::vector<std::size_t>;

Order as_given(std::size_t count) {
  Order order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

/// A random permutation of `count` points.
Order shuffled(std::size_t count, std::size_t seed) {
  Order order = as_given(count);
  std::ranges::shuffle(order, std::mt19937_64(seed));
  return order;
}

/// Returns the side effects of calls of the plugin since the last call, as bits of protocol::Noticed, and undoes them.
std::uint32_t noticed() {
  const std::uint32_t changes = environment_changes();
  return changes | offences_noted() | (printed_something() ? protocol::printed : 0U);
}

/// The arrays of one call, between guards.
struct Arrays {
  void fill(const Kernel& kernel, const Exchange& exchange, const Order& order) {
    while (guarded_arguments.size() < kernel.entry.arity)
      guarded_arguments.emplace_back(protocol::arguments_overrun);
    arguments.clear();
    for (std::size_t j = 0; j < kernel.entry.arity; ++j) {
      const std::span<double> array = guarded_arguments[j].fit(order.size());
      for (std::size_t i = 0; i < order.size(); ++i) array[i] = exchange.arguments[j][order[i]];
      arguments.push_back(array.data());
    }
    output = guarded_output.fit(order.size());
  }

  int call(const Kernel& kernel, const Exchange& exchange, const Order& order, protocol::Column& values) {
    fill(kernel, exchange, order);
    const int status = kernel.evaluate(arguments, output);
    guarded_output.check();
    for (std::size_t j = 0; j < arguments.size(); ++j) {
      guarded_arguments[j].check();
      for (std::size_t i = 0; i < order.size(); ++i) {
        if (bits(guarded_arguments[j].array()[i]) != bits(exchange.arguments[j][order[i]]))
          note_offence(protocol::arguments_changed);
      }
    }
    for (std::size_t i = 0; i < order.size(); ++i) values[order[i]] = output[i];
    return status;
  }

  std::vector<GuardedArray> guarded_arguments;
  GuardedArray guarded_output{protocol::output_overrun};
  std::vector<const double*> arguments;
  std::span<double> output;
};

class Host {
 public:
  explicit Host(char** words) : words_(words), exchange_(shared_memory()) {}

  void answer() {
    switch (exchange_.request) {
      case Request::load:
        load();
        break;
      case Request::open:
        kernel_ = &kernels_.at(exchange_.kernel);
        exchange_.status = 0;
        if (kernel_->entry.open == nullptr) break;  // the state of a bare function is the function
        kernel_->state = nullptr;
        exchange_.status = kernel_->entry.open(&kernel_->state);
        break;
      case Request::close:
        if (kernel_->entry.close != nullptr) kernel_->entry.close(kernel_->state);
        exchange_.status = 0;
        break;
      case Request::evaluate:
        evaluate();
        break;
      case Request::time:
        time();
    }
    exchange_.noticed = noticed();
  }

 private:
  void load() try {
    kernels_ = load_kernels(words_[0], words_[1], static_cast<std::uint32_t>(std::stoul(words_[2])),
                            static_cast<std::uint32_t>(std::stoul(words_[3])));
    for (std::size_t i = 0; i < kernels_.size(); ++i) {
      const nipref_kernel& entry = kernels_[i].entry;
      auto& listed = exchange_.kernel_list[i];
      copy(entry.name, listed.name);
      copy(entry.quantity, listed.quantity);
      listed.arity = entry.arity;
      listed.flags = entry.flags;
    }
    exchange_.kernels = kernels_.size();
    exchange_.status = 0;
  } catch (const std::exception& error) {
    copy(error.what(), exchange_.failure);
    exchange_.status = 1;
  }

  /// Evaluates the same points several times.
  void evaluate() {
    const std::size_t count = exchange_.points;
    exchange_.status = arrays_.front().call(*kernel_, exchange_, as_given(count), exchange_.values);
    const int again = arrays_.front().call(*kernel_, exchange_, shuffled(count, count), exchange_.permuted);
    if (exchange_.status == 0) exchange_.status = again;
    std::copy_n(exchange_.values.begin(), count, exchange_.threaded.begin());
    if ((kernel_->entry.flags & nipref_kernel_thread_safe) != 0 && count > 1 && exchange_.status == 0)
      evaluate_in_threads();
  }

  void evaluate_in_threads() {
    std::vector<Order> orders;
    for (std::size_t t = 0; t < thread_count; ++t) {
      orders.push_back(shuffled(exchange_.points, 1000 + t));
      arrays_[t].fill(*kernel_, exchange_, orders.back());
    }
    const auto duration = times_in_threads_++ < first_times ? time_together_at_first : time_together;
    std::atomic<std::size_t> started = 0;
    std::atomic<int> status = 0;
    const auto work = [&](std::size_t t) {
      ++started;
      while (started < thread_count) std::this_thread::yield();
      const Clock::time_point end = Clock::now() + duration;
      do {
        if (const int of_call = kernel_->evaluate(arrays_[t].arguments, arrays_[t].output)) status = of_call;
        for (std::size_t i = 0; i < orders[t].size(); ++i) {
          const std::size_t point = orders[t][i];
          if (bits(arrays_[t].output[i]) != bits(exchange_.values[point]))
            std::atomic_ref(exchange_.threaded[point]) = arrays_[t].output[i];
        }
      } while (Clock::now() < end);
    };
    {
      std::vector<std::jthread> threads;
      for (std::size_t t = 0; t < thread_count; ++t) threads.emplace_back(work, t);
    }
    exchange_.status = status;
  }

  /// Measures the time of `passes` calls with all points. The status is that of the last call that did not return 0.
  void time() {
    Arrays& arrays = arrays_.front();
    arrays.fill(*kernel_, exchange_, as_given(exchange_.points));
    exchange_.status = 0;
    const Clock::time_point start = Clock::now();
    for (std::size_t pass = 0; pass < exchange_.passes; ++pass)
      if (const int of_pass = kernel_->evaluate(arrays.arguments, arrays.output)) exchange_.status = of_pass;
    exchange_.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }

  char** words_;
  Exchange& exchange_;
  std::array<Arrays, thread_count> arrays_;  ///< a single call uses the first
  int times_in_threads_ = 0;
  std::vector<Kernel> kernels_;
  Kernel* kernel_ = nullptr;
};

}  // namespace

int main(int count, char** words) {
  if (count != 6) {
    std::fputs("nipref-kernel-host is called by nipref grade and by nothing else\n", stderr);
    return 2;
  }
  limit_resources();
  watch_guards();
  // A timer ends a call that takes too long. The program does so earlier, unless it has itself ended.
  constexpr double delay = 5;
  const auto longest =
      static_cast<unsigned>(std::ceil(std::max(std::stod(words[5]), protocol::seconds_to_begin) + delay));
  Host host(words + 1);
  for (std::uint64_t request = 0;
       recv(protocol::connection, &request, sizeof request, 0) == sizeof request;) {
    alarm(longest);
    host.answer();
    alarm(0);
    if (send(protocol::connection, &request, sizeof request, MSG_NOSIGNAL) != sizeof request) break;
  }
  _exit(0);
}
