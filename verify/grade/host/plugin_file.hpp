#pragma once
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <nipref/verify/grade/internal/exchange.hpp>
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

template <std::size_t>
using Double = double;

/// A bare function's `evaluate`; the function is its state.
template <std::size_t... i>
int call_each(void* function, std::size_t n, const double* const* arguments, double* out,
              std::index_sequence<i...>) {
  const auto f = reinterpret_cast<double (*)(Double<i>...)>(function);
  for (std::size_t k = 0; k < n; ++k) out[k] = f(arguments[i][k]...);
  return 0;
}

template <std::size_t arity>
int evaluate_bare(void* function, std::size_t n, const double* const* arguments, double* out) {
  return call_each(function, n, arguments, out, std::make_index_sequence<arity>());
}

template <std::size_t... i>
constexpr auto evaluators(std::index_sequence<i...>) {
  return std::array{evaluate_bare<i + 1>...};
}

/// The `evaluate` of bare functions with 1, 2, ... arguments.
constexpr auto bare_evaluators = evaluators(std::make_index_sequence<protocol::most_arguments>());

inline void* symbol_of(void* handle, const char* name, const char* hint = "") {
  if (void* const found = dlsym(handle, name)) return found;
  throw std::runtime_error(std::string("has no symbol ") + name + hint);
}

inline std::string text_of(const char* text) { return text == nullptr ? "" : text; }

inline void refuse(const nipref_kernel& kernel, const std::string& why) {
  throw std::runtime_error("has a kernel " + text_of(kernel.name) + " " + why);
}

/// The size of the structure of the first header of this ABI, which ended with `close`.
inline constexpr std::size_t least_size = offsetof(nipref_kernel, close) + sizeof(nipref_kernel::close);

inline Kernel checked(const nipref_kernel& given) {
  if (given.abi != NIPREF_KERNEL_ABI)
    throw std::runtime_error("has a kernel of ABI number " + std::to_string(given.abi) + ": must be " +
                             std::to_string(NIPREF_KERNEL_ABI));
  if (given.size < least_size)
    throw std::runtime_error("has a kernel of size " + std::to_string(given.size) + ": must be " +
                             std::to_string(least_size) + " at least");
  Kernel kernel;
  // Members that an older header does not have remain 0.
  std::memcpy(&kernel.entry, &given, std::min<std::size_t>(given.size, sizeof kernel.entry));
  if (text_of(given.name).empty()) refuse(given, "without a name");
  if (text_of(given.quantity).empty()) refuse(given, "without a quantity");
  if (std::max(text_of(given.name).size(), text_of(given.quantity).size()) >= sizeof(protocol::Text))
    refuse(given, "of a name that is too long");
  if (given.evaluate == nullptr) refuse(given, "without a function evaluate");
  if (given.arity == 0 || given.arity > protocol::most_arguments)
    refuse(given, "of " + std::to_string(given.arity) + " arguments");
  return kernel;
}

/// Loads the file and returns the kernels that it lists or, unless `symbol` is "", the function `symbol` of `arity`
/// doubles. `symbol` is not copied. std::runtime_error that says in one line why there are none.
inline std::vector<Kernel> load_kernels(const std::string& file, const char* symbol, std::uint32_t arity,
                                        std::uint32_t flags) {
  void* const handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) throw std::runtime_error(text_of(dlerror()));
  std::vector<Kernel> kernels;
  if (*symbol != '\0') {
    Kernel bare;
    // A bare function has no name but its symbol, and does not say which quantity it computes.
    bare.entry = {NIPREF_KERNEL_ABI, sizeof(nipref_kernel),         symbol, "", arity, flags,
                  nullptr,           bare_evaluators.at(arity - 1), nullptr};
    bare.state = symbol_of(handle, symbol);
    kernels.push_back(bare);
    return kernels;
  }
  const auto list = reinterpret_cast<decltype(&nipref_kernels)>(symbol_of(
      handle, "nipref_kernels", ", as nipref/kernel.h describes it: name a function by --symbol, or add it"));
  const nipref_kernel* const* const all = list();
  for (std::size_t i = 0; all != nullptr && all[i] != nullptr; ++i) kernels.push_back(checked(*all[i]));
  if (kernels.empty()) throw std::runtime_error("lists no kernels");
  if (kernels.size() > protocol::most_kernels) throw std::runtime_error("lists too many kernels");
  return kernels;
}

}  // namespace nipref::verify::host
