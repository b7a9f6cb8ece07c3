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

/// Calls what is the plugin's and notes what it does besides.
class Watch {
 public:
  Watch() : sound_(environment()) {}

  /// What changed and was done since the last call; everything is put back.
  protocol::Noticed noticed();

 private:
  Environment sound_;
};

using Column = std::vector<double>;

/// Values of one batch.
struct Tried {
  int status = 0;
  Column values;
  Column permuted;  ///< the points in another order
  Column
      threaded;  ///< from several threads; the same as `values` for a kernel that is not said to be thread-safe
};

/// Calls kernels between guards. One at a time.
class Trial {
 public:
  Trial();

  /// The same points several times.
  Tried evaluate(const Kernel& kernel, const std::vector<Column>& columns);

  /// Seconds of so many calls with all points; status of the last call that was not 0.
  double time(const Kernel& kernel, const std::vector<Column>& columns, std::size_t passes, int& status);

 private:
  /// One call's arrays.
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
      arrays_;  ///< the first for this thread, the others when there are threads
  int times_together_ = 0;
};

}  // namespace nipref::verify::host
