#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/scene/internal/half_space.hpp>

namespace nipref::data {
namespace {

using Body = decltype(HalfSpaceProblem::body);
using HalfSpace = decltype(HalfSpaceProblem::half_space);

IsotropicSolid read_isotropic(const TomlTable& table) {
  return {table.number("shear"), table.number("poisson"), table.number("density")};
}

HalfSpace read_half_space(const TomlTable& table) {
  if (table.choice("model", {"isotropic", "transversely-isotropic"}) == "isotropic") {
    table.allow({"model", "shear", "poisson", "density"});
    return read_isotropic(table);
  }
  table.allow({"model", "axis", "c11", "c33", "c13", "c44", "c66", "density"});
  const bool is_normal = table.choice("axis", {"normal", "in-plane"}) == "normal";
  return TransverselyIsotropicBody{{table.number("c11"), table.number("c33"), table.number("c13"),
                                    table.number("c44"), table.number("c66"), table.number("density")},
                                   is_normal ? SymmetryAxis::normal : SymmetryAxis::in_plane};
}

Body read_body(const TomlTable& file, const SceneOrigin& origin) {
  const bool bodies[] = {file.has("die"), file.has("rolling_sphere"), file.has("sphere")};
  if (std::ranges::count(bodies, true) != 1) {
    origin.refuse("die", file.has("die") ? "(beside another body)" : "(missing)",
                  "there must be one of die, rolling_sphere and sphere");
  }
  if (file.has("die")) {
    const TomlTable die = file.table("die");
    die.allow({"radius_along", "radius_across"});
    return RigidDie{die.number("radius_along"), die.number("radius_across")};
  }
  if (file.has("rolling_sphere")) {
    const TomlTable sphere = file.table("rolling_sphere");
    sphere.allow({"radius"});
    return RigidRollingSphere{sphere.number("radius")};
  }
  const TomlTable sphere = file.table("sphere");
  sphere.allow({"radius", "shear", "poisson", "density", "patch"});
  const bool moving = sphere.has("patch") && sphere.choice("patch", {"fixed", "moving"}) == "moving";
  return ElasticSphere{sphere.number("radius"), read_isotropic(sphere), moving};
}

void read_motion(const TomlTable& file, HalfSpaceProblem& problem) {
  if (std::holds_alternative<RigidRollingSphere>(problem.body)) {
    const TomlTable rolling = file.table("rolling");
    rolling.allow({"speed"});
    problem.speed = rolling.number("speed");
    return;
  }
  const TomlTable sliding = file.table("sliding");
  sliding.allow({"speed", "direction", "friction"});
  problem.speed = sliding.number("speed");
  if (sliding.has("direction")) problem.direction = sliding.number("direction");
  if (sliding.has("friction")) problem.friction = sliding.number("friction");
}

void read_given(const TomlTable& file, const SceneOrigin& origin, HalfSpaceProblem& problem) {
  if (file.has("load") == file.has("contact")) {
    origin.refuse("load", file.has("load") ? "(beside contact)" : "(missing)",
                  "there must be either [load] normal_force or [contact] span_along");
  }
  if (file.has("load")) {
    const TomlTable load = file.table("load");
    load.allow({"normal_force"});
    problem.given = GivenNormalForce{load.number("normal_force")};
    return;
  }
  const TomlTable contact = file.table("contact");
  contact.allow({"span_along"});
  problem.given = GivenSpan{contact.number("span_along")};
}

ContourRule read_rule(const TomlTable& method) {
  method.allow({"kind"});
  return method.choice("kind", {"exact", "stationary-force"}) == "exact" ? ContourRule::exact
                                                                         : ContourRule::stationary_force;
}

void require(bool holds, const SceneOrigin& origin, std::string_view key, double value,
             std::string_view allowed) {
  if (!holds) origin.refuse(key, value, allowed);
}

void check_positive(double value, const SceneOrigin& origin, std::string_view key) {
  require(std::isfinite(value) && value > 0, origin, key, value, "must be finite and > 0");
}

/// The solids' own checks name their members, which are the keys of their table.
template <class Solid>
void check_solid(const Solid& solid, const SceneOrigin& origin, std::string_view table) {
  try {
    solid.check();
  } catch (const BadInput& error) {
    const std::string_view message = error.what();
    origin.refuse_as(std::string(table) + "." + std::string(message.substr(0, message.find(' '))), error);
  }
}

/// Gives the smallest radius of curvature.
struct BodyCheck {
  const SceneOrigin& origin;

