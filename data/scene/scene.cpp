#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include <nipref/data/scene/internal/field.hpp>
#include <nipref/data/scene/internal/half_space_check.hpp>
#include <nipref/data/scene/internal/profile.hpp>
#include <nipref/data/scene/internal/require.hpp>
#include <nipref/data/scene/internal/wanted.hpp>
#include <nipref/data/scene/scene.hpp>

namespace nipref::data {
namespace {

// So that no scene takes longer than 20 s: a dense system is solved once for a length, some ten times for a load
// and for each number of trailing elements that a search tries; a profile's point costs all elements.
constexpr int most_unknowns_for_length = 4001, most_unknowns_for_load = 2001;
constexpr int most_viscoelastic_elements = 500, most_elements_searched = 200;
// With Coulomb's friction up to sixty systems of four unknowns for each.
constexpr int most_elements_with_slip = 250;
constexpr int most_elements_times_points = 10'000'000, most_viscoelastic_elements_times_points = 100'000;

/// The nip's own checks name its C++ members.
void check_nip(const auto& nip, const SceneOrigin& origin) {
  static const std::map<std::string, std::string> keys{
      {"roller_radius", "roller.radius"}, {"sheet_thickness", "sheet.thickness"},
      {"young", "material.young"},        {"poisson", "material.poisson"},
      {"speed", "rolling.speed"},         {"theta1 instantaneous", "material.theta1 instantaneous"}};
  try {
    nip.check();
  } catch (const BadInput& error) {
    origin.refuse_as(keys.at(error.argument()), error);
  }
}

struct GivenCheck {
  double roller_radius;
  const SceneOrigin& origin;

  void operator()(const GivenLoad& load) const { check_domain(load.per_length, origin, "load.per_length"); }
  void operator()(const GivenLength& length) const {
    const double value = length.contact_length;
    check_domain(value, origin, "contact.length");
    require(value <= roller_radius, origin, "contact.length", value,
            fmt::format("must be at most the roller's radius, {}: beyond it a parabola no longer stands for "
                        "the roller",
                        roller_radius));
  }
};

struct MethodCheck {
  const Given& given;
  Friction friction;
  const std::optional<Profile>& profile;
  const SceneOrigin& origin;

  void operator()(const ConvergedMethod&) const {}
  void operator()(const LineLoads& loads) const {
    const int unknowns =
        std::holds_alternative<GivenLoad>(given) ? most_unknowns_for_load : most_unknowns_for_length;
    const int most_elements = (unknowns - 1) / (friction == Friction::full ? 2 : 1);
    require_whole(loads.leading_elements, 1, most_elements, origin, "method.leading_elements");
    require_whole(loads.trailing_elements, 1, most_elements, origin, "method.trailing_elements");
    check_domain(loads.residue_terms, origin, "method.residue_terms");
    require(
        loads.leading_elements == loads.trailing_elements, origin, "method.trailing_elements",
        loads.trailing_elements,
        fmt::format("must equal leading_elements, {}: an elastic nip is symmetric", loads.leading_elements));
    check_points(2 * loads.leading_elements, most_elements_times_points);
  }
  void operator()(const ViscoelasticLineLoads& loads) const {
    const int most_elements = loads.trailing_elements ? most_viscoelastic_elements : most_elements_searched;
    require_whole(loads.leading_elements, 1, most_elements, origin, "method.leading_elements");
    if (loads.trailing_elements)
      require_whole(*loads.trailing_elements, 0, most_viscoelastic_elements, origin,
                    "method.trailing_elements");
    check_domain(loads.residue_terms, origin, "method.residue_terms");
    check_domain(loads.approach_lengths, origin, "method.approach_lengths");
    check_points(loads.leading_elements + loads.trailing_elements.value_or(loads.leading_elements),
                 most_viscoelastic_elements_times_points);
  }

