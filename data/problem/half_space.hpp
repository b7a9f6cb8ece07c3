#pragma once
#include <optional>
#include <variant>

#include <nipref/data/material/solids.hpp>
#include <nipref/data/material/stiffness.hpp>
#include <nipref/data/problem/places.hpp>

namespace nipref::data {

// Bodies that slide or roll fast over a half-space. Units: any consistent ones; the unit of speed is that of
// sqrt(stress/density).

/// A rigid body with an elliptic-paraboloid tip: C1 x1^2 + C2 x2^2 + C3 (x3 + 1/sqrt C3)^2 = 1 has the radii
/// of curvature sqrt(C3)/C1 and sqrt(C3)/C2. (brock2012 19)
struct RigidDie {
  double radius_along;   ///< in the plane of the motion, > 0; die.radius_along
  double radius_across;  ///< > 0; die.radius_across
};

/// A rigid sphere that rolls without slip. (brock2012 37)
struct RigidRollingSphere {
  double radius;  ///< > 0; rolling_sphere.radius
};

/// An elastic sphere that slides. (brock2013 23)
struct ElasticSphere {
  double radius;  ///< > 0; sphere.radius
  IsotropicSolid solid;
  /// Whether the compliance of the sphere is that for a patch that moves over its surface at the sliding speed, as in
  /// the seed. By default it is the static one, because the patch does not move on the sphere. sphere.patch
  bool moving_patch = false;
};

struct TransverselyIsotropicBody {
  TransverselyIsotropicSolid solid;
  SymmetryAxis axis;  ///< half_space.axis

  void check() const { solid.check(); }
};

/// The force that presses the body down.
struct GivenNormalForce {
  double force;  ///< > 0; load.normal_force
};

/// The extent of the contact along the motion, through the point of first touch.
struct GivenSpan {
  double along;  ///< > 0 and at most the smallest radius; contact.span_along
};

/// How the contour of the contact is found.
enum class ContourRule {
  exact,             ///< frictionless: semi-ellipsoidal pressure on an ellipse solves the problem
  stationary_force,  ///< the seeds' rule for lines through the centre (brock2012 33, brock2013 33)
  similar_contour,  ///< the contact is similar to the contours of the body, L(psi) = L1 sqrt(C1/A(psi)) (brock2012 30)
};

struct HalfSpaceProblem {
  std::variant<RigidDie, RigidRollingSphere, ElasticSphere> body;
  std::variant<IsotropicSolid, TransverselyIsotropicBody, Stiffness> half_space;
  double speed = 0;  ///< >= 0, subcritical; sliding.speed or rolling.speed
  /// The angle of the motion from x1, degrees, |direction| <= 90. An axis of symmetry in the surface lies along x2.
  /// sliding.direction
  double direction = 0;
  double friction = 0;  ///< coefficient, 0 to 1000; sliding.friction
  std::variant<GivenNormalForce, GivenSpan> given;
  ContourRule rule = ContourRule::exact;
  /// The angles psi - direction, degrees, at which spans are wanted; if `line` is given, the positions on that line.
  std::optional<Profile> profile = {};
  /// The angle psi - direction of the line along which pressure and shear are wanted, degrees; profile.direction
  std::optional<double> line = {};
  double depth =
      0;  ///< depth of that line below the surface, for displacements, >= 0, unit of length; profile.depth
};

}  // namespace nipref::data
