#pragma once
#include <stdexcept>
#include <string>
#include <string_view>

namespace nipref::data {

/// The one error for arguments outside their documented domain. `what()` is a single line
/// "ARGUMENT = VALUE: ALLOWED", e.g. "alpha = nan: must be a finite number".
class BadInput : public std::invalid_argument {
 public:
  BadInput(std::string_view argument, std::string_view value, std::string_view allowed)
      : std::invalid_argument(std::string(argument) + " = " + std::string(value) + ": " +
                              std::string(allowed)) {}

  BadInput(std::string_view argument, double value, std::string_view allowed);
};

}  // namespace nipref::data
