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

/// The positions of the scene's profiles, evenly spaced ones over `extent`; empty if the scene wants no profile.
std::vector<double> profile_positions(const data::Scene& scene, const std::optional<data::Profile>& profile,
                                      const ProfileExtent& extent);

/// A value or an error overflows only if the scene's own numbers are at the ends of the range of double.
inline bool is_finite(const fast::Estimate& number) {
  return std::isfinite(number.value) && std::isfinite(number.error);
}
/// No scene leaves the range of these numbers.
inline bool is_finite(const ref::Estimate&) { return true; }

/// Whether the scene is solved by line loads.
bool is_by_line_loads(const data::Scene& scene);

/// Throws BadInput, which names the wanted result.
[[noreturn]] void refuse_result(const data::Scene& scene, std::size_t wanted);

/// The places of the scene's fields; the scene must want one.
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

/// The largest error of each number that meets the accuracy; empty if the error does not depend on the accuracy.
std::vector<long double> allowed_errors(long double accuracy, const SolvedContact<fast::Estimate>& contact,
                                        const SceneSolution<fast::Estimate>::Result& result,
                                        const std::vector<double>& positions,
                                        const std::vector<double>& along_field);
/// The same for the reference, whose digits are relative to the largest number of the result.
std::vector<long double> allowed_errors(long double accuracy, const SolvedContact<ref::Estimate>& contact,
                                        const SceneSolution<ref::Estimate>::Result& result,
                                        const std::vector<double>& positions,
                                        const std::vector<double>& along_field);

/// Computes the result at this place of the scene's list of wanted results.
template <class Number>
typename SceneSolution<Number>::Result collect_result(const data::Scene& scene, std::size_t wanted,
                                                      const SolvedContact<Number>& contact,
                                                      const SceneSolution<Number>& solution) {
  typename SceneSolution<Number>::Result result{&data::scene_result(scene.wanted[wanted]), {}};
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

/// Computes all results that the scene wants, and the indentation of a nip, see linear_theory.hpp. `accuracy` is the
/// requested one.
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
    if (data::scene_result(scene.wanted[wanted]).shape == data::Shape::field)
      solution.field = field_places(scene);
    solution.results.push_back(collect_result(scene, wanted, contact, solution));
  }
  solution.work = contact.work();
  solution.error_work = contact.error_work();
  return solution;
}

}  // namespace nipref::verify
