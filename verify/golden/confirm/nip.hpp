#pragma once
#include <nipref/verify/golden/confirm/number.hpp>

namespace nipref::verify::confirm {

/// The largest L/B confirmed: without friction, with full friction, and rolling. Longer contacts need too many points.
inline constexpr double longest_confirmed = 4, longest_gripped_confirmed = 4, longest_rolling_confirmed = 0.5;

/// The sheet of a contact that rolls without friction. Lengths are in half-thicknesses.
struct RollingSheet {
  /// The amplitudes of one rate, divided by the rate and by the instantaneous normal compliance N.
  struct Memory {
    Float of_normal, of_theta2;
  };

  Float half_length;
  Float theta2;                           ///< instantaneous theta2 over N
  std::map<Float, Memory> memories = {};  ///< by rate

  void remember(const Float& rate, const Float& amplitude, bool is_theta2) {
    memories[rate].of_normal += amplitude;
    if (is_theta2) memories[rate].of_theta2 += amplitude;
  }
};

/// Returns rolling_nip.resistance, .leading_share, .load, .indentation, .creep, and, in the unit of nip.peak_pressure,
/// the pressure in the middle.
std::vector<Confirmation> rolling_numbers(const RollingSheet& sheet);

}  // namespace nipref::verify::confirm
