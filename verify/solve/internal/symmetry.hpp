#pragma once
#include <optional>
#include <string_view>

#include <nipref/fast/number/estimate.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>

namespace nipref::verify {

/// What the symmetry of an elastic nip makes of its other results: half of the length on each side, equal
/// displacements at both ends, no resistance. Nothing for any other result.
inline std::optional<fast::Estimate> by_symmetry(const SolvedContact<fast::Estimate>& contact, ResultId id) {
  if (id == ResultId::leading_length || id == ResultId::trailing_length) {
    const fast::Estimate length = contact.number(ResultId::contact_length);
    return fast::Estimate{length.value / 2, length.error / 2};
  }
  if (id == ResultId::trailing_displacement) return contact.number(ResultId::edge_displacement);
  if (id == ResultId::rolling_resistance) return fast::Estimate{0, 0};
  return {};
}

}  // namespace nipref::verify
