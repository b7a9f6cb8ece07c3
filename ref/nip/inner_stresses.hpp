#pragma once
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

/// A place inside the sheet of a nip.
struct InnerPoint {
  double y;      ///< Y as in the contact's profiles, unit of length
  double depth;  ///< distance from the middle plane over the half-thickness, from -1 to 1
};

/// The stresses at such a place in plane strain, tension positive, unit of stress. They follow from the tractions alone
/// and do not depend on the material.
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
  Estimate across;  ///< u, positive towards the middle plane on both of its sides
  Estimate along;   ///< v along Y, relative to the face at Y = 0
};

/// The largest maximum_shear in the sheet and its place; of places equal by symmetry, the one with y and depth >= 0. Of
/// two maxima nearer to each other than a twentieth of the half-length or the half-thickness one may be missed.
struct GreatestShear {
  Estimate value;
  Estimate y, depth;
};

}  // namespace nipref::ref
