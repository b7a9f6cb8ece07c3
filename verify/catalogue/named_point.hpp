#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string_view>

#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// Numbers of a point, found by the names of the quantity's arguments: point["poisson"]. It refers to both.
template <class Number>
class Named {
 public:
  Named(std::span<const Argument> arguments, std::span<Number> numbers)
      : arguments_(arguments), numbers_(numbers) {}

  /// std::logic_error for a name that is no argument of the quantity: the fault is in the code.
  Number& operator[](std::string_view name) const {
    const auto found = std::ranges::find(arguments_, name, &Argument::name);
    if (found == arguments_.end())
      throw std::logic_error(fmt::format("the quantity has no argument '{}'", name));
    return numbers_[static_cast<std::size_t>(found - arguments_.begin())];
  }

 private:
  std::span<const Argument> arguments_;
  std::span<Number> numbers_;
};

using NamedPoint = Named<const double>;
using NamedExact = Named<const ref::Exact>;

}  // namespace nipref::verify
