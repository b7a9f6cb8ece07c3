#include <algorithm>

#include <nipref/data/scene/internal/check.hpp>
#include <nipref/data/scene/internal/read.hpp>

namespace nipref::data {
namespace {

using Body = decltype(HalfSpaceProblem::body);
using HalfSpace = decltype(HalfSpaceProblem::half_space);

bool rolls(const HalfSpaceProblem& problem) {
  return std::holds_alternative<RigidRollingSphere>(problem.body);
}

IsotropicSolid read_isotropic(const SceneTable& table) {
  return {table.number("shear"), table.number("poisson"), table.number("density")};
}

/// Reads the stiffness, given by the upper triangle of its matrix in Voigt notation, row by row.
Stiffness read_stiffness(const SceneTable& table, const SceneOrigin& origin) {
  table.allow("anisotropic");
  const std::vector<double> upper = table.numbers("stiffness");
  if (upper.size() != upper_triangle.size()) {
    origin.refuse("half_space.stiffness", std::to_string(upper.size()) + " numbers",
                  "must be 21 numbers: C11, C12 ... C16, C22, C23 ... C66");
  }
  Stiffness solid{{}, table.number("density")};
  set_symmetric(solid.voigt, upper.begin());
  return solid;
}

HalfSpace read_half_space(const SceneTable& table, const SceneOrigin& origin) {
  const std::string model = table.choice("model");
  if (model == "isotropic") {
    table.allow("isotropic");
    return read_isotropic(table);
  }
  if (model == "anisotropic") return read_stiffness(table, origin);
  table.allow("transversely-isotropic");
  const bool is_normal = table.choice("axis") == "normal";
  return TransverselyIsotropicBody{{table.number("c11"), table.number("c33"), table.number("c13"),
                                    table.number("c44"), table.number("c66"), table.number("density")},
                                   is_normal ? SymmetryAxis::normal : SymmetryAxis::in_plane};
}

Body read_body(const SceneTable& file, const SceneOrigin& origin) {
  const bool bodies[] = {file.has("die"), file.has("rolling_sphere"), file.has("sphere")};
  if (std::ranges::count(bodies, true) != 1) {
    origin.refuse("die", file.has("die") ? "(beside another body)" : "(missing)",
                  "there must be one of die, rolling_sphere and sphere");
  }
  if (file.has("die")) {
    const SceneTable die = file.table("die");
    return RigidDie{die.number("radius_along"), die.number("radius_across")};
  }
  if (file.has("rolling_sphere")) {
    return RigidRollingSphere{file.table("rolling_sphere").number("radius")};
  }
  const SceneTable sphere = file.table("sphere");
  const bool moving = sphere.has("patch") && sphere.choice("patch") == "moving";
  return ElasticSphere{sphere.number("radius"), read_isotropic(sphere), moving};
}

void read_motion(const SceneTable& file, HalfSpaceProblem& problem) {
  if (rolls(problem)) {
    problem.speed = file.table("rolling").number("speed");
    return;
  }
  const SceneTable sliding = file.table("sliding");
  problem.speed = sliding.number("speed");
  if (sliding.has("direction")) problem.direction = sliding.number("direction");
  if (sliding.has("friction")) problem.friction = sliding.number("friction");
}

void read_given(const SceneTable& file, const SceneOrigin& origin, HalfSpaceProblem& problem) {
  if (file.has("load") == file.has("contact")) {
    origin.refuse("load", file.has("load") ? "(beside contact)" : "(missing)",
                  "there must be either [load] normal_force or [contact] span_along");
  }
  if (file.has("load")) {
    problem.given = GivenNormalForce{file.table("load").number("normal_force")};
  } else {
    problem.given = GivenSpan{file.table("contact").number("span_along")};
  }
}

ContourRule read_rule(const SceneTable& method) {
  const std::string kind = method.choice("kind");
  if (kind == "exact") return ContourRule::exact;
  return kind == "similar-contour" ? ContourRule::similar_contour : ContourRule::stationary_force;
}

/// The solids' own checks name their members, which are the keys of their table.
void check_solid(const auto& solid, const SceneOrigin& origin, std::string_view table) {
  try {
    solid.check();
  } catch (const BadInput& error) {
    origin.refuse_as(std::string(table) + "." + error.argument(), error);
  }
}

/// Checks the body and returns its smallest radius of curvature.
double check_body(const Body& body, const SceneOrigin& origin) {
  if (const auto* const die = std::get_if<RigidDie>(&body)) {
    origin.check_domain("die.radius_along", die->radius_along);
    origin.check_domain("die.radius_across", die->radius_across);
    return std::min(die->radius_along, die->radius_across);
  }
  if (const auto* const rolling = std::get_if<RigidRollingSphere>(&body)) {
    origin.check_domain("rolling_sphere.radius", rolling->radius);
    return rolling->radius;
  }
  const auto& sphere = std::get<ElasticSphere>(body);
  origin.check_domain("sphere.radius", sphere.radius);
  check_solid(sphere.solid, origin, "sphere");
  return sphere.radius;
}

void check_given(const HalfSpaceProblem& problem, double smallest_radius, const SceneOrigin& origin) {
  if (const auto* const load = std::get_if<GivenNormalForce>(&problem.given))
    return origin.check_domain("load.normal_force", load->force);
  const double along = std::get<GivenSpan>(problem.given).along;
  origin.check_domain("contact.span_along", along);
  origin.require(
      along <= smallest_radius, "contact.span_along", along,
      "must be at most the body's smallest radius: beyond it a paraboloid no longer stands for the body");
}

void check_rolling(const HalfSpaceProblem& problem, const SceneOrigin& origin) {
  if (!std::holds_alternative<IsotropicSolid>(problem.half_space))
    origin.refuse(
        "half_space.model",
        std::holds_alternative<Stiffness>(problem.half_space) ? "anisotropic" : "transversely-isotropic",
        "must be isotropic under a rolling sphere");
  if (problem.rule != ContourRule::stationary_force)
    origin.refuse(
        "method.kind", problem.rule == ContourRule::exact ? "exact" : "similar-contour",
        "must be stationary-force for a rolling sphere: no exact solution is known, and (30) is a die's");
}

}  // namespace

HalfSpaceProblem read_half_space_problem(const SceneTable& file, const SceneOrigin& origin) {
  HalfSpaceProblem problem{.body = read_body(file, origin),
                           .half_space = read_half_space(file.any_table("half_space"), origin),
                           .given = {}};
  read_motion(file, problem);
  read_given(file, origin, problem);
  problem.rule = read_rule(file.table("method"));
  if (file.has("profile")) {
    const SceneTable profile = file.table("profile");
    problem.profile = read_profile(profile, origin);
    if (profile.has("direction")) problem.line = profile.number("direction");
    if (profile.has("depth")) problem.depth = profile.number("depth");
  }
  return problem;
}

void check_half_space_problem(const HalfSpaceProblem& problem, const SceneOrigin& origin) {
  const double smallest_radius = check_body(problem.body, origin);
  std::visit([&](const auto& solid) { check_solid(solid, origin, "half_space"); }, problem.half_space);
  origin.check_domain(rolls(problem) ? "rolling.speed" : "sliding.speed", problem.speed);
  origin.check_domain("sliding.direction", problem.direction);
  origin.check_domain("sliding.friction", problem.friction);
  check_given(problem, smallest_radius, origin);
  if (rolls(problem)) check_rolling(problem, origin);
  origin.require(
      problem.rule != ContourRule::exact || problem.friction == 0, "sliding.friction", problem.friction,
      "must be 0 with the exact method: friction raises the surface on one side and lowers it on the other, so that no "
      "semi-ellipsoidal pressure fits the body");
  if (problem.profile) check_profile(*problem.profile, origin);
  if (problem.line) origin.check_domain("profile.direction", *problem.line);
  origin.check_domain("profile.depth", problem.depth);
}

}  // namespace nipref::data
