#include <fmt/format.h>

#include <nipref/data/bad_input.hpp>

namespace nipref::data {

BadInput::BadInput(std::string_view argument, std::string_view value, std::string_view allowed)
    : std::invalid_argument(fmt::format("{} = {}: {}", argument, value, allowed)),
      argument_(argument),
      value_(value),
      allowed_(allowed) {}

BadInput::BadInput(std::string_view argument, double value, std::string_view allowed)
    : BadInput(argument, fmt::format("{}", value), allowed) {}

}  // namespace nipref::data