 private:
  void check_points(int elements, int most_products) const {
    if (!profile) return;
    const int most = std::max(1, most_products / elements);
    require(count_of(*profile) <= most, origin, "profile", count_of(*profile),
            fmt::format("must be at most {} points with {} elements", most, elements));
  }
};

/// Elements that press are found under a load.
void check_line_loads_with_slip(const PartialSlipProblem& problem, const SceneOrigin& origin) {
  const auto* const loads = std::get_if<LineLoads>(&problem.method);
  if (loads == nullptr) return;
  require_whole(loads->leading_elements, 1, most_elements_with_slip, origin, "method.leading_elements");
  require(loads->residue_terms == 0, origin, "method.residue_terms", loads->residue_terms,
          "must be 0 with Coulomb's friction");
  if (const auto* const length = std::get_if<GivenLength>(&problem.given))
    origin.refuse(
        "contact.length", length->contact_length,
        "must be load.per_length instead: line loads with Coulomb's friction have a length of elements");
}

/// The thesis searches for m2 at a given load only.
void check_viscoelastic_line_loads(const ViscoelasticNipProblem& problem, const SceneOrigin& origin) {
  const auto* loads = std::get_if<ViscoelasticLineLoads>(&problem.method);
  if (loads == nullptr) return;
  if (!loads->trailing_elements && std::holds_alternative<GivenLength>(problem.given)) {
    origin.refuse("method.trailing_elements", "(missing)",
                  "must be given with [contact] length: the search for it is at a given load");
  }
}

void check_creep(const ElasticNipProblem& problem, const SceneOrigin& origin) {
  if (!problem.creep_ratio) return;
  constexpr const char* key = "friction.creep_ratio";
  check_domain(*problem.creep_ratio, origin, key);
  require(problem.friction == Friction::full && std::holds_alternative<LineLoads>(problem.method), origin,
          key, *problem.creep_ratio,
          "can be given only to line loads with full friction: otherwise the contact itself settles it");
}

struct SystemCheck {
  const SceneOrigin& origin;

  void operator()(const ElasticNipProblem& problem) const {
    check_sheet(problem, problem.friction);
    check_creep(problem, origin);
  }
  void operator()(const ViscoelasticNipProblem& problem) const {
    check_sheet(problem, Friction::none);
    check_viscoelastic_line_loads(problem, origin);
  }
  void operator()(const PartialSlipProblem& problem) const {
    check_nip(problem.nip, origin);
    std::visit(GivenCheck{problem.nip.roller_radius, origin}, problem.given);
    check_domain(problem.nip.friction_coefficient, origin, "friction.coefficient");
    if (const auto* const creep = std::get_if<GivenCreep>(&problem.nip.drive))
      check_domain(creep->creep_ratio, origin, "traction.creep_ratio");
    else
      check_domain(std::get<GivenTraction>(problem.nip.drive).force_per_length, origin,
                   "traction.force_per_length");
    if (problem.profile) check_profile(*problem.profile, origin);
    check_line_loads_with_slip(problem, origin);
    std::visit(MethodCheck{problem.given, Friction::full, problem.profile, origin}, problem.method);
  }
  void operator()(const HalfSpaceProblem& problem) const { check_half_space_problem(problem, origin); }

 private:
  void check_sheet(const auto& problem, Friction friction) const {
    check_nip(problem.nip, origin);
    std::visit(GivenCheck{problem.nip.roller_radius, origin}, problem.given);
    if (problem.profile) check_profile(*problem.profile, origin);
    if (problem.field) check_field(*problem.field, origin);
    std::visit(MethodCheck{problem.given, friction, problem.profile, origin}, problem.method);
  }
};

}  // namespace

SceneKind Scene::kind() const {
  return std::holds_alternative<HalfSpaceProblem>(system) ? SceneKind::half_space : SceneKind::nip;
}

void Scene::check() const {
  const bool profile_wanted = check_wanted(*this);
  check_domain(accuracy, origin, "accuracy");
  std::visit(SystemCheck{origin}, system);
  const bool has_positions =
      std::visit([](const auto& problem) { return problem.profile.has_value(); }, system);
  if (profile_wanted && !has_positions) {
    origin.refuse("profile", "(missing)",
                  "must say where the wanted profiles are wanted: points = N or positions = [...]");
  }
}

}  // namespace nipref::data
