#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <variant>

#include <nipref/data/closest_name.hpp>
#include <nipref/data/scene/internal/half_space_check.hpp>
#include <nipref/data/scene/internal/wanted.hpp>

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

/// Refuses a result of a nip where the scene lacks what the result needs.
struct NeedsCheck {
  const SceneOrigin& origin;
  const SceneResult& result;
  const std::string& key;

  void operator()(const ElasticNipProblem& problem) const { check(problem, problem.friction); }
  void operator()(const ViscoelasticNipProblem& problem) const { check(problem, Friction::none); }
  void operator()(const PartialSlipProblem& problem) const {
    if (result.id == ResultId::power_loss)
      origin.refuse(key, result.name,
                    "must be left out: the scene has no speed; dissipation is power over speed");
    if (result.needs != Needs::nothing && result.needs != Needs::converged &&
        result.needs != Needs::partial_slip && result.needs != Needs::slip_heat &&
        result.id != ResultId::peak_shear_position)
      origin.refuse(key, result.name, "must be left out: it is not computed with Coulomb's friction");
    check_converged(problem);
  }
  void operator()(const HalfSpaceProblem&) const {}

 private:
  template <class Problem>
  void check(const Problem& problem, Friction friction) const {
    if (result.needs == Needs::shear && friction == Friction::none)
      origin.refuse(key, result.name, "must be left out: without friction there is no shear");
    if (result.needs == Needs::partial_slip || result.needs == Needs::slip_heat)
      origin.refuse(key, result.name, "must be left out: it is of friction.model = \"coulomb\"");
    if (result.needs == Needs::line_load_creep &&
        (friction == Friction::none || std::holds_alternative<ConvergedMethod>(problem.method))) {
      origin.refuse(
          key, result.name,
          "must be left out: it is of line loads with full friction; a converged contact has one creep");
    }
    if (result.needs == Needs::inside_all && !std::holds_alternative<ConvergedMethod>(problem.method)) {
      origin.refuse(key, result.name,
                    "must be left out: at line loads stresses have no bound; it is one of method.kind = "
                    "\"converged\"");
    }
    if (result.needs == Needs::inside_elastic) check_displaced(problem);
    if (result.shape == Shape::field && !problem.field) {
      origin.refuse("field", "(missing)",
                    "must say where results inside the sheet are wanted: positions = [...], depths = [...]");
    }
    check_converged(problem);
  }
  void check_converged(const auto& problem) const {
    const bool of_continuous = result.needs == Needs::converged || result.needs == Needs::slip_heat;
    if (of_continuous && !std::holds_alternative<ConvergedMethod>(problem.method)) {
      origin.refuse(
          key, result.name,
          "must be left out: between line loads the surface is stretched as under none, and at them "
          "without bound; it is one of method.kind = \"converged\"");
    }
  }
  /// For displacements inside the sheet.
  void check_displaced(const ElasticNipProblem& problem) const {
    const auto* const loads = std::get_if<LineLoads>(&problem.method);
    if (loads == nullptr || loads->residue_terms == 0) return;
    origin.refuse(
        key, result.name,
        "must be left out with method.residue_terms: at the faces displacements are these sums, inside "
        "the sheet those of the kernels themselves");
  }
  void check_displaced(const ViscoelasticNipProblem&) const {
    origin.refuse(
        key, result.name,
        "must be left out: inside a sheet that rolls each depth remembers its own strains, of which only "
        "those of the faces are computed; without rolling.speed an elastic sheet has it");
  }
};

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
    if (const auto* on_half_space = std::get_if<HalfSpaceProblem>(&scene.system))
      check_half_space_wanted(*on_half_space, result, key, scene.origin);
    std::visit(NeedsCheck{scene.origin, result, key}, scene.system);
    if (!seen.insert(result.id).second) scene.origin.refuse(key, result.name, "must be wanted once");
    profile_wanted = profile_wanted || result.shape == Shape::profile;
  }
  return profile_wanted;
}

}  // namespace nipref::data
