#pragma once
#include <optional>
#include <string_view>

#include <nipref/fast/number/estimate.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>

namespace nipref::verify {

/// What the symmetry of an elastic nip makes of its other results: half of the length on each side, equal
/// displacements at both ends, no resistance. Nothing for any other name.
inline std::optional<fast::Estimate> by_symmetry(const SolvedContact<fast::Estimate>& contact,
                                                 std::string_view name) {
  if (name == "leading_length" || name == "trailing_length") {
    const fast::Estimate length = contact.number("contact_length");
    return fast::Estimate{length.value / 2, length.error / 2};
  }
  if (name == "trailing_displacement") return contact.number("edge_displacement");
  if (name == "rolling_resistance") return fast::Estimate{0, 0};
  return {};
}

}  // namespace nipref::verify
