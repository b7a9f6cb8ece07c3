#pragma once
#include <optional>

#include <nipref/fast/partial_slip/internal/zones.hpp>

namespace nipref::fast {

/// A guess of the zones of a contact of the length length_guess(), from `elements` >= 4 elements about the nodes of a
/// Gauss-Chebyshev rule: they are narrow at the ends, where zones may be short. If an element sticks, the strain at its
/// leading edge is the creep. The last element always slips, because the shear of stick up to the trailing end would be
/// a difference of large numbers. Signs change until no condition is violated. Nothing in the rare cases in which this
/// does not end.
std::optional<Zones> plain_zones(const PartialSlipTask& task, int elements);

/// The same for so little friction that the sheet slips nearly everywhere and sticks in short zones alone, where slip
/// turns around. Nothing for more friction.
std::optional<Zones> slipping_zones(const PartialSlipTask& task, int elements);

/// The length of the task, or the length without friction of its load.
double length_guess(const PartialSlipTask& task);

}  // namespace nipref::fast
