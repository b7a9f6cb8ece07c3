#pragma once
#include <variant>

#include <nipref/data/problem/elastic_nip.hpp>

namespace nipref::data {

/// The shear's resultant T that the rollers pass on to each face of the sheet, along Y: > 0 pushes the sheet towards the
/// entry. At most the friction coefficient times the load in size. traction.force_per_length
struct GivenTraction {
  double force_per_length;  ///< force per unit width
};

/// The strain of the sheet's surface where it sticks, against the mean of those far ahead and far behind.
/// traction.creep_ratio
struct GivenCreep {
  double creep_ratio;  ///< finite, dimensionless
};

using Drive = std::variant<GivenTraction, GivenCreep>;

/// An elastic sheet that rolls steadily between two identical rigid cylinders with Coulomb's friction: where the surface
/// sticks its strain is the creep ratio, where it slips the shear is the friction coefficient times the pressure, against
/// the slip. Between the thesis's Case B, no friction, and its Case A, no slip; no publication of the seeds has it.
struct PartialSlipNip : ElasticNip {
  double friction_coefficient;  ///< mu, > 0 and finite; friction.coefficient
  Drive drive;
};

}  // namespace nipref::data
