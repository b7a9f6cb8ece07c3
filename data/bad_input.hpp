#pragma once
#include <stdexcept>
#include <string>
#include <string_view>

namespace nipref::data {

/// The one error for arguments outside their documented domain. `what()` is a single line "ARGUMENT = VALUE: ALLOWED",
/// e.g. "alpha = nan: must be a finite number". The three parts may themselves contain " = " and ": ", so that the line
/// cannot be split reliably: the members return the parts.
class BadInput : public std::invalid_argument {
 public:
  BadInput(std::string_view argument, std::string_view value, std::string_view allowed);
  BadInput(std::string_view argument, double value, std::string_view allowed);

  [[nodiscard]] const std::string& argument() const { return argument_; }
  [[nodiscard]] const std::string& value() const { return value_; }
  [[nodiscard]] const std::string& allowed() const { return allowed_; }

 private:
  std::string argument_, value_, allowed_;
};

}  // namespace nipref::data
