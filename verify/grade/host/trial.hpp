#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <nipref/verify/grade/host/environment.hpp>
#include <nipref/verify/grade/host/guarded_array.hpp>
#include <nipref/verify/grade/host/plugin_file.hpp>
#include <nipref/verify/grade/internal/protocol.hpp>

namespace nipref::verify::host {

/// Detects what calls of the plugin change besides their results.
class Watch {
 public:
  Watch() : sound_(environment()) {}

  /// The changes and offences since the last call; the environment is restored.
  protocol::Noticed noticed();

 private:
  Environment sound_;
};

using Column = std::vector<double>;

/// The values of one batch.
struct Tried {
  int status = 0;
  Column values;
  Column permuted;  ///< the points in another order
  Column
      threaded;  ///< computed by several threads; equal to `values` for a kernel that is not declared thread-safe
};

/// Calls kernels, one at a time, with guarded arrays.
class Trial {
 public:
  Trial();

  /// Evaluates the same points several times.
  Tried evaluate(const Kernel& kernel, const std::vector<Column>& columns);

  /// The seconds for so many calls with all points. `status` becomes that of the last call with a status other than 0.
  double time(const Kernel& kernel, const std::vector<Column>& columns, std::size_t passes, int& status);

 private:
  /// The arrays of one call.
  struct Arrays {
    Arrays();
    int call(const Kernel& kernel, const std::vector<Column>& columns, std::span<const std::size_t> order,
             Column& values);
    void fill(const std::vector<Column>& columns, std::span<const std::size_t> order);

    std::vector<GuardedArray> guarded_arguments;
    GuardedArray guarded_output;
    std::vector<const double*> arguments;
    std::span<double> output;
  };
  void from_threads(const Kernel& kernel, const std::vector<Column>& columns, Tried& tried);

  std::vector<std::unique_ptr<Arrays>>
      arrays_;  ///< the first is for this thread, the others are for further threads
  int times_together_ = 0;
};

}  // namespace nipref::verify::host
