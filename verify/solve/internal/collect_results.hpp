#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nipref/verify/solve/internal/linear_theory.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>
#include <nipref/verify/solve/solve.hpp>

namespace nipref::verify {

/// Where the scene's profiles are wanted, evenly spaced ones over `extent`; nothing if none is wanted.
std::vector<double> profile_positions(const data::Scene& scene, const std::optional<data::Profile>& profile,
                                      const ProfileExtent& extent);

/// Value and error are numbers: with the scene's own numbers at the ends of their range they may not be.
inline bool is_finite(const fast::Estimate& number) {
  return std::isfinite(number.value) && std::isfinite(number.error);
}
/// These have a range that no scene leaves.
inline bool is_finite(const ref::Estimate&) { return true; }

/// Whether the scene is solved by line loads.
bool is_by_line_loads(const data::Scene& scene);

/// Throws BadInput that names the wanted result.
[[noreturn]] void refuse_result(const data::Scene& scene, std::size_t wanted);

/// Where the scene's fields are wanted; empty if none is.
const data::FieldPlaces& field_places(const data::Scene& scene);

template <class Number>
std::vector<Number> profile_of(const SolvedContact<Number>& contact, ResultId id,
                               const std::vector<double>& positions, const data::SceneOrigin& origin) {
  std::vector<Number> numbers;
  for (const double y : positions) {
    try {
      numbers.push_back(contact.at(id, y));
    } catch (const data::BadInput& error) {
      origin.refuse_as("profile.positions[" + std::to_string(numbers.size()) + "]", error);
    }
  }
  return numbers;
}

/// What the scene's accuracy allows each number's error to be; empty where that is not what the error is about.
std::vector<long double> allowed_errors(long double accuracy, const SolvedContact<fast::Estimate>& contact,
                                        const SceneSolution<fast::Estimate>::Result& result,
                                        const std::vector<double>& positions,
                                        const std::vector<double>& along_field);
/// The reference's digits likewise, of a profile those of its largest number.
std::vector<long double> allowed_errors(long double accuracy, const SolvedContact<ref::Estimate>& contact,
                                        const SceneSolution<ref::Estimate>::Result& result,
                                        const std::vector<double>& positions,
                                        const std::vector<double>& along_field);

/// Asks the contact for what the scene wants at this place of its list, at the solution's positions. `accuracy`: what was
/// asked for.
template <class Number>
typename SceneSolution<Number>::Result collect_result(const data::Scene& scene, std::size_t wanted,
                                                      const SolvedContact<Number>& contact,
                                                      const SceneSolution<Number>& solution) {
  typename SceneSolution<Number>::Result result{data::find_scene_result(scene.wanted[wanted]), {}};
  const ResultId id = result.what->id;
  switch (result.what->shape) {
    case data::Shape::number:
      result.numbers = {contact.number(id)};
      break;
    case data::Shape::list:
      result.numbers = contact.list(id);
      break;
    case data::Shape::profile:
      result.numbers = profile_of(contact, id, solution.positions, scene.origin);
      break;
    case data::Shape::field:
      result.numbers = contact.inside(id, solution.field);
  }
  if (!std::ranges::all_of(result.numbers, [](const Number& n) { return is_finite(n); }))
    refuse_result(scene, wanted);
  result.allowed =
      allowed_errors(solution.accuracy, contact, result, solution.positions, solution.field.positions);
  return result;
}

/// Asks the contact for everything that the scene wants, and a nip for its indentation: see linear_theory.hpp. `accuracy`:
/// what was asked for.
template <class Number>
SceneSolution<Number> collect_results(const data::Scene& scene, const std::optional<data::Profile>& profile,
                                      const SolvedContact<Number>& contact, long double accuracy) {
  SceneSolution<Number> solution;
  solution.title = scene.title;
  solution.accuracy = accuracy;
  solution.is_discrete = is_by_line_loads(scene);
  solution.warnings = beyond_theory(scene, contact);
  solution.positions = profile_positions(scene, profile, contact.profile_extent());
  for (std::size_t wanted = 0; wanted < scene.wanted.size(); ++wanted) {
    if (data::find_scene_result(scene.wanted[wanted])->shape == data::Shape::field)
      solution.field = field_places(scene);
    solution.results.push_back(collect_result(scene, wanted, contact, solution));
  }
  solution.work = contact.work();
  solution.error_work = contact.error_work();
  return solution;
}

}  // namespace nipref::verify
