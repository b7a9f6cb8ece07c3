#pragma once
#include <optional>
#include <variant>

#include <nipref/data/material/viscoelastic.hpp>

namespace nipref::data {

/// Friction between roller and sheet: none (complete slip, the thesis's Case B) or full (no slip anywhere, its
/// Case A). (thesis chapter II, conditions (iii) and (iv))
enum class Friction { none, full };

/// What line loads do with an elastic sheet on the roller: no friction at all (the thesis's Case B), or none of slip
/// (Case A) with a creep ratio, finite, that is given or chosen as the thesis does: of the least size for which no
/// normal load is negative, the shear loads of a side have one sign and their part of the normal load does not fall
/// outwards. (thesis 5.5)
struct Grip {
  enum class Creep { none, given, thesis } kind = Creep::none;
  double creep = 0;  ///< the given one
};

/// An elastic sheet between two identical rigid cylinders, plane strain, any consistent units. (thesis
/// chapters II, V)
struct ElasticNip {
  double roller_radius;    ///< R, > 0, unit of length
  double sheet_thickness;  ///< B = 2b, > 0, unit of length
  ElasticMaterial material;

  [[nodiscard]] double half_thickness() const { return sheet_thickness / 2; }
  /// Throws BadInput unless the values are physical.
  void check() const;
};

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

/// A viscoelastic sheet rolled between two identical rigid cylinders, plane strain, any consistent units.
/// (thesis chapters II, VI, VII)
struct ViscoelasticNip {
  double roller_radius;    ///< R, > 0, unit of length
  double sheet_thickness;  ///< B = 2b, > 0, unit of length
  ViscoelasticMaterial material;
  double speed;  ///< F0 of the sheet, > 0, length/time

  [[nodiscard]] double half_thickness() const { return sheet_thickness / 2; }
  /// Throws BadInput unless the values are physical and theta1 gives way at once.
  void check() const;
};

/// The thesis's line loads at the centres of equal elements of a viscoelastic nip, which has no symmetry: all of them started
/// at once at a distance before the nip. (thesis 2.2, 7.1-7.17) Each solver says which it takes.
struct ViscoelasticLineLoads {
  int leading_elements;  ///< m1, on the entry side; method.leading_elements
  /// m2, on the exit side; method.trailing_elements. Absent: from m1 down the first that leaves no tension under the load
  /// (section 2.5), which needs a given load.
  std::optional<int> trailing_elements;
  /// C_L, how far before the nip the loads started, > 0, half-thicknesses; method.approach_lengths
  double approach_lengths;
  /// 0: exact kernels; else as many terms of their series, 1 to 500; method.residue_terms
  int residue_terms = 0;
  /// Of theta1 + theta2 at once, 0 to 1: the sum after a load has passed ends with its first term below it.
  double smallest_term = 0;
};

}  // namespace nipref::data
