#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <nipref/verify/solve/internal/solved_contact.hpp>
#include <nipref/verify/solve/solve.hpp>

namespace nipref::verify {

/// The positions of the scene's profiles, evenly spaced ones between these ends; empty if the scene wants no profile.
std::vector<double> profile_positions(const data::Scene& scene, const ContactEnds& ends);

/// The places of the scene's fields; empty if the scene wants none.
data::FieldPlaces field_places(const data::Scene& scene);

/// The measures of a solved nip that are too large for linear theory: the mean strain across the sheet in the middle of
/// the nip, indentation/half-thickness, and the slope of the roller's parabola at the farther end of the contact, Y/R.
/// Throws BadInput, naming the given load or length, if that strain is 1 or more: the rollers' faces would meet.
template <class Number>
std::vector<BeyondTheory> beyond_theory(const data::Scene& scene, const SolvedContact<Number>& contact);

/// Whether the scene is solved by line loads.
bool is_by_line_loads(const data::Scene& scene);

/// A value or an error overflows only if the scene's own numbers are at the ends of the range of double.
inline bool is_finite(const fast::Estimate& number) {
  return std::isfinite(number.value) && std::isfinite(number.error);
}
/// No scene leaves the range of these numbers.
inline bool is_finite(const ref::Estimate&) { return true; }

inline long double magnitude_of(const fast::Estimate& number) { return std::fabs(number.value); }
inline long double magnitude_of(const ref::Estimate& number) {
  return std::fabs(mpfr_get_ld(ref::raw(number.value), MPFR_RNDN));
}

/// The places at which a result of this shape is wanted.
template <class Number>
Places places_of(data::Shape shape, const SceneSolution<Number>& solution) {
  Places places;
  if (shape == data::Shape::profile) {
    for (const double y : solution.positions) places.push_back({y});
  }
  if (shape == data::Shape::field) {
    for (const double depth : solution.field.depths) {
      for (const double y : solution.field.positions) places.push_back({y, depth});
    }
  }
  return places;
}

/// The largest error of each number that meets the accuracy; empty if the error does not depend on the accuracy.
template <class Number>
std::vector<long double> allowed_errors(const SolvedContact<Number>& contact, ResultId id,
                                        const Places& places, const std::vector<Number>& numbers,
                                        long double accuracy) {
  if (contact.measure == Measure::truth) return {};
  long double largest = 0;
  for (const Number& number : numbers) largest = std::max(largest, magnitude_of(number));
  std::vector<long double> allowed;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const long double least =
        result_size(contact, id, places.empty() ? 0 : places[i].y, static_cast<double>(accuracy));
    // The reference's digits are relative to the largest number of the result.
    constexpr bool is_ref = std::is_same_v<Number, ref::Estimate>;
    allowed.push_back(accuracy * std::max(least, is_ref ? largest : magnitude_of(numbers[i])));
  }
  return allowed;
}

/// The numbers of a profile, of which BadInput names the position that it refuses.
template <class Number>
std::vector<Number> profile_of(const SolvedContact<Number>& contact, ResultId id, const Places& places,
                               const data::SceneOrigin& origin) {
  std::vector<Number> numbers;
  for (const Place& place : places) {
    try {
      numbers.push_back(contact.at(id, place.y));
    } catch (const data::BadInput& error) {
      origin.refuse_as("profile.positions[" + std::to_string(numbers.size()) + "]", error);
    }
  }
  return numbers;
}

/// Computes the result at this place of the scene's list of wanted results.
template <class Number>
typename SceneSolution<Number>::Result collect_result(const data::Scene& scene, std::size_t wanted,
                                                      const SolvedContact<Number>& contact,
                                                      const SceneSolution<Number>& solution) {
  typename SceneSolution<Number>::Result result{&data::scene_result(scene.wanted[wanted]), {}};
  const auto [id, shape] = std::pair(result.what->id, result.what->shape);
  const Places places = places_of(shape, solution);
  result.numbers =
      shape == data::Shape::profile ? profile_of(contact, id, places, scene.origin) : contact.get(id, places);
  if (!std::ranges::all_of(result.numbers, [](const Number& number) { return is_finite(number); })) {
    scene.origin.refuse("wanted[" + std::to_string(wanted) + "]", result.what->name,
                        "must be left out: in this scene it leaves the range of doubles");
  }
  result.allowed = allowed_errors(contact, id, places, result.numbers, solution.accuracy);
  return result;
}

/// Computes all results that the scene wants, and the indentation of a nip, see beyond_theory. `accuracy` is the
/// requested one.
template <class Number>
SceneSolution<Number> collect_results(const data::Scene& scene, const SolvedContact<Number>& contact,
                                      long double accuracy) {
  SceneSolution<Number> solution;
  solution.title = scene.title;
  solution.accuracy = accuracy;
  solution.is_discrete = is_by_line_loads(scene);
  solution.warnings = beyond_theory(scene, contact);
  solution.positions = profile_positions(scene, contact.profile_ends());
  solution.field = field_places(scene);
  for (std::size_t wanted = 0; wanted < scene.wanted.size(); ++wanted)
    solution.results.push_back(collect_result(scene, wanted, contact, solution));
  solution.work = contact.work();
  solution.error_work = contact.error_work();
  return solution;
}

}  // namespace nipref::verify
