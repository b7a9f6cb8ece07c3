#pragma once
#include <optional>
#include <variant>

#include <nipref/data/material/viscoelastic.hpp>

namespace nipref::data {

/// Friction between roller and sheet: none (complete slip, the thesis's Case B) or full (no slip anywhere, its
/// Case A). (thesis chapter II, conditions (iii) and (iv))
enum class Friction { none, full };

/// The friction between line loads and an elastic sheet: none (the thesis's Case B), or full (Case A) with a creep ratio
/// that is given, or chosen as in the thesis. The thesis chooses the creep ratio of least size for which no normal load
/// is negative, the shear loads on one side of the nip have one sign, and the ratio of shear load to normal load does
/// not fall outwards. (thesis 5.5)
struct LineLoadFriction {
  enum class Kind { none, given_creep, thesis_creep } kind = Kind::none;
  double creep = 0;  ///< the given creep ratio, finite

  static constexpr LineLoadFriction full(double creep) { return {Kind::given_creep, creep}; }
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

/// The resultant T of the shear that the rollers exert on each face of the sheet, along Y. A positive T pushes the
/// sheet towards the entry. |T| is at most the friction coefficient times the load. traction.force_per_length
struct GivenTraction {
  double force_per_length;  ///< force per unit width
};

/// The strain of the surface of the sheet where it sticks, less the mean of its strains far ahead and far behind.
/// traction.creep_ratio
struct GivenCreep {
  double creep_ratio;  ///< finite, dimensionless
};

using Drive = std::variant<GivenTraction, GivenCreep>;

/// An elastic sheet that rolls steadily between two identical rigid cylinders with Coulomb's friction. Where the
/// surface sticks, its strain is the creep ratio. Where it slips, the shear is the friction coefficient times the
/// pressure, against the slip. It lies between the thesis's Case B, no friction, and Case A, no slip; no seed has it.
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
  /// Throws BadInput unless the values are physical and theta1 has an instantaneous part.
  void check() const;
};

/// The thesis's line loads at the centres of equal elements of a viscoelastic nip, which is not symmetric. All loads
/// start together at a distance before the nip. Each solver says which numbers it accepts. (thesis 2.2, 7.1-7.17)
struct ViscoelasticLineLoads {
  int leading_elements;  ///< m1, on the entry side; method.leading_elements
  /// m2, on the exit side; method.trailing_elements. If it is absent, it is the first number, counted from m1
  /// downwards, that leaves no tension under the load (section 2.5); the load must then be given.
  std::optional<int> trailing_elements;
  /// C_L, the distance before the nip at which the loads start, > 0, half-thicknesses; method.approach_lengths
  double approach_lengths;
  /// 0: exact kernels; 1 to 500: kernels as sums of so many terms of their series; method.residue_terms
  int residue_terms = 0;
  /// The sum after a load has passed ends with its first term below this part, 0 to 1, of theta1 + theta2
  /// (instantaneous).
  double smallest_term = 0;
};

}  // namespace nipref::data
