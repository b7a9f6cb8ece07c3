#include "data/bad_input.hpp"

#include <fmt/format.h>

namespace nipref::data {

BadInput::BadInput(std::string_view argument, double value, std::string_view allowed)
    : BadInput(argument, fmt::format("{}", value), allowed) {}

}  // namespace nipref::data
