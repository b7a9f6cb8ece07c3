#pragma once
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include <nipref/data/scene/scene.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>
#include <nipref/verify/support/mapped.hpp>

namespace nipref::verify {

/// Calls set(result, member) for the results of a solved nip: the solution's members, functions or numbers, have the names
/// of the results.
template <class Solution>
void set_nip_results(const auto& set) {
  set(ResultId::contact_length, &Solution::contact_length);
  set(ResultId::leading_length, &Solution::leading_length);
  set(ResultId::trailing_length, &Solution::trailing_length);
  set(ResultId::load, &Solution::load);
  set(ResultId::indentation, &Solution::indentation);
  set(ResultId::edge_displacement, &Solution::leading_displacement);
  set(ResultId::trailing_displacement, &Solution::trailing_displacement);
  set(ResultId::rolling_resistance, &Solution::rolling_resistance);
  set(ResultId::creep_ratio, &Solution::creep_ratio);
  set(ResultId::pressure, &Solution::pressure);
  set(ResultId::peak_pressure, &Solution::peak_pressure);
  set(ResultId::peak_pressure_position, &Solution::peak_pressure_position);
  set(ResultId::shear, &Solution::shear);
  set(ResultId::peak_shear, &Solution::peak_shear);
  set(ResultId::peak_shear_position, &Solution::peak_shear_position);
  set(ResultId::normal_displacement, &Solution::normal_displacement);
  set(ResultId::tangential_displacement, &Solution::tangential_displacement);
  set(ResultId::shear_zeros, &Solution::shear_zeros);
  // Results that only some methods have.
  if constexpr (requires { &Solution::leading_moment; }) {
    set(ResultId::leading_moment, &Solution::leading_moment);
    set(ResultId::trailing_moment, &Solution::trailing_moment);
  }
  if constexpr (requires { &Solution::surface_strain; })
    set(ResultId::surface_strain, &Solution::surface_strain);
  if constexpr (requires { &Solution::slip; }) set(ResultId::slip, &Solution::slip);
}

/// The fields inside the sheet of a solution of this path: functions of points, computed once for all results of the same
/// places. A sheet whose displacements inside are not known has none.
template <class Path>
struct InnerFields {
  using Points = std::span<const typename Path::Point>;
  using Stresses = std::vector<typename Path::Stresses>;
  using Displacements = std::vector<typename Path::Displacements>;

  std::function<Stresses(Points)> stresses_of;
  std::function<Displacements(Points)> displacements_of;
  std::map<Places, Stresses> stresses = {};
  std::map<Places, Displacements> displacements = {};

  void forget() {
    stresses.clear();
    displacements.clear();
  }
  static const auto& at(const Places& places, auto& known, const auto& function) {
    const auto found = known.find(places);
    if (found != known.end()) return found->second;
    const auto points = mapped(places, [](const Place& place) {
      return typename Path::Point{place.y, place.depth};
    });
    return known.emplace(places, function(points)).first->second;
  }
};

/// Calls set(result, function of places) for these fields.
template <class Path>
void set_inner_fields(const auto& set, const std::shared_ptr<InnerFields<Path>>& fields) {
  using Fields = InnerFields<Path>;
  using Stresses = typename Path::Stresses;
  using Displacements = typename Path::Displacements;
  const auto field = [&](ResultId id, auto known, auto function, auto part) {
    set(id, [=](const Places& places) {
      return mapped<typename Path::Number>(Fields::at(places, (*fields).*known, (*fields).*function), part);
    });
  };
  const auto stress = [&](ResultId id, auto part) {
    field(id, &Fields::stresses, &Fields::stresses_of, part);
  };
  stress(ResultId::stress_across, &Stresses::across);
  stress(ResultId::stress_along, &Stresses::along);
  stress(ResultId::stress_shear, &Stresses::shear);
  stress(ResultId::highest_stress, &Stresses::highest);
  stress(ResultId::lowest_stress, &Stresses::lowest);
  stress(ResultId::maximum_shear, &Stresses::maximum_shear);
  if (!fields->displacements_of) return;
  const auto displacement = [&](ResultId id, auto part) {
    field(id, &Fields::displacements, &Fields::displacements_of, part);
  };
  displacement(ResultId::displacement_across, &Displacements::across);
  displacement(ResultId::displacement_along, &Displacements::along);
}

/// The fields of line loads, those of displacements for an elastic sheet alone. `digits`: for the reference.
template <class Path, class LineLoads, class Problem>
std::shared_ptr<InnerFields<Path>> line_load_fields(const std::shared_ptr<LineLoads>& loads,
                                                    const Problem& problem, auto... digits) {
  using Points = typename InnerFields<Path>::Points;
  auto fields = std::make_shared<InnerFields<Path>>();
  fields->stresses_of = [=, half_thickness = problem.nip.half_thickness()](Points points) {
    return line_load_stresses(loads->face_loads(), half_thickness, points, digits...);
  };
  if constexpr (std::is_same_v<Problem, data::ElasticNipProblem>) {
    fields->displacements_of = [=, nip = problem.nip](Points points) {
      return line_load_displacements(loads->face_loads(), nip.half_thickness(), nip.material, points,
                                     digits...);
    };
  }
  return fields;
}

/// What line loads do on the roller.
inline data::Grip grip_of(const data::ElasticNipProblem& problem) {
  if (problem.friction == data::Friction::none) return {};
  if (problem.creep_ratio) return {data::Grip::Creep::given, *problem.creep_ratio};
  return {data::Grip::Creep::thesis};
}

inline bool has_full_friction(const data::ElasticNipProblem& problem) {
  return problem.friction == data::Friction::full;
}
inline bool has_full_friction(const data::ViscoelasticNipProblem&) { return false; }

inline double speed_of(const data::ElasticNipProblem&) { return 1; }
inline double speed_of(const data::ViscoelasticNipProblem& problem) { return problem.nip.speed; }

/// Completes a contact that has the results of a solved nip: with their products, its ends and what is given.
template <class Number, class Problem>
void complete_nip(SolvedContact<Number>& contact, const Problem& problem) {
  contact.is_symmetric = std::is_same_v<Problem, data::ElasticNipProblem>;
  contact.roller_radius = problem.nip.roller_radius;
  contact.speed = speed_of(problem);
  contact.ends = [&contact] {
    return ContactEnds{-value_of(contact.number(ResultId::trailing_length)),
                       value_of(contact.number(ResultId::leading_length))};
  };
  set_products(contact);
}

}  // namespace nipref::verify
