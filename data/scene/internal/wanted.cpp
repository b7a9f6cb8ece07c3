#include <nipref/data/closest_name.hpp>
#include <nipref/data/internal/common.hpp>
#include <nipref/data/scene/internal/check.hpp>
#include <nipref/data/scene/internal/read.hpp>

namespace nipref::data {
namespace {

[[noreturn]] void refuse_wanted(SceneKind kind, const SceneOrigin& origin, std::string_view key,
                                std::string_view value) {
  std::vector<std::string_view> names;
  for (const SceneResult& result : scene_results()) {
    if (result.is_of(kind)) names.push_back(result.name);
  }
  origin.refuse(key, value,
                fmt::format("{}must be out of {}", did_you_mean(value, names), fmt::join(names, ", ")));
}

bool is_one_of(ResultId id, std::initializer_list<ResultId> ids) {
  return std::ranges::find(ids, id) != ids.end();
}

bool is_continuous(const auto& problem) { return std::holds_alternative<ConvergedMethod>(problem.method); }

// obstacle() says why a scene of the right kind cannot have a result; the text is empty if it can.

std::string_view obstacle(const SceneResult& result, const HalfSpaceProblem& problem) {
  const bool is_displacement = is_one_of(
      result.id,
      {ResultId::normal_displacement, ResultId::tangential_displacement, ResultId::transverse_displacement});
  if (problem.rule != ContourRule::exact &&
      (is_displacement ||
       is_one_of(result.id, {ResultId::axis_ratio, ResultId::orientation, ResultId::approach})))
    return "must be wanted of the exact method only: the others fit the body on each line by itself, and their "
           "pressures together press the surface into no body's shape";
  if (problem.rule == ContourRule::similar_contour && result.id == ResultId::peak_pressure)
    return "must be left out with similar-contour: each line has its own, peak_on_line";
  if (!std::holds_alternative<RigidRollingSphere>(problem.body) &&
      is_one_of(result.id, {ResultId::creep, ResultId::compressed_radius}))
    return "must be wanted of a rolling sphere only";
  if (!problem.profile || result.shape != Shape::profile) return {};
  if (result.is_along_line() && !problem.line)
    return "must be wanted with profile.direction, the angle of its line from the motion";
  if (problem.depth > 0 && !is_displacement)
    return "must be wanted without profile.depth: only displacements are known below the surface";
  if (!result.is_along_line() && problem.line)
    return "must be wanted without profile.direction: it belongs to whole lines";
  return {};
}

/// The obstacle to a result that only continuous contacts have.
std::string_view obstacle_of_line_loads(const SceneResult& result, const auto& problem) {
  const bool is_of_continuous = result.needs == Needs::converged || result.needs == Needs::slip_heat;
  if (is_of_continuous && !is_continuous(problem))
    return "must be left out: between line loads the surface is stretched as under none, and at them "
           "without bound; it is one of method.kind = \"converged\"";
  return {};
}

std::string_view obstacle(const SceneResult& result, const PartialSlipProblem& problem) {
  using enum Needs;
  if (result.id == ResultId::power_loss)
    return "must be left out: the scene has no speed; dissipation is power over speed";
  if (result.needs != nothing && result.needs != converged && result.needs != partial_slip &&
      result.needs != slip_heat && result.id != ResultId::peak_shear_position)
    return "must be left out: it is not computed with Coulomb's friction";
  return obstacle_of_line_loads(result, problem);
}

/// The obstacle to displacements inside the sheet.
std::string_view obstacle_inside(const ElasticNipProblem& problem) {
  const auto* const loads = std::get_if<LineLoads>(&problem.method);
  if (loads != nullptr && loads->residue_terms != 0)
    return "must be left out with method.residue_terms: at the faces displacements are these sums, inside "
           "the sheet those of the kernels themselves";
  return {};
}
std::string_view obstacle_inside(const ViscoelasticNipProblem&) {
  return "must be left out: inside a sheet that rolls each depth remembers its own strains, of which only "
         "those of the faces are computed; without rolling.speed an elastic sheet has it";
}

std::string_view obstacle_of_sheet(const SceneResult& result, const auto& problem, Friction friction) {
  using enum Needs;
  if (result.needs == shear && friction == Friction::none)
    return "must be left out: without friction there is no shear";
  if (result.needs == partial_slip || result.needs == slip_heat)
    return "must be left out: it is of friction.model = \"coulomb\"";
  if (result.needs == line_load_creep && (friction == Friction::none || is_continuous(problem)))
    return "must be left out: it is of line loads with full friction; a converged contact has one creep";
  if (result.needs == inside_all && !is_continuous(problem))
    return "must be left out: at line loads stresses have no bound; it is one of method.kind = "
           "\"converged\"";
  if (result.needs == inside_elastic) return obstacle_inside(problem);
  return obstacle_of_line_loads(result, problem);
}
std::string_view obstacle(const SceneResult& result, const ElasticNipProblem& problem) {
  return obstacle_of_sheet(result, problem, problem.friction);
}
std::string_view obstacle(const SceneResult& result, const ViscoelasticNipProblem& problem) {
  return obstacle_of_sheet(result, problem, Friction::none);
}

bool lacks_field(const auto& problem) {
  if constexpr (requires { problem.field; }) return !problem.field;
  return false;
}

}  // namespace

std::vector<ResultId> read_wanted(const std::vector<std::string>& names, SceneKind kind,
                                  const SceneOrigin& origin) {
  std::vector<ResultId> wanted;
  for (const std::string& name : names) {
    const SceneResult* const result = find_scene_result(name);
    if (result == nullptr) refuse_wanted(kind, origin, fmt::format("wanted[{}]", wanted.size()), name);
    wanted.push_back(result->id);
  }
  return wanted;
}

bool check_wanted(const Scene& scene) {
  if (scene.wanted.empty()) refuse_wanted(scene.kind(), scene.origin, "wanted", "[]");
  bool profile_wanted = false;
  std::set<ResultId> seen;
  for (std::size_t i = 0; i < scene.wanted.size(); ++i) {
    const std::string key = fmt::format("wanted[{}]", i);
    const SceneResult& result = scene_result(scene.wanted[i]);
    if (!result.is_of(scene.kind())) refuse_wanted(scene.kind(), scene.origin, key, result.name);
    const std::string_view allowed =
        std::visit([&](const auto& problem) { return obstacle(result, problem); }, scene.system);
    if (!allowed.empty()) scene.origin.refuse(key, result.name, allowed);
    if (result.shape == Shape::field &&
        std::visit([](const auto& problem) { return lacks_field(problem); }, scene.system))
      scene.origin.refuse(
          "field", "(missing)",
          "must say where results inside the sheet are wanted: positions = [...], depths = [...]");
    if (!seen.insert(result.id).second) scene.origin.refuse(key, result.name, "must be wanted once");
    profile_wanted = profile_wanted || result.shape == Shape::profile;
  }
  return profile_wanted;
}

}  // namespace nipref::data
