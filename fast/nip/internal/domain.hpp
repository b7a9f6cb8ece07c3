#pragma once
#include <string>

#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

/// The shape of a nip: with the material, what the domain and the units of its contact depend on.
struct NipShape {
  double roller_radius;
  double sheet_thickness;
};

/// Half length (half-thicknesses), L/B, of the shortest contact allowed.
inline constexpr double shortest_half_length = 1e-8;

/// Units of a contact's dimensionless quantities, see NipEquations.
struct ContactUnits {
  /// `compliance`: N, or its instantaneous part, 1/stress.
  ContactUnits(const NipShape& shape, double compliance);
  double length;
  double displacement;
  double pressure;
  double load;
  double creep;
};

/// Rounding of a tangential displacement, relative to the size of its parts over the contact. The parts may cancel, and
/// near the reference place the displacement is a small difference of integrals of that size.
inline constexpr double difference_rounding = 0x1p-48;

/// The factor by which a normal displacement has decayed at a distance (half-thicknesses) from the contact; 1 at
/// negative distances. I1 and I3 decay with the exponent 2.1 (the zero of sinh 2z + 2z next to 0), the trace of a
/// memory with its rate if that is less.
double faded(double distance, double rate = 2);

/// `estimate` in a unit; never -0.
Estimate times(double unit, const Estimate& estimate);

/// BadInput unless the accuracy is from 1e-13 to 0.1.
void check_contact_accuracy(double accuracy);
/// BadInput unless 1e-8 <= L/B <= 1e4 and L <= R, beyond which the parabola is no circle.
void check_contact_length(const NipShape& shape, double contact_length);
/// BadInput unless finite and > 0.
void check_contact_load(double load);
/// BadInput that names the load unless the length found for it is allowed.
void check_length_of_load(const NipShape& shape, double load, double contact_length);
/// BadInput unless finite.
void check_position(double y);

}  // namespace nipref::fast
