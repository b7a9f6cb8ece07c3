#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cfenv>
#include <chrono>
#include <cstdio>
#include <numeric>
#include <random>
#include <thread>

#include <nipref/verify/grade/host/host.hpp>

namespace nipref::verify::host {
namespace {

using Clock = std::chrono::steady_clock;
using protocol::Column;
using protocol::Exchange;

/// The duration for which threads call the kernel, so that their calls overlap. The first calls last longer, so that
/// the system switches between the threads in the middle of a call even on a single core.
constexpr std::chrono::milliseconds time_together_at_first(20), time_together(1);
constexpr int first_times = 8;

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

/// The changes, of protocol::Noticed, that this thread's floating-point environment has from the default, which is
/// restored. The flags of exceptions do not count.
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

std::vector<std::size_t> as_given(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

/// A permutation of so many points that moves each of them if possible.
std::vector<std::size_t> shuffled(std::size_t count, std::size_t seed) {
  std::vector<std::size_t> order = as_given(count);
  std::ranges::shuffle(order, std::mt19937_64(seed));
  return order;
}

}  // namespace

std::uint32_t noticed() {
  const std::uint32_t changes = environment_changes();
  return changes | offences_noted() | (printed_something() ? protocol::printed : 0U);
}

Trial::Trial() { arrays_.push_back(std::make_unique<Arrays>()); }

void Trial::Arrays::fill(const Kernel& kernel, const Exchange& exchange, const Order& order) {
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

int Trial::Arrays::call(const Kernel& kernel, const Exchange& exchange, const Order& order, Column& values) {
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

void Trial::evaluate(const Kernel& kernel, Exchange& exchange) {
  const std::size_t count = exchange.points;
  exchange.status = arrays_.front()->call(kernel, exchange, as_given(count), exchange.values);
  const int again = arrays_.front()->call(kernel, exchange, shuffled(count, count), exchange.permuted);
  if (exchange.status == 0) exchange.status = again;
  std::copy_n(exchange.values.begin(), count, exchange.threaded.begin());
  if ((kernel.entry.flags & nipref_kernel_thread_safe) != 0 && count > 1 && exchange.status == 0)
    evaluate_in_threads(kernel, exchange);
}

void Trial::evaluate_in_threads(const Kernel& kernel, Exchange& exchange) {
  while (arrays_.size() < thread_count) arrays_.push_back(std::make_unique<Arrays>());
  std::vector<Order> orders;
  for (std::size_t t = 0; t < thread_count; ++t) {
    orders.push_back(shuffled(exchange.points, 1000 + t));
    arrays_[t]->fill(kernel, exchange, orders.back());
  }
  const auto duration = times_in_threads_++ < first_times ? time_together_at_first : time_together;
  std::atomic<std::size_t> started = 0;
  std::atomic<int> status = 0;
  const auto work = [&](std::size_t t) {
    ++started;
    while (started < thread_count) std::this_thread::yield();
    const Clock::time_point end = Clock::now() + duration;
    do {
      if (const int of_call = kernel.evaluate(arrays_[t]->arguments, arrays_[t]->output)) status = of_call;
      for (std::size_t i = 0; i < orders[t].size(); ++i) {
        const std::size_t point = orders[t][i];
        if (bits(arrays_[t]->output[i]) != bits(exchange.values[point]))
          std::atomic_ref(exchange.threaded[point]) = arrays_[t]->output[i];
      }
    } while (Clock::now() < end);
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < thread_count; ++t) threads.emplace_back(work, t);
  }
  exchange.status = status;
}

void Trial::time(const Kernel& kernel, Exchange& exchange) {
  Arrays& arrays = *arrays_.front();
  arrays.fill(kernel, exchange, as_given(exchange.points));
  exchange.status = 0;
  const Clock::time_point start = Clock::now();
  for (std::size_t pass = 0; pass < exchange.passes; ++pass)
    if (const int of_pass = kernel.evaluate(arrays.arguments, arrays.output)) exchange.status = of_pass;
  exchange.seconds = std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace nipref::verify::host
