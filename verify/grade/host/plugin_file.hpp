#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nipref/verify/grade/kernel.h>

namespace nipref::verify::host {

/// A kernel and its state.
struct Kernel {
  nipref_kernel entry{};
  void* state = nullptr;

  [[nodiscard]] int evaluate(std::span<const double* const> arguments, std::span<double> out) const {
    return entry.evaluate(state, out.size(), arguments.data(), out.data());
  }
};

/// Loads the file and gives the kernels that it lists, or the one function `symbol` of `arity` doubles.
/// std::runtime_error saying in one line why there are none.
std::vector<Kernel> load_kernels(const std::string& file, const std::string& symbol, std::uint32_t arity,
                                 std::uint32_t flags);

}  // namespace nipref::verify::host
