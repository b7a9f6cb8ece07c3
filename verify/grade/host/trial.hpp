#pragma once
#include <memory>
#include <span>
#include <vector>

#include <nipref/verify/grade/host/guarded_array.hpp>
#include <nipref/verify/grade/host/plugin_file.hpp>
#include <nipref/verify/grade/internal/exchange.hpp>

namespace nipref::verify::host {

/// What calls of the plugin have done besides their results since the last call, of protocol::Noticed; it is undone.
std::uint32_t noticed();

/// Calls kernels, one at a time, with guarded arrays. The points are those of an Exchange, the answers go to it.
class Trial {
 public:
  Trial();

  /// Evaluates the same points several times.
  void evaluate(const Kernel& kernel, protocol::Exchange& exchange);

  /// Measures the time of so many calls with all points. The status is that of the last call with another than 0.
  void time(const Kernel& kernel, protocol::Exchange& exchange);

 private:
  using Order = std::vector<std::size_t>;

  /// The arrays of one call.
  struct Arrays {
    void fill(const Kernel& kernel, const protocol::Exchange& exchange, const Order& order);
    int call(const Kernel& kernel, const protocol::Exchange& exchange, const Order& order,
             protocol::Column& values);

    std::vector<GuardedArray> guarded_arguments;
    GuardedArray guarded_output{protocol::output_overrun};
    std::vector<const double*> arguments;
    std::span<double> output;
  };
  void evaluate_in_threads(const Kernel& kernel, protocol::Exchange& exchange);

  std::vector<std::unique_ptr<Arrays>> arrays_;  ///< the first of this thread, the others of further threads
  int times_in_threads_ = 0;
};

}  // namespace nipref::verify::host
