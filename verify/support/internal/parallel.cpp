#include <mpfr.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work,
                  const OnProgress& on_progress) {
  // A thread takes a run of indices at a time, so that threads seldom contend for the counter; few items: short runs.
  const std::size_t run_length = std::clamp<std::size_t>(count / 64, 1, 16);
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto advance = [&] {
    const std::size_t first = next.fetch_add(run_length);
    if (first >= count) return false;
    try {
      for (std::size_t i = first; i < std::min(first + run_length, count); ++i) {
        stop_if_interrupted();
        work(i);
      }
    } catch (...) {
      const std::scoped_lock lock(mutex);
      if (!failure) failure = std::current_exception();
      next = count;
    }
    return true;
  };
  {
    std::vector<std::jthread> helpers;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i)
      helpers.emplace_back([&] {
        while (advance()) continue;
        mpfr_free_cache();  // MPFR has one cache of constants for each thread
      });
    while (advance()) {
      if (on_progress)
        on_progress(static_cast<double>(std::min(next.load(), count)) / static_cast<double>(count));
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace nipref::verify
