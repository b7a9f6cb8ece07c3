#pragma once
#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/data/scene/file.hpp>
#include <nipref/data/scene/scene.hpp>
#include <nipref/verify/solve/solve.hpp>

#include "support/test.hpp"

/// A scene of data/scenes with other values of these keys.
inline nipref::data::Scene loaded_example(const std::string& name,
                                          const nipref::data::SceneOverrides& other = {}) {
  return nipref::data::load_scene(nipref::data::example_scene(name), other);
}

/// A scene that wants these results of a system.
inline nipref::data::Scene scene_wanting(const auto& system,
                                         const std::vector<nipref::data::ResultId>& wanted, double accuracy) {
  return {.title = "test", .wanted = wanted, .accuracy = accuracy, .system = system, .origin = {}};
}

/// The thesis's sheet of a quarter of an inch at a load of 100, with places inside and outside the contact.
inline nipref::data::ElasticNipProblem quarter_inch_problem(nipref::data::Friction friction) {
  return {.nip = nipref::data::seed::nip(0.25),
          .given = nipref::data::GivenLoad{100},
          .friction = friction,
          .profile = nipref::data::Positions{{-0.2, -0.03, 0.0, 0.01, 0.05, 0.2}}};
}

/// Solves the scene of this text.
inline nipref::verify::SceneSolution<nipref::fast::Estimate> solved(const std::string& text) {
  return nipref::verify::solve(nipref::data::parse_scene(text, "a text"));
}

/// Calls `check` for each result of a nip: its value in the solution, by its name, and the contact's member.
template <class Contact>
void check_names(const nipref::verify::SceneSolution<nipref::fast::Estimate>& solution,
                 const Contact& contact, const auto& check) {
  using enum nipref::data::ResultId;
  const auto is = [&](nipref::data::ResultId id, auto member) {
    check(solution[id], std::invoke(member, contact));
  };
  is(contact_length, &Contact::contact_length);
  is(load, &Contact::load);
  is(indentation, &Contact::indentation);
  is(edge_displacement, &Contact::leading_displacement);
  is(creep_ratio, &Contact::creep_ratio);
  is(peak_pressure, &Contact::peak_pressure);
  is(peak_shear, &Contact::peak_shear);
  for (std::size_t i = 0; i < solution.positions.size(); ++i) {
    const auto is_at = [&](nipref::data::ResultId id, auto member) {
      check(solution.profile(id)[i], std::invoke(member, contact, solution.positions[i]));
    };
    is_at(pressure, &Contact::pressure);
    is_at(shear, &Contact::shear);
    is_at(normal_displacement, &Contact::normal_displacement);
    is_at(tangential_displacement, &Contact::tangential_displacement);
  }
}

/// All results that every scene of a nip can want: none that needs stresses inside the sheet or shear.
inline std::vector<nipref::data::ResultId> all_results() {
  std::vector<nipref::data::ResultId> results;
  for (const nipref::data::SceneResult& result : nipref::data::scene_results()) {
    if (result.is_of(nipref::data::SceneKind::nip) && result.needs == nipref::data::Needs::nothing)
      results.push_back(result.id);
  }
  return results;
}

inline nipref::data::ElasticNipProblem& problem_of(nipref::data::Scene& scene) {
  return std::get<nipref::data::ElasticNipProblem>(scene.system);
}
