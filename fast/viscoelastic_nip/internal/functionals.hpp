#pragma once
#include <nipref/fast/viscoelastic_nip/internal/pressure.hpp>

namespace nipref::fast {

// What follows from a solved contact of a viscoelastic nip, in its dimensionless units.

/// Approach of roller and middle plane: u under the line through the centres.
double indentation(const ViscoelasticPressure& contact);

/// u at the trailing end.
double trailing_displacement(const ViscoelasticPressure& contact);

/// Distance of the pressure's resultant from the line through the centres, towards the leading side: R/b
/// times the coefficient of rolling resistance.
double eccentricity(const ViscoelasticPressure& contact);
/// Of what a ladder estimates of its error: its two parts, offset and moment, cancel.
inline constexpr double eccentricity_error_margin = 2;

double peak_pressure(const ViscoelasticPressure& contact);
/// About where that is: to a twelfth of a panel.
ContactPlace place_of_peak(const ViscoelasticPressure& contact);

}  // namespace nipref::fast
