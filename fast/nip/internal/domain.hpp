#pragma once
#include <string>

#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

/// The shape of a nip. The domain and the units of its contact depend on it and on the material.
struct NipShape {
  double roller_radius;
  double sheet_thickness;
};

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

/// `estimate` in a unit; never -0.
Estimate times(double unit, const Estimate& estimate);

/// BadInput unless the accuracy is from 1e-13 to 0.1.
void check_contact_accuracy(double accuracy);
/// BadInput unless 1e-8 <= L/B <= 1e4 and L <= R; a parabola does not stand for the circle in a longer contact.
void check_contact_length(const NipShape& shape, double contact_length);
/// BadInput that names the load unless the length found for it is allowed.
void check_length_of_load(const NipShape& shape, double load, double contact_length);

}  // namespace nipref::fast
