#pragma once

// Domain checks of the sheet kernels. For good input they cost one comparison; code for bad input is not inlined.

#include <cmath>
#include <limits>
#include <span>
#include <string_view>

#include <nipref/fast/sheet/internal/dispatch.hpp>

namespace nipref::fast::internal {

/// Throws BadInput for an argument outside the domain.
[[noreturn]] void refuse_argument(std::string_view name, double value);

/// Throws BadInput if the spans differ in size or an argument is outside the domain; names the first such element.
void check_arguments(std::string_view name, std::span<const double> arguments, std::size_t value_count,
                     Domain domain);

inline bool in_domain(double argument, Domain domain) {
  const double magnitude = std::fabs(argument);
  return magnitude <= std::numeric_limits<double>::max() && (domain == Domain::finite || magnitude > 0);
}

inline void check_argument(std::string_view name, double argument, Domain domain) {
  if (!in_domain(argument, domain)) [[unlikely]]
    refuse_argument(name, argument);
}

}  // namespace nipref::fast::internal
