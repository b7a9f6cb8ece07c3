#pragma once
#include <cmath>

#include <nipref/data/material/solids.hpp>
#include <nipref/data/table/table.hpp>
#include <nipref/fast/half_space/direction.hpp>
#include <nipref/fast/half_space/response.hpp>
#include <nipref/verify/catalogue/half_space/internal/printed.hpp>

namespace nipref::verify {

/// The two bodies of (brock2013) as a table's header states them, GPa and kg/m^3.
struct SphereOnHalfSpace {
  data::IsotropicSolid sphere;
  data::TransverselyIsotropicSolid half_space;
  ScaledModuli scaled;

  explicit SphereOnHalfSpace(const data::Table& table);

  /// v_0, the sphere's shear wave speed.
  [[nodiscard]] double speed_unit() const { return std::sqrt(sphere.shear / sphere.density); }

  /// Both bodies together, by the angle from the motion; c0 is speed over that of the sphere's shear waves.
  /// The patch moves in the sphere, as the paper has it.
  [[nodiscard]] fast::SurfaceResponse in_contact(data::SymmetryAxis axis, fast::Direction motion,
                                                 double c0) const;
};

}  // namespace nipref::verify
