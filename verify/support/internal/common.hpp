#pragma once

// The headers that nearly every source of verify needs: the standard library, {fmt}, and the functions that refuse
// input.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <ranges>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/support/mapped.hpp>

namespace nipref::verify {

/// Throws BadInput. `allowed` and `args` are those of fmt::format() and say what is allowed.
template <class Value, class... Args>
[[noreturn]] void refuse(std::string_view argument, const Value& value, fmt::format_string<Args...> allowed,
                         Args&&... args) {
  throw data::BadInput(argument, value, fmt::format(allowed, std::forward<Args>(args)...));
}

/// Returns the result of `work`, or nothing if `work` refuses its input.
template <class Work>
std::optional<std::invoke_result_t<const Work&>> unless_refused(const Work& work) try {
  return work();
} catch (const data::BadInput&) {
  return std::nullopt;
}
bool is_refused(const auto& work) {
  return !unless_refused([&] { return work(), true; });
}

}  // namespace nipref::verify
