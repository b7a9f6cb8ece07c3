#pragma once
#include <nipref/data/problem/sheet_load.hpp>

// Stresses and displacements inside an elastic sheet of half-thickness b = 1 under a line load of unit intensity on each
// face, in plane strain. x runs through the thickness, y along the sheet. The loads act at y = 0 on x = +-1; a normal load
// presses, a shear load acts along +y on both faces.
//
//   alpha    y, in half-thicknesses: any finite double
//   depth    x, in half-thicknesses: -1 <= depth <= 1, 0 is the middle plane. 1 - |depth| is the distance from the
//            surface: as it is exact in double, values are good at any distance from the load
//   eta      place on the middle plane where v is 0, in half-thicknesses: any finite double
//   poisson  -1 < poisson <= 1/2
//   error    at most 8 units in the last place of the scale, which is the sum of the magnitudes of each half-plane's
//            field and of the slowest residue terms; where the value is 0 by symmetry, the scale is 0, too. See verify's
//            catalogue.
//   bad input  nan, infinities, arguments outside these domains, and |alpha| < 1e-300 at depth +-1, where the load acts,
//            1e-150 for second derivatives: data::BadInput

namespace nipref::fast {

/// Stresses, in 1/half-thickness for a unit load; tension is positive. They do not depend on the material.
struct SheetStresses {
  double across;  ///< sigma_x
  double along;   ///< sigma_y
  double shear;   ///< tau_xy
};

/// The stresses. Thesis (3.19), (3.20), (4.3); under a shear load (3.26), (3.27), (4.14).
SheetStresses sheet_stresses(double alpha, double depth, data::SheetLoad load);

// Derivatives with respect to alpha of a face's displacements un, vn and vs, divided by theta1 + theta2, dimensionless
// (thesis 2.8). That of us is minus that of vn. The scale is the value, or the amplitude of the slowest residue term.
double un_slope(double alpha, data::Derivative order);
double vn_slope(double alpha, data::Derivative order);
double vs_slope(double alpha, data::Derivative order);

/// The displacement along +x divided by theta1 + theta2, dimensionless; 0 on the middle plane. At depth -1 it is un or
/// us (thesis 4.8, 4.19a), which are positive towards the middle plane; at depth 1 it is minus un or us.
double sheet_u(double alpha, double depth, data::SheetLoad load, double poisson);

/// The displacement along +y divided by theta1 + theta2, dimensionless, relative to the point eta of the middle plane.
/// At depth +-1 it is vn or vs (thesis 4.8, 4.19b).
double sheet_v(double alpha, double eta, double depth, data::SheetLoad load, double poisson);

}  // namespace nipref::fast