  double operator()(const RigidDie& die) const {
    check_positive(die.radius_along, origin, "die.radius_along");
    check_positive(die.radius_across, origin, "die.radius_across");
    return std::min(die.radius_along, die.radius_across);
  }
  double operator()(const RigidRollingSphere& sphere) const {
    check_positive(sphere.radius, origin, "rolling_sphere.radius");
    return sphere.radius;
  }
  double operator()(const ElasticSphere& sphere) const {
    check_positive(sphere.radius, origin, "sphere.radius");
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
};

struct GivenCheck {
  const SceneOrigin& origin;
  double smallest_radius;

  void operator()(const GivenNormalForce& load) const {
    check_positive(load.force, origin, "load.normal_force");
  }
  void operator()(const GivenSpan& span) const {
    check_positive(span.along, origin, "contact.span_along");
    require(
        span.along <= smallest_radius, origin, "contact.span_along", span.along,
        "must be at most the body's smallest radius: beyond it a paraboloid no longer stands for the body");
  }
};

void check_viscoelastic(const HalfSpaceProblem& problem, const SceneOrigin& origin) {
  const bool rolls = std::holds_alternative<RigidRollingSphere>(problem.body);
  if (rolls && !std::holds_alternative<IsotropicSolid>(problem.half_space)) {
    origin.refuse("half_space.model", "transversely-isotropic", "must be isotropic under a rolling sphere");
  }
}

void check_rule(const HalfSpaceProblem& problem, const SceneOrigin& origin) {
  if (problem.rule != ContourRule::exact) return;
  if (std::holds_alternative<RigidRollingSphere>(problem.body)) {
    origin.refuse("method.kind", "exact",
                  "must be stationary-force for a rolling sphere: no exact solution is known");
  }
  require(problem.friction == 0, origin, "sliding.friction", problem.friction,
          "must be 0 with the exact method, which is frictionless");
}

}  // namespace

void check_half_space_wanted(const HalfSpaceProblem& problem, const std::string& name, std::string_view key,
                             const SceneOrigin& origin) {
  constexpr std::array<std::string_view, 3> of_the_ellipse{"axis_ratio", "orientation", "approach"};
  if (problem.rule == ContourRule::exact || !std::ranges::count(of_the_ellipse, name)) return;
  origin.refuse(key, name, "must be wanted of the exact method only: the other does not define it");
}

HalfSpaceProblem read_half_space_problem(const TomlTable& file, const SceneOrigin& origin) {
  file.allow({"title", "wanted", "accuracy", "half_space", "die", "rolling_sphere", "sphere", "sliding",
              "rolling", "load", "contact", "method", "profile"});
  HalfSpaceProblem problem{.body = read_body(file, origin),
                           .half_space = read_half_space(file.table("half_space")),
                           .given = {},
                           .profile = {}};
  read_motion(file, problem);
  read_given(file, origin, problem);
  problem.rule = read_rule(file.table("method"));
  if (file.has("profile")) problem.profile = read_profile(file.table("profile"), origin);
  return problem;
}

void check_half_space_problem(const HalfSpaceProblem& problem, const SceneOrigin& origin) {
  const double smallest_radius = std::visit(BodyCheck{origin}, problem.body);
  std::visit(HalfSpaceCheck{origin}, problem.half_space);
  const bool rolls = std::holds_alternative<RigidRollingSphere>(problem.body);
  require(std::isfinite(problem.speed) && problem.speed >= 0, origin,
          rolls ? "rolling.speed" : "sliding.speed", problem.speed, "must be finite and >= 0");
  require(std::fabs(problem.direction) <= 90, origin, "sliding.direction", problem.direction,
          "must be from -90 to 90 degrees");
  require(std::isfinite(problem.friction) && problem.friction >= 0, origin, "sliding.friction",
          problem.friction, "must be finite and >= 0");
  std::visit(GivenCheck{origin, smallest_radius}, problem.given);
  check_viscoelastic(problem, origin);
  check_rule(problem, origin);
}

Profile read_profile(const TomlTable& profile, const SceneOrigin& origin) {
  profile.allow({"points", "positions"});
  if (profile.has("points") == profile.has("positions")) {
    origin.refuse("profile", profile.has("points") ? "(points and positions)" : "(empty)",
                  "must hold points or positions, one of the two");
  }
  if (profile.has("points")) return EvenlySpaced{profile.whole("points")};
  return Positions{profile.numbers("positions")};
}

}  // namespace nipref::data
