#pragma once
#include <optional>

#include <nipref/ref/nip/internal/proven_contact.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// What contains the stresses at a place inside, tension positive.
struct StressIntervals {
  Interval across, along, shear;
};

/// The stresses under the pressure of a contact without friction on both faces, in its units, at a place along the sheet and
/// a depth, -1 <= depth <= 1, from fields of line loads that are known to so many digits. Nothing where the place may be an
/// end on a face. (ref/nip/README.md, Stresses inside)
std::optional<StressIntervals> proven_stresses(const ProvenExpansion& pressure, const SurfacePoint& place,
                                               const Exact& depth, int digits);

/// What bounds the field of a line load less those of both half-planes at |Im alpha| <= height < 2; and, at real alpha, its
/// slope.
Interval sheet_rest(const Interval& height);
inline constexpr long sheet_rest_slope = 4;

}  // namespace nipref::ref
