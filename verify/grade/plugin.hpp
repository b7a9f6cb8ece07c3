#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/grade/fault.hpp>

namespace nipref::verify {

/// A function double f(double, ...) of a shared object, with one double, passed by value, for each of the at most 16
/// arguments of its quantity: C, Fortran's bind(C) with `value`, Rust's extern "C".
struct BareFunction {
  std::string symbol;
  std::size_t arity = 1;
  bool thread_safe = false;  ///< whether it may be called from several threads at once
};

/// A shared object with kernels as in kernel.h, or with a bare function. It is loaded by separate processes, which run
/// the program nipref-kernel-host. The environment variable NIPREF_KERNEL_HOST is the path of that program if it is
/// neither beside the running program, nor in ../libexec/nipref, nor where it was installed.
struct Plugin {
  std::filesystem::path file;
  std::optional<BareFunction> function = {};  ///< nothing if the object lists its kernels
  double time_limit = 10;  ///< seconds for a batch, > 0; loading and opening may take at least 30
};

struct KernelInfo {
  std::string name;
  std::string quantity;  ///< empty for a bare function
  std::size_t arity;
  bool thread_safe;

  bool operator==(const KernelInfo&) const = default;
};

/// The kernels of the plugin, at least one. BadInput that names the file if it cannot be loaded, if loading it ends the
/// process or hangs, or if its list of kernels is not as described in kernel.h.
std::vector<KernelInfo> kernels_of(const Plugin& plugin);

/// A kernel of a plugin as an Evaluator. Each batch is computed twice, the second time with its points in another
/// order, and from several threads if the kernel allows this. Faults of the kernel are recorded with their points and
/// do not harm this process. It may be called from several threads, each of which uses a process of its own.
class PluginKernel {
 public:
  virtual ~PluginKernel() = default;

  [[nodiscard]] virtual const KernelInfo& info() const = 0;

  /// Values at points of `info().arity` arguments; NaN where there is no value. After many processes that ended, or a
  /// few that hung, the kernel is not called again, and all further values are NaN.
  virtual void evaluate(std::span<const Point> points, std::span<double> values) = 0;

  /// This kernel as an Evaluator, which must not outlive it.
  Evaluator evaluator() {
    return [this](std::span<const Point> points, std::span<double> values) { evaluate(points, values); };
  }

  /// The seconds of `passes` calls with all these points, measured in the kernel's process; nothing if a call fails.
  virtual std::optional<double> seconds(std::span<const Point> points, std::size_t passes) = 0;

  /// The faults so far. The same fault at the same point is listed once.
  [[nodiscard]] virtual std::vector<Fault> faults() const = 0;
};

/// The kernel of this name. BadInput if there is none, and in the cases of kernels_of.
std::unique_ptr<PluginKernel> open_kernel(Plugin plugin, const std::string& name);

}  // namespace nipref::verify
