#pragma once
#include <nipref/ref/number/estimated.hpp>

namespace nipref::ref {

/// A place inside the sheet of a nip.
struct InnerPoint {
  double y;      ///< along the sheet, as in the contact's profiles, unit of length
  double depth;  ///< across it over its half thickness, from -1 to 1; 0 is the middle plane
};

/// Stresses in plane strain there, tension positive, unit of stress. They follow from the tractions on the faces alone
/// and do not depend on the material.
struct InnerStresses {
  Estimated across;  ///< sigma_x
  Estimated along;   ///< sigma_y
  Estimated shear;   ///< tau_xy

  /// Principal stresses in the plane of rolling, the higher and the lower, and half their difference.
  [[nodiscard]] Estimated highest() const;
  [[nodiscard]] Estimated lowest() const;
  [[nodiscard]] Estimated maximum_shear() const;
};

/// The largest maximum_shear in the sheet and where it is; of places that are equal by symmetry one at y, depth >= 0.
struct GreatestShear {
  Estimated value;
  Estimated y, depth;
};

}  // namespace nipref::ref
