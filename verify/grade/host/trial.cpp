#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <cstdio>
#include <numeric>
#include <random>
#include <thread>

#include <nipref/verify/grade/host/trial.hpp>

namespace nipref::verify::host {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t thread_count = 4;
/// The duration for which threads call the kernel, so that their calls overlap. The first calls last longer, so that
/// the system switches between the threads in the middle of a call even on a single core.
constexpr std::chrono::milliseconds time_together_at_first(20), time_together(1);
constexpr int first_times = 8;

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

/// The size of standard output, which is a file that only this process writes.
bool printed_something() {
  std::fflush(nullptr);
  struct stat output {};
  if (fstat(STDOUT_FILENO, &output) != 0 || output.st_size == 0) return false;
  return ftruncate(STDOUT_FILENO, 0) == 0;
}

/// A permutation of so many points that moves each of them if possible.
std::vector<std::size_t> shuffled(std::size_t count, std::size_t seed) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::shuffle(order, std::mt19937_64(seed));
  return order;
}

}  // namespace

protocol::Noticed Watch::noticed() {
  protocol::Noticed noticed;
  noticed.changes = changes(sound_, environment());
  set_environment(sound_);
  noticed.offences = offences_noted() | (printed_something() ? protocol::printed : 0U);
  return noticed;
}

Trial::Arrays::Arrays() : guarded_output(protocol::output_overrun) {}

void Trial::Arrays::fill(const std::vector<Column>& columns, std::span<const std::size_t> order) {
  while (guarded_arguments.size() < columns.size())
    guarded_arguments.emplace_back(protocol::arguments_overrun);
  arguments.clear();
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const std::span<double> array = guarded_arguments[j].fit(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) array[i] = columns[j][order[i]];
    arguments.push_back(array.data());
  }
  output = guarded_output.fit(order.size());
}

int Trial::Arrays::call(const Kernel& kernel, const std::vector<Column>& columns,
                        std::span<const std::size_t> order, Column& values) {
  fill(columns, order);
  const int status = kernel.evaluate(arguments, output);
  guarded_output.check();
  for (std::size_t j = 0; j < columns.size(); ++j) {
    guarded_arguments[j].check();
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (bits(guarded_arguments[j].array()[i]) != bits(columns[j][order[i]]))
        note_offence(protocol::arguments_changed);
    }
  }
  values.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) values[order[i]] = output[i];
  return status;
}

Trial::Trial() { arrays_.push_back(std::make_unique<Arrays>()); }

Tried Trial::evaluate(const Kernel& kernel, const std::vector<Column>& columns) {
  Tried tried;
  const std::size_t count = columns.front().size();
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  tried.status = arrays_.front()->call(kernel, columns, order, tried.values);
  const int again = arrays_.front()->call(kernel, columns, shuffled(count, count), tried.permuted);
  if (tried.status == 0) tried.status = again;
  tried.threaded = tried.values;
  if ((kernel.entry.flags & nipref_kernel_thread_safe) != 0 && count > 1 && tried.status == 0)
    from_threads(kernel, columns, tried);
  return tried;
}

void Trial::from_threads(const Kernel& kernel, const std::vector<Column>& columns, Tried& tried) {
  while (arrays_.size() < thread_count) arrays_.push_back(std::make_unique<Arrays>());
  std::vector<std::vector<std::size_t>> orders;
  for (std::size_t t = 0; t < thread_count; ++t) {
    orders.push_back(shuffled(columns.front().size(), 1000 + t));
    arrays_[t]->fill(columns, orders.back());
  }
  std::vector<std::atomic<std::uint64_t>> last_other(tried.values.size());
  for (std::size_t i = 0; i < tried.values.size(); ++i) last_other[i] = bits(tried.values[i]);
  const auto duration = times_together_++ < first_times ? time_together_at_first : time_together;
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
        if (bits(arrays_[t]->output[i]) != bits(tried.values[point]))
          last_other[point] = bits(arrays_[t]->output[i]);
      }
    } while (Clock::now() < end);
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < thread_count; ++t) threads.emplace_back(work, t);
  }
  tried.status = status;
  for (std::size_t i = 0; i < tried.values.size(); ++i)
    tried.threaded[i] = std::bit_cast<double>(last_other[i].load());
}

double Trial::time(const Kernel& kernel, const std::vector<Column>& columns, std::size_t passes,
                   int& status) {
  std::vector<std::size_t> order(columns.front().size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  Arrays& arrays = *arrays_.front();
  arrays.fill(columns, order);
  const Clock::time_point start = Clock::now();
  for (std::size_t pass = 0; pass < passes; ++pass) {
    if (const int of_pass = kernel.evaluate(arrays.arguments, arrays.output)) status = of_pass;
  }
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace nipref::verify::host
