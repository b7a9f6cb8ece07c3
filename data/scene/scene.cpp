#include <nipref/data/internal/common.hpp>
#include <nipref/data/scene/internal/check.hpp>

namespace nipref::data {
namespace {

// These limits keep the time of every scene below 20 s. A dense system is solved once for a length, about ten times for
// a load and for each number of trailing elements of a search. A point of a profile is a sum over all elements.
constexpr int most_unknowns_for_length = 4001, most_unknowns_for_load = 2001;
constexpr int most_viscoelastic_elements = 500, most_elements_searched = 200;
// With Coulomb's friction up to sixty systems are solved, of four unknowns for each element of a side.
constexpr int most_elements_with_slip = 250;
constexpr int most_elements_times_points = 10'000'000, most_viscoelastic_elements_times_points = 100'000;

/// Checks the nip. Its own check names C++ members, which are translated into keys.
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

void check_given(const Given& given, double roller_radius, const SceneOrigin& origin) {
  if (const auto* const load = std::get_if<GivenLoad>(&given))
    return origin.check_domain("load.per_length", load->per_length);
  const double length = std::get<GivenLength>(given).contact_length;
  origin.check_domain("contact.length", length);
  origin.require(
      length <= roller_radius, "contact.length", length,
      fmt::format(
          "must be at most the roller's radius, {}: beyond it a parabola no longer stands for the roller",
          roller_radius));
}

/// Checks the number of points of a profile by line loads.
void check_points(const std::optional<Profile>& profile, int elements, int most_products,
                  const SceneOrigin& origin) {
  if (!profile) return;
  const int most = std::max(1, most_products / elements);
  origin.require(count_of(*profile) <= most, "profile", count_of(*profile),
                 fmt::format("must be at most {} points with {} elements", most, elements));
}

void check_method(const ConvergedMethod&, const auto&, Friction, const SceneOrigin&) {}

void check_method(const LineLoads& loads, const auto& problem, Friction friction, const SceneOrigin& origin) {
  const int unknowns =
      std::holds_alternative<GivenLoad>(problem.given) ? most_unknowns_for_load : most_unknowns_for_length;
  const int most_elements = (unknowns - 1) / (friction == Friction::full ? 2 : 1);
  origin.require_whole("method.leading_elements", loads.leading_elements, 1, most_elements);
  origin.require_whole("method.trailing_elements", loads.trailing_elements, 1, most_elements);
  origin.check_domain("method.residue_terms", loads.residue_terms);
  origin.require(
      loads.leading_elements == loads.trailing_elements, "method.trailing_elements", loads.trailing_elements,
      fmt::format("must equal leading_elements, {}: an elastic nip is symmetric", loads.leading_elements));
  check_points(problem.profile, 2 * loads.leading_elements, most_elements_times_points, origin);
}

/// The thesis searches for m2 at a given load only.
void check_method(const ViscoelasticLineLoads& loads, const auto& problem, Friction,
                  const SceneOrigin& origin) {
  const auto& [leading, trailing, approach_lengths, residue_terms, smallest_term] = loads;
  const int most_elements = trailing ? most_viscoelastic_elements : most_elements_searched;
  origin.require_whole("method.leading_elements", leading, 1, most_elements);
  if (trailing) origin.require_whole("method.trailing_elements", *trailing, 0, most_viscoelastic_elements);
  origin.check_domain("method.residue_terms", residue_terms);
  origin.check_domain("method.approach_lengths", approach_lengths);
  check_points(problem.profile, leading + trailing.value_or(leading), most_viscoelastic_elements_times_points,
               origin);
  if (!trailing && std::holds_alternative<GivenLength>(problem.given))
    origin.refuse("method.trailing_elements", "(missing)",
                  "must be given with [contact] length: the search for it is at a given load");
}

/// Checks line loads with Coulomb's friction, which find the elements that press under a load, never a length.
void check_line_loads_with_slip(const LineLoads& loads, const Given& given, const SceneOrigin& origin) {
  origin.require_whole("method.leading_elements", loads.leading_elements, 1, most_elements_with_slip);
  origin.require(loads.residue_terms == 0, "method.residue_terms", loads.residue_terms,
                 "must be 0 with Coulomb's friction");
  if (const auto* const length = std::get_if<GivenLength>(&given))
    origin.refuse(
        "contact.length", length->contact_length,
        "must be load.per_length instead: line loads with Coulomb's friction have a length of elements");
}

void check_nip_problem(const auto& problem, Friction friction, const SceneOrigin& origin) {
  check_nip(problem.nip, origin);
  check_given(problem.given, problem.nip.roller_radius, origin);
  if (problem.profile) check_profile(*problem.profile, origin);
  if constexpr (requires { problem.field; })
    if (problem.field) check_field(*problem.field, origin);
  std::visit([&](const auto& method) { check_method(method, problem, friction, origin); }, problem.method);
}

void check_system(const ElasticNipProblem& problem, const SceneOrigin& origin) {
  check_nip_problem(problem, problem.friction, origin);
  if (!problem.creep_ratio) return;
  origin.check_domain("friction.creep_ratio", *problem.creep_ratio);
  origin.require(
      problem.friction == Friction::full && std::holds_alternative<LineLoads>(problem.method),
      "friction.creep_ratio", *problem.creep_ratio,
      "can be given only to line loads with full friction: otherwise the contact itself settles it");
}

void check_system(const ViscoelasticNipProblem& problem, const SceneOrigin& origin) {
  check_nip_problem(problem, Friction::none, origin);
}

void check_system(const PartialSlipProblem& problem, const SceneOrigin& origin) {
  origin.check_domain("friction.coefficient", problem.nip.friction_coefficient);
  if (const auto* const creep = std::get_if<GivenCreep>(&problem.nip.drive))
    origin.check_domain("traction.creep_ratio", creep->creep_ratio);
  else
    origin.check_domain("traction.force_per_length",
                        std::get<GivenTraction>(problem.nip.drive).force_per_length);
  if (const auto* const loads = std::get_if<LineLoads>(&problem.method))
    check_line_loads_with_slip(*loads, problem.given, origin);
  check_nip_problem(problem, Friction::full, origin);
}

void check_system(const HalfSpaceProblem& problem, const SceneOrigin& origin) {
  check_half_space_problem(problem, origin);
}

}  // namespace

SceneKind Scene::kind() const {
  return std::holds_alternative<HalfSpaceProblem>(system) ? SceneKind::half_space : SceneKind::nip;
}

void Scene::check() const {
  const bool profile_wanted = check_wanted(*this);
  origin.check_domain("accuracy", accuracy);
  std::visit([&](const auto& problem) { check_system(problem, origin); }, system);
  const bool has_positions =
      std::visit([](const auto& problem) { return problem.profile.has_value(); }, system);
  if (profile_wanted && !has_positions) {
    origin.refuse("profile", "(missing)",
                  "must say where the wanted profiles are wanted: points = N or positions = [...]");
  }
}

}  // namespace nipref::data
