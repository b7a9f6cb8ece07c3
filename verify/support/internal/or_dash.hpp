#pragma once
#include <fmt/format.h>

#include <optional>
#include <string>

namespace nipref::verify {

/// So many significant digits, or a dash where the number is not known.
inline std::string or_dash(const std::optional<double>& number, int digits) {
  return number ? fmt::format("{:.{}g}", *number, digits) : "-";
}

}  // namespace nipref::verify
