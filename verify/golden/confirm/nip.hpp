#pragma once
#include <nipref/verify/golden/confirm/number.hpp>

namespace nipref::verify::confirm {

/// Longer contacts, L/B, without friction, with full friction, and rolling ones need too many points and are not confirmed.
inline constexpr double longest_confirmed = 4, longest_gripped_confirmed = 4, longest_rolling_confirmed = 0.5;

/// The sheet of a contact that rolls without friction, in half-thicknesses.
struct RollingSheet {
  /// A term of the memory: its amplitudes are divided by its rate and by the instantaneous normal compliance N.
  struct Memory {
    Float rate, of_normal, of_theta2;
  };

  Float half_length;
  Float theta2;  ///< instantaneous, over N
  std::vector<Memory> memories;

  /// Joins terms of equal rate.
  void remember(const Memory& term) {
    for (Memory& memory : memories) {
      if (memory.rate != term.rate) continue;
      memory.of_normal += term.of_normal;
      memory.of_theta2 += term.of_theta2;
      return;
    }
    memories.push_back(term);
  }
};

/// rolling_nip.resistance, .leading_share, .load, .indentation, .creep, and the pressure in the middle as nip.peak_pressure.
std::vector<Confirmation> rolling_numbers(const RollingSheet& sheet);

}  // namespace nipref::verify::confirm
