#pragma once
#include <nipref/verify/golden/confirm/number.hpp>

namespace nipref::verify::confirm {

/// Longer contacts, L/B, without friction, with full friction, and rolling ones need too many points and are not confirmed.
inline constexpr double longest_confirmed = 4, longest_gripped_confirmed = 4, longest_rolling_confirmed = 0.5;

/// The sheet of a contact that rolls without friction, in half-thicknesses.
struct RollingSheet {
  /// Amplitudes of the memory, divided by their rate and by the instantaneous normal compliance N.
  struct Memory {
    Float of_normal, of_theta2;
  };

  Float half_length;
  Float theta2;                           ///< instantaneous, over N
  std::map<Float, Memory> memories = {};  ///< by rate

  void remember(const Float& rate, const Float& amplitude, bool is_theta2) {
    memories[rate].of_normal += amplitude;
    if (is_theta2) memories[rate].of_theta2 += amplitude;
  }
};

/// rolling_nip.resistance, .leading_share, .load, .indentation, .creep, and the pressure in the middle as nip.peak_pressure.
std::vector<Confirmation> rolling_numbers(const RollingSheet& sheet);

}  // namespace nipref::verify::confirm
