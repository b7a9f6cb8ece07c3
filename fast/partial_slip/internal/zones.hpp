#pragma once
#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include <nipref/data/problem/nip.hpp>
#include <nipref/fast/nip/internal/domain.hpp>
#include <nipref/fast/nip/work.hpp>

namespace nipref::fast {

/// A part of the contact where the sheet sticks or slips one way. Zones are in the order in which the sheet passes
/// them, and e >= 0 is the distance from the leading end.
struct Zone {
  double length;  ///< half-thicknesses
  int sign;       ///< of the shear along the motion where it slips, 0 where it sticks
  friend bool operator==(const Zone&, const Zone&) = default;
};

using Zones = std::vector<Zone>;

inline bool in_same_order(const Zones& a, const Zones& b) {
  return std::ranges::equal(a, b, {}, &Zone::sign, &Zone::sign);
}

inline double length_of(const Zones& zones) {
  double sum = 0;
  for (const Zone& zone : zones) sum += zone.length;
  return sum;
}

/// What determines a contact with partial slip, dimensionless as in NipEquations, shear and strain along e: one of load
/// and length, and one of traction and creep.
struct PartialSlipTask {
  double beta;      ///< theta2/N
  double friction;  ///< mu
  std::optional<double> load = {}, length = {}, traction = {}, creep = {};
  std::shared_ptr<Work> work = std::make_shared<Work>();  ///< grows with each system that is solved for it
};

/// Whether the sheet sticks from end to end. Then the traction is 0 by symmetry, and its equation is dropped. All other
/// contacts slip at the trailing end, because stick there would need one more unknown.
inline bool sticks_everywhere(const PartialSlipTask& task, const Zones& zones) {
  return zones.size() == 1 && zones.front().sign == 0 && task.traction == 0.0;
}

/// Lets a hundredth of the last zone, which sticks, slip at the trailing end.
inline void slip_at_end(Zones& zones, int sign) {
  const double length = 0.01 * zones.back().length;
  zones.back().length -= length;
  zones.push_back({length, sign});
}

ContactUnits units_of(const data::ElasticNip& nip);

/// BadInput as from partial_slip_for_load.
PartialSlipTask task_for_load(const data::PartialSlipNip& nip, double load);

}  // namespace nipref::fast
