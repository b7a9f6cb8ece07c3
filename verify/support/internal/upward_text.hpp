#pragma once
#include <fmt/format.h>

#include <cstdlib>
#include <string>

namespace nipref::verify {

/// An error >= 0 in two digits that are no less than it is.
inline std::string upward_text(double error) {
  const std::string nearest = fmt::format("{:.1e}", error);
  if (std::strtod(nearest.c_str(), nullptr) >= error) return nearest;
  return fmt::format("{:.1e}", 1.05 * error);  // half a unit of the second digit is at most a twentieth
}

}  // namespace nipref::verify
