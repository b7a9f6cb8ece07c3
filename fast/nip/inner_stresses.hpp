#pragma once
#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

/// A place inside the sheet of a nip.
struct InnerPoint {
  double y;      ///< along the sheet, as in the contact's profiles, any finite value, unit of length
  double depth;  ///< across it over its half thickness, from -1 to 1; 0 is the middle plane
};

/// Stresses in plane strain, tension positive, unit of stress. They follow from the tractions on the faces alone and do
/// not depend on the material: compatibility of the strains of an isotropic material, elastic or viscoelastic, makes
/// sigma_x + sigma_y harmonic at all times, and equilibrium and the tractions determine the rest.
struct InnerStresses {
  Estimate across;  ///< sigma_x
  Estimate along;   ///< sigma_y
  Estimate shear;   ///< tau_xy

  /// Principal stresses in the plane of rolling, the higher and the lower, and half their difference.
  [[nodiscard]] Estimate highest() const;
  [[nodiscard]] Estimate lowest() const;
  [[nodiscard]] Estimate maximum_shear() const;
};

/// Displacements inside an elastic sheet, unit of length.
struct InnerDisplacements {
  Estimate across;  ///< u, towards the middle plane from both sides, where it is 0
  Estimate along;   ///< v, along Y, relative to the face at Y = 0
};

/// The largest maximum_shear in the sheet and its place; of places equal by symmetry the one with y >= 0, depth >= 0. Of
/// two maxima nearer to each other than a step of the grid on which the search begins, 1/24 of the half-length or of the
/// half-thickness, one may be missed.
struct GreatestShear {
  Estimate value;
  Estimate y, depth;
};

}  // namespace nipref::fast
