#include <mpfr.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {
namespace {

/// Indices are handed out in runs, so that the counter is not contended; short ones when there are few and
/// costly ones.
std::size_t run_length_for(std::size_t count) { return std::clamp<std::size_t>(count / 64, 1, 16); }

class SharedLoop {
 public:
  SharedLoop(std::size_t count, const std::function<void(std::size_t)>& work)
      : count_(count), run_length_(run_length_for(count)), work_(work) {}

  /// One run of indices; false when there are none left.
  bool advance() {
    const std::size_t first = next_.fetch_add(run_length_);
    if (first >= count_) return false;
    try {
      for (std::size_t i = first; i < std::min(first + run_length_, count_); ++i) {
        stop_if_interrupted();
        work_(i);
      }
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      next_ = count_;
    }
    return true;
  }

  [[nodiscard]] std::size_t done() const { return std::min(next_.load(), count_); }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::size_t count_;
  std::size_t run_length_;
  const std::function<void(std::size_t)>& work_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

void run_helper(SharedLoop& loop) {
  while (loop.advance()) {
  }
  mpfr_free_cache();  // MPFR keeps its constants once for each thread
}

}  // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t done)>& progress) {
  SharedLoop loop(count, work);
  {
    std::vector<std::jthread> helpers;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i)
      helpers.emplace_back(run_helper, std::ref(loop));
    while (loop.advance()) {
      if (progress) progress(loop.done());
    }
  }
  loop.rethrow();
}

}  // namespace nipref::verify
