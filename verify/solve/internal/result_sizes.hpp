#pragma once
#include <functional>
#include <optional>

#include <nipref/data/scene/results.hpp>

namespace nipref::verify {

// A scene asks for a relative accuracy. Relative to what: to the result itself, but to no less than the size
// given here, in the result's unit, as what may be 0 has no relative error. The accuracy is met where the
// error is no larger than that part of that size. The least size is 0 of all that is not named here.

struct NipSize {
  double roller_radius;
  double first, last;  ///< ends of the contact, Y
  double accuracy;     ///< that the scene asks for
};

/// Displacements: what the roller's parabola rises over half of the contact. Tangential displacements: creep's
/// least size, a quarter of L/R, times Y, or half of the contact outside. Leading and trailing length: half of
/// the contact. Strain of the surface and slip: creep's least size, more next to
/// an end as for the pressure. Pressure: that in the middle; next to an end, from which it grows like a square root, so much
/// more that the accuracy allows what it changes by as that end moves by as much of half of the contact.
/// Shear: a tenth of it. Places of peaks and of the shear's zeros:
/// a hundred halves of the contact. Rolling resistance: half of L/R, as far as rounding, 1e-14 of it, allows no more.
/// `pressure_in_the_middle` is asked only where it is needed.
double nip_result_size(data::ResultId id, double y, const NipSize& nip,
                       const std::function<double()>& pressure_in_the_middle);

/// The part of it that is about the stresses inside the sheet; nothing for other results. Stresses are measured like the
/// pressure; a maximum is flat, so that its place is known to the root of what its value is.
std::optional<double> inside_result_size(data::ResultId id, double y, const NipSize& nip,
                                         const std::function<double()>& pressure_in_the_middle);

/// Of a traction over its size at the point of first touch, x between the ends first and last: 1, and more next to an
/// end, as above.
double traction_size(double x, double first, double last, double accuracy);

/// Orientation: a radian. Coupling of a line: its compliance.
double half_space_result_size(data::ResultId id, const std::function<double()>& compliance);

}  // namespace nipref::verify
