#pragma once
#include <optional>

#include <nipref/ref/nip/internal/proven_contact.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// Intervals that contain the stresses at a point inside the sheet, tension positive.
struct StressIntervals {
  Interval across, along, shear;
};

/// The stresses, in the pressure's units, under the pressure of a frictionless contact on both faces at a place along
/// the sheet and a depth, -1 <= depth <= 1. `digits` are those of the fields of line loads. Nothing if the place may be
/// an end of the contact on a face. (ref/nip/README.md, Stresses inside)
std::optional<StressIntervals> proven_stresses(const ProvenExpansion& pressure, const SurfacePoint& place,
                                               const Exact& depth, int digits);

/// Bounds of the field of a line load less those of both half-planes: of the field for |Im alpha| <= height < 2, and of
/// its slope for real alpha.
Interval sheet_rest(const Interval& height);
inline constexpr long sheet_rest_slope = 4;

}  // namespace nipref::ref
