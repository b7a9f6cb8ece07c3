#pragma once
#include <optional>

#include <nipref/fast/partial_slip/internal/zones.hpp>

namespace nipref::fast {

/// A guess at the zones of a contact of about this length from so many elements, at the nodes of a Gauss-Chebyshev rule: they are narrow
/// at the ends, where zones may be short. An element that sticks strains like the roller at its leading edge. The last one slips
/// whatever happens, as what sticks up to the trailing end is a difference of large numbers. Signs change until no condition is
/// violated; nothing in the rare cases where this comes to no end. elements >= 4.
std::optional<Zones> plain_zones(const PartialSlipTask& task, int elements);

/// That length: the task's, or without friction that of its load.
double length_guess(const PartialSlipTask& task);

}  // namespace nipref::fast
