#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/grade/fault.hpp>

namespace nipref::verify {

/// double f(double, ...) of a shared object: one double for each argument of its quantity, up to 16, by value. C,
/// Fortran's bind(C) with `value`, Rust's extern "C".
struct BareFunction {
  std::string symbol;
  std::size_t arity = 1;
  bool thread_safe = false;  ///< it is then called from several threads too
};

/// A shared object with kernels, as kernel.h has them, or with a bare function. It is loaded by processes of its own,
/// of the program nipref-kernel-host: NIPREF_KERNEL_HOST in the environment says where that is, if it lies neither
/// beside the running program, in ../libexec/nipref, nor where it was installed.
struct Plugin {
  std::filesystem::path file;
  std::optional<BareFunction> function = {};  ///< none: what it lists
  double time_limit = 10;  ///< seconds for a batch, > 0; at least 30 for being loaded and opened
};

struct KernelInfo {
  std::string name;
  std::string quantity;  ///< empty for a bare function
  std::size_t arity;
  bool thread_safe;

  bool operator==(const KernelInfo&) const = default;
};

/// The kernels that it lists, at least one. BadInput naming the file if it cannot be loaded, ends or hangs while it is,
/// or does not list them as kernel.h says.
std::vector<KernelInfo> kernels_of(const Plugin& plugin);

/// A kernel of a plugin as an Evaluator. Each batch is computed twice, the second time with its points in another
/// order, and from several threads if the kernel says that it may be. Whatever it does is found out, named with the
/// point at which it does it, and is no harm. May be called from several threads: each has a process.
class PluginKernel {
 public:
  /// The kernel of that name. BadInput as kernels_of has it, and if there is none of that name.
  PluginKernel(Plugin plugin, const std::string& name);
  PluginKernel(const PluginKernel&) = delete;
  PluginKernel& operator=(const PluginKernel&) = delete;
  ~PluginKernel();

  [[nodiscard]] const KernelInfo& info() const;

  /// Values at points of `info().arity` arguments; a NaN where there is none. A kernel that ends its process again and
  /// again, or hangs a few times, is given up: there are no values then.
  void evaluate(std::span<const Point> points, std::span<double> values);

  /// The same; this has to outlive it.
  Evaluator evaluator();

  /// Seconds that so many calls with all these points take, without what it takes to get there; nothing if one of them
  /// fails.
  std::optional<double> seconds(std::span<const Point> points, std::size_t passes);

  /// The faults found until now. The same fault at the same point is listed once.
  [[nodiscard]] std::vector<Fault> faults() const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace nipref::verify
