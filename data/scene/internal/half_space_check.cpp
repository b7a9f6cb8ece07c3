#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/scene/internal/half_space_check.hpp>
#include <nipref/data/scene/internal/profile.hpp>
#include <nipref/data/scene/internal/require.hpp>
#include <nipref/data/scene/results.hpp>

namespace nipref::data {
namespace {

/// The solids' own checks name their members, which are the keys of their table.
template <class Solid>
void check_solid(const Solid& solid, const SceneOrigin& origin, std::string_view table) {
  try {
    solid.check();
  } catch (const BadInput& error) {
    origin.refuse_as(std::string(table) + "." + error.argument(), error);
  }
}

/// Gives the smallest radius of curvature.
struct BodyCheck {
  const SceneOrigin& origin;

  double operator()(const RigidDie& die) const {
    check_domain(die.radius_along, origin, "die.radius_along");
    check_domain(die.radius_across, origin, "die.radius_across");
    return std::min(die.radius_along, die.radius_across);
  }
  double operator()(const RigidRollingSphere& sphere) const {
    check_domain(sphere.radius, origin, "rolling_sphere.radius");
    return sphere.radius;
  }
  double operator()(const ElasticSphere& sphere) const {
    check_domain(sphere.radius, origin, "sphere.radius");
    check_solid(sphere.solid, origin, "sphere");
    return sphere.radius;
  }
};

struct HalfSpaceCheck {
  const SceneOrigin& origin;

  void operator()(const IsotropicSolid& solid) const { check_solid(solid, origin, "half_space"); }
  void operator()(const TransverselyIsotropicBody& body) const {
    check_solid(body.solid, origin, "half_space");
  }
  void operator()(const Stiffness& solid) const { check_solid(solid, origin, "half_space"); }
};

struct GivenContactCheck {
  const SceneOrigin& origin;
  double smallest_radius;

  void operator()(const GivenNormalForce& load) const {
    check_domain(load.force, origin, "load.normal_force");
  }
  void operator()(const GivenSpan& span) const {
    check_domain(span.along, origin, "contact.span_along");
    require(
        span.along <= smallest_radius, origin, "contact.span_along", span.along,
        "must be at most the body's smallest radius: beyond it a paraboloid no longer stands for the body");
  }
};

void check_rolling(const HalfSpaceProblem& problem, const SceneOrigin& origin) {
  const bool rolls = std::holds_alternative<RigidRollingSphere>(problem.body);
  if (rolls && !std::holds_alternative<IsotropicSolid>(problem.half_space)) {
    origin.refuse(
        "half_space.model",
        std::holds_alternative<Stiffness>(problem.half_space) ? "anisotropic" : "transversely-isotropic",
        "must be isotropic under a rolling sphere");
  }
}

void check_rule(const HalfSpaceProblem& problem, const SceneOrigin& origin) {
  if (problem.rule == ContourRule::stationary_force) return;
  if (std::holds_alternative<RigidRollingSphere>(problem.body)) {
    origin.refuse(
        "method.kind", problem.rule == ContourRule::exact ? "exact" : "similar-contour",
        "must be stationary-force for a rolling sphere: no exact solution is known, and (30) is a die's");
  }
  if (problem.rule != ContourRule::exact) return;
  require(
      problem.friction == 0, origin, "sliding.friction", problem.friction,
      "must be 0 with the exact method: friction raises the surface on one side and lowers it on the other, so that no "
      "semi-ellipsoidal pressure fits the body");
}

}  // namespace

void check_half_space_wanted(const HalfSpaceProblem& problem, const SceneResult& result, std::string_view key,
                             const SceneOrigin& origin) {
  const auto is_one_of = [&result](std::initializer_list<ResultId> ids) {
    return std::ranges::find(ids, result.id) != ids.end();
  };
  const bool is_displacement = is_one_of(
      {ResultId::normal_displacement, ResultId::tangential_displacement, ResultId::transverse_displacement});
  if (problem.rule != ContourRule::exact &&
      (is_displacement || is_one_of({ResultId::axis_ratio, ResultId::orientation, ResultId::approach})))
    origin.refuse(
        key, result.name,
        "must be wanted of the exact method only: the others fit the body on each line by itself, and their "
        "pressures together press the surface into no body's shape");
  if (problem.rule == ContourRule::similar_contour && result.id == ResultId::peak_pressure)
    origin.refuse(key, result.name,
                  "must be left out with similar-contour: each line has its own, peak_on_line");
  if (!std::holds_alternative<RigidRollingSphere>(problem.body) &&
      is_one_of({ResultId::creep, ResultId::compressed_radius}))
    origin.refuse(key, result.name, "must be wanted of a rolling sphere only");
  if (!problem.profile || result.shape != Shape::profile) return;
  if (result.is_along_line() && !problem.line)
    origin.refuse(key, result.name,
                  "must be wanted with profile.direction, the angle of its line from the motion");
  if (problem.depth > 0 && !is_displacement)
    origin.refuse(key, result.name,
                  "must be wanted without profile.depth: only displacements are known below the surface");
  if (!result.is_along_line() && problem.line)
    origin.refuse(key, result.name, "must be wanted without profile.direction: it belongs to whole lines");
}

void check_half_space_problem(const HalfSpaceProblem& problem, const SceneOrigin& origin) {
  const double smallest_radius = std::visit(BodyCheck{origin}, problem.body);
  std::visit(HalfSpaceCheck{origin}, problem.half_space);
  const bool rolls = std::holds_alternative<RigidRollingSphere>(problem.body);
  check_domain(problem.speed, origin, rolls ? "rolling.speed" : "sliding.speed");
  check_domain(problem.direction, origin, "sliding.direction");
  check_domain(problem.friction, origin, "sliding.friction");
  std::visit(GivenContactCheck{origin, smallest_radius}, problem.given);
  check_rolling(problem, origin);
  check_rule(problem, origin);
  if (problem.profile) check_profile(*problem.profile, origin);
  if (problem.line) check_domain(*problem.line, origin, "profile.direction");
  check_domain(problem.depth, origin, "profile.depth");
}

}  // namespace nipref::data
