#pragma once
#include <variant>

#include <nipref/data/problem/elastic_nip.hpp>

namespace nipref::data {

/// The tangential force per unit width by which the rollers push the sheet towards the leading side.
struct GivenTraction {
  double force_per_length;
};

/// The strain of the sheet's surface where it sticks to the rollers, dimensionless.
struct GivenCreep {
  double creep_ratio;
};

using Drive = std::variant<GivenTraction, GivenCreep>;

/// An elastic nip in steady rolling with Coulomb friction: the shear is at most the coefficient times the pressure, and as
/// large where the surfaces slip.
struct PartialSlipNip {
  ElasticNip nip;
  double friction_coefficient;  ///< > 0, dimensionless
  Drive drive;
};

}  // namespace nipref::data
