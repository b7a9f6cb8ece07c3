#pragma once
#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// The index of the argument of that name. Throws std::logic_error if there is none, which is an error of the code.
inline std::size_t argument_number(std::span<const Argument> arguments, std::string_view name) {
  const auto found = std::ranges::find(arguments, name, &Argument::name);
  if (found == arguments.end())
    throw std::logic_error("the quantity has no argument '" + std::string(name) + "'");
  return static_cast<std::size_t>(found - arguments.begin());
}

/// The numbers of a point by the names of the arguments: point["poisson"]. It refers to the data of the caller.
template <class Number>
class Named {
 public:
  Named(std::span<const Argument> arguments, std::span<Number> numbers)
      : arguments_(arguments), numbers_(numbers) {}

  Number& operator[](std::string_view name) const { return numbers_[argument_number(arguments_, name)]; }
  operator Named<const Number>() const { return {arguments_, numbers_}; }
  /// The number of a choice.
  [[nodiscard]] std::size_t choice(std::string_view name) const {
    if constexpr (requires(const Number& number) { number.approximate(); })
      return static_cast<std::size_t>((*this)[name].approximate());
    else
      return static_cast<std::size_t>((*this)[name]);
  }
  /// The numbers of that argument and of all after it.
  [[nodiscard]] std::span<Number> from(std::string_view name) const {
    return numbers_.subspan(argument_number(arguments_, name));
  }
  /// The numbers of that argument and of the next ones whose names differ from it only in the number at the end.
  [[nodiscard]] std::span<Number> list(std::string_view first) const {
    const auto stem = [](std::string_view name) {
      const std::size_t last = name.find_last_not_of("0123456789");
      return name[last] == '_' ? name.substr(0, last) : name;
    };
    const std::size_t begin = argument_number(arguments_, first);
    std::size_t end = begin + 1;
    while (end < arguments_.size() && stem(arguments_[end].name) == stem(first)) ++end;
    return numbers_.subspan(begin, end - begin);
  }
  [[nodiscard]] std::span<const Argument> arguments() const { return arguments_; }

 private:
  std::span<const Argument> arguments_;
  std::span<Number> numbers_;
};

using NamedNumbers = Named<double>;
using NamedPoint = Named<const double>;
using NamedExact = Named<const ref::Exact>;

/// The default of an argument as a number; 0 if it has none.
double default_number(const Argument& argument);

/// A point of the defaults and the given numbers.
Point point_of(const Quantity& quantity, const std::vector<std::pair<std::string_view, double>>& given);

}  // namespace nipref::verify
