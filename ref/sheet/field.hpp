#pragma once
#include <nipref/data/problem/sheet_load.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

// The field inside an elastic sheet of half thickness b = 1 under a line load of unit intensity on each face, in plane
// strain, to any accuracy. x runs through the thickness, y along the sheet. The loads act at y = 0 on x = +-1: a normal
// load presses, a shear load acts along +y on both faces.
//
// alpha = y, |alpha| <= 1000. depth = x, -1 <= depth <= 1; 0 is the middle plane. alpha != 0 at depth +-1, where the
// load acts. digits 16 to 1000; hundreds of digits take seconds for |alpha| < 1. Every function promises an Enclosure:
// error <= 10^-digits min(1, |truth|), proven (internal/field_integral.hpp). Other arguments throw data::BadInput.

/// Stresses in 1/half-thickness, tension positive. (thesis 3.19, 3.20, 4.3; for shear loads 3.26, 3.27, 4.14)
Enclosure sheet_across(const Exact& alpha, const Exact& depth, data::SheetLoad load,
                       int digits);                                                               ///< sigma_x
Enclosure sheet_along(const Exact& alpha, const Exact& depth, data::SheetLoad load, int digits);  ///< sigma_y
Enclosure sheet_shear(const Exact& alpha, const Exact& depth, data::SheetLoad load, int digits);  ///< tau_xy

/// Derivatives with respect to alpha of a face's displacements un, vn and vs over theta1 + theta2, alpha != 0. The
/// derivative of us is minus the derivative of vn. (thesis 2.8, 4.8, 4.19)
Enclosure un_slope(const Exact& alpha, data::Derivative order, int digits);
Enclosure vn_slope(const Exact& alpha, data::Derivative order, int digits);
Enclosure vs_slope(const Exact& alpha, data::Derivative order, int digits);

/// Displacement along +x over theta1 + theta2, 0 on the middle plane. At depth -1 it is un or us, at depth 1 it is -un
/// or -us. -1 < poisson <= 1/2.
Enclosure sheet_u(const Exact& alpha, const Exact& depth, data::SheetLoad load, const Exact& poisson,
                  int digits);

/// Displacement along +y over theta1 + theta2, relative to the point eta of the middle plane, |eta| <= 1000. At depth
/// +-1 it is vn or vs.
Enclosure sheet_v(const Exact& alpha, const Exact& eta, const Exact& depth, data::SheetLoad load,
                  const Exact& poisson, int digits);

}  // namespace nipref::ref
