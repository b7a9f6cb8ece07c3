#pragma once
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/on_progress.hpp>

namespace nipref::verify {

/// Calls work(i) once for each i in [0, count), from as many threads as the machine has cores, in no particular order.
/// Calls `on_progress` from the calling thread only. The first exception of `work` ends the loop and is thrown again
/// here. An interrupt ends the loop with Interrupted, unless no call is left. Starting the threads costs 0.2 ms.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work,
                  const OnProgress& on_progress = {});

/// The results of work(i) in the order of i, computed by parallel_for.
template <class Work>
auto parallel_mapped(std::size_t count, const Work& work, const OnProgress& on_progress = {}) {
  std::vector<std::invoke_result_t<const Work&, std::size_t>> results(count);
  parallel_for(
      count, [&](std::size_t i) { results[i] = work(i); }, on_progress);
  return results;
}

}  // namespace nipref::verify
