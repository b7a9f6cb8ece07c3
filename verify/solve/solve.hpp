#pragma once
#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/scene/scene.hpp>
#include <nipref/fast/nip/work.hpp>
#include <nipref/fast/number/estimate.hpp>
#include <nipref/ref/number/estimate.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// A measure of a nip that is too large for linear theory: the solution is correct for the theory's equations, but it
/// describes a real sheet badly.
struct BeyondTheory {
  std::string_view
      quantity;  ///< compressive_strain: indentation/half-thickness; roller_slope: at an end of the contact
  double value;
  double limit;  ///< linear_theory_limit
};

/// The largest strain of the sheet and slope of the roller's face for which linear theory is used without a warning.
/// The relative error of linear theory is of the order of these two.
inline constexpr double linear_theory_limit = 0.1;

/// What a scene wanted, each result with an estimate of its error. Number is fast::Estimate or ref::Estimate.
template <class Number>
struct SceneSolution {
  struct Result {
    const data::SceneResult* what;
    /// A profile has one number for each of `positions`, a field one for each place, depth after depth, a list any
    /// number, and every other result one.
    std::vector<Number> numbers;
    /// The largest error of each number that meets the accuracy, see data::Scale. It is empty for line loads in
    /// double, whose error is their distance to the continuous contact. The reference's digits are relative to the
    /// largest number of the result, or to the size of data::Scale if that is larger.
    std::vector<long double> allowed = {};
    /// Whether each error is at most `allowed`; empty if `allowed` is. A result that misses the accuracy is the best
    /// that the solver can give.
    [[nodiscard]] std::optional<bool> met() const;
  };

  std::string title;
  long double accuracy = 0;  ///< requested by the scene, or by a number of digits
  /// Solved by line loads: fast's errors are the distance to the continuous contact, ref's those of the discrete
  /// system.
  bool is_discrete = false;
  std::vector<Result> results;         ///< in the order of the scene's `wanted`
  std::vector<double> positions;       ///< of the profiles, unit of length; empty if none is wanted
  data::FieldPlaces field;             ///< of the fields; empty if none is wanted
  std::vector<BeyondTheory> warnings;  ///< always empty for half-spaces
  fast::Work work;                     ///< spent on the results
  fast::Work error_work;               ///< spent on the error estimates of line loads
  double seconds = 0;                  ///< wall clock, for all of it

  /// The position of the i-th number of a result, unit of length, and its depth over half the thickness; empty without.
  struct Place {
    std::optional<double> position, depth;
  };
  [[nodiscard]] Place place(const data::SceneResult& what, std::size_t i) const {
    if (what.shape == data::Shape::profile) return {positions[i], {}};
    if (what.shape != data::Shape::field) return {};
    const std::size_t across = field.positions.size();
    return {field.positions[i % across], field.depths[i / across]};
  }

  /// Names of the results that are not as accurate as was asked.
  [[nodiscard]] std::vector<std::string_view> missed() const {
    std::vector<std::string_view> names;
    for (const Result& result : results)
      if (result.met() == false) names.push_back(result.what->name);
    return names;
  }
  /// Whether all results are as accurate as was asked; empty if an accuracy was asked of none.
  [[nodiscard]] std::optional<bool> met() const {
    if (std::ranges::none_of(results, [](const Result& result) { return result.met().has_value(); }))
      return {};
    return missed().empty();
  }

  /// operator[] gives a result of one number, profile() all numbers of a result. BadInput unless the scene wanted it.
  [[nodiscard]] const Number& operator[](std::string_view name) const { return profile(name).front(); }
  [[nodiscard]] const Number& operator[](data::ResultId id) const { return profile(id).front(); }
  [[nodiscard]] const std::vector<Number>& profile(data::ResultId id) const {
    return profile(data::scene_result(id).name);
  }
  [[nodiscard]] const std::vector<Number>& profile(std::string_view name) const {
    for (const Result& result : results)
      if (result.what->name == name) return result.numbers;
    throw data::BadInput("result", name, "must be among what the scene wants");
  }
};

/// Whether the scene wants a result of this shape.
bool wants(const data::Scene& scene, data::Shape shape);

inline double value_of(const fast::Estimate& number) { return number.value; }
inline double value_of(const ref::Estimate& number) { return number.to_double(); }
inline long double error_of(const fast::Estimate& number) { return number.error; }
inline long double error_of(const ref::Estimate& number) {
  return std::strtold(number.error_text().c_str(), nullptr);
}

template <class Number>
std::optional<bool> SceneSolution<Number>::Result::met() const {
  if (allowed.empty()) return {};
  return std::ranges::equal(numbers, allowed,
                            [](const Number& number, long double most) { return error_of(number) <= most; });
}

/// Solves the scene in double; only the wanted results are computed. Converged results have the solver's own error
/// estimate. The error estimate of line loads is their difference from the continuous contact solved to 1e-5; for a
/// rolling nip this contact is the steady motion, so that the estimate includes the transient of the start. BadInput,
/// naming the scene's key and its place, if Scene::check refuses the scene, if the length of the contact is not allowed
/// (fast/elastic_nip/converged.hpp), or if the solution's indentation is half of the sheet or more, so that the
/// rollers' faces meet.
[[nodiscard]] SceneSolution<fast::Estimate> solve(const data::Scene& scene);

/// A contact length that a search tries, and the load that it is found to carry.
struct SearchStep {
  double contact_length, load;
};

/// The steps of the thesis's search for a load by line loads (2.13). The first length is the thickness of the sheet;
/// with full friction it is the contact length without friction. The search ends where the load is met to 2e-3, in a
/// rolling nip to 1e-2, as in the thesis's tables. Empty for other scenes.
[[nodiscard]] std::vector<SearchStep> thesis_search(const data::Scene& scene);

/// Solves the scene by the reference, which takes the scene's doubles exactly, to `digits` digits. The scene's accuracy
/// is not used, and the errors of line loads are those of the discrete system, not its distance to the continuous
/// contact. It throws BadInput for every scene and every result that is not in this list:
/// - the continuous contact of an elastic nip, without friction with proven bounds where these reach it, otherwise
///   estimated; digits from 16 to 100 (ref/elastic_nip/converged.hpp);
/// - its line loads, proven; digits from 16 to 300 (ref/elastic_nip/line_loads.hpp);
/// - the continuous contact of a viscoelastic nip, lengths, load, resistance and pressure mostly proven, the rest
///   estimated; digits from 16 to 30 (ref/viscoelastic_nip/converged.hpp);
/// - its line loads, real rates, proven; digits from 16 to 30 (ref/viscoelastic_nip/line_loads.hpp);
/// - the contact with Coulomb's friction, estimated; digits from 16 to 30 (ref/partial_slip/partial_slip.hpp);
/// - bodies on half-spaces: compliances, couplings, what is given and, where all lines are alike, critical speeds
///   proven, the rest estimated; digits from 16 to 100 (ref/half_space/elliptic.hpp, sliding.hpp, rolling_sphere.hpp).
[[nodiscard]] SceneSolution<ref::Estimate> solve_by_ref(const data::Scene& scene, int digits = 30);

/// An estimate of the seconds that solve_by_ref() takes on one core of a server of 2022, good to a factor of about
/// three. It follows from the number of unknowns and of wanted places; the length for a given load is computed in
/// double. It is 0 for scenes that double refuses, for line loads, and on half-spaces without displacements.
[[nodiscard]] double likely_seconds_by_ref(const data::Scene& scene, int digits);

/// A warning of one line if the seconds are more than ten; otherwise empty.
[[nodiscard]] std::string warning_of_time(double seconds);

Json warnings_json(const std::vector<BeyondTheory>& warnings);

/// A number and its error as decimals; the error is rounded upwards.
std::string value_text(const fast::Estimate& number);
std::string error_text(const fast::Estimate& number);
std::string value_text(const ref::Estimate& number);
std::string error_text(const ref::Estimate& number);

/// The answer of `solve`. The numbers of the reference are texts. `full`: the text for people has the meanings of the
/// results. Instantiated for fast::Estimate and ref::Estimate.
template <class Number>
Json solution_json(const SceneSolution<Number>& solution, bool full = false);

}  // namespace nipref::verify
