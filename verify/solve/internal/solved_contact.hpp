#pragma once
#include <compare>
#include <concepts>
#include <memory>

#include <nipref/data/scene/results.hpp>
#include <nipref/fast/half_space/direction.hpp>
#include <nipref/fast/nip/inner_stresses.hpp>
#include <nipref/fast/nip/work.hpp>
#include <nipref/ref/half_space/joint_response.hpp>
#include <nipref/ref/nip/inner_stresses.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

using data::ResultId;

/// A place of a profile or field: Y along the sheet, and the depth over half the thickness. On a half-space y is an
/// angle from the motion in degrees, or a position on the scene's line.
struct Place {
  double y, depth = 0;
  auto operator<=>(const Place&) const = default;
};
using Places = std::vector<Place>;

/// The value with the error 0, as a number of the type and the digits of `like`.
inline fast::Estimate exactly(double value, const fast::Estimate&) { return {value, 0}; }
inline ref::Estimate exactly(double value, const ref::Estimate& like) {
  return ref::exactly(value, like.digits);
}

/// The ends of a contact, Y, unit of length; on a half-space without a line the ends of the angles, degrees.
struct ContactEnds {
  double first, last;
};

/// What the error of a result is measured against, see data::Scale.
enum class Measure {
  size,  ///< the larger of the result and its size
  itself,  ///< the result alone, except for stresses inside the sheet, and the place of the largest pressure, which
           ///< may be 0
  truth  ///< nothing: the error is the distance to the continuous contact, which no accuracy makes smaller
};

/// A request for a result of a contact, at these places if it is a profile or a field, and the answer. The answer may
/// have other results that are computed together with it.
template <class Number>
struct Asked {
  ResultId id;
  const Places& places;
  std::map<ResultId, std::vector<Number>> answer = {};

  /// Answers with `result`, a number, a list, or a function of Y, if `name` is asked for. Otherwise it is not computed.
  template <class Result>
  void set(ResultId name, const Result& result) {
    if (name != id) return;
    if constexpr (std::invocable<const Result&, double>) {
      answer[id] = mapped(places, [&](const Place& place) { return number_of(result(place.y)); });
    } else if constexpr (std::ranges::range<std::invoke_result_t<const Result&>>) {
      answer[id] = mapped(result(), [](const auto& one) { return number_of(one); });
    } else {
      answer[id] = {number_of(result())};
    }
  }
  /// If one of the `parts` is asked for, answers with all of them; all() computes them together for all places.
  void set_parts(const auto& all, const auto&... parts) {
    if (((parts.first != id) && ...)) return;
    const auto wholes = all();
    ((answer[parts.first] = mapped<Number>(wholes, parts.second)), ...);
  }

 private:
  /// A double gets the error 0 until its error is estimated.
  static Number number_of(double found) requires std::same_as<Number, fast::Estimate> { return {found, 0}; }
  static Number number_of(const Number& found) { return found; }
};

/// A solved contact of either path. A result is computed when it is first asked for, and cached.
template <class Number>
class SolvedContact {
 public:
  SolvedContact() = default;
  SolvedContact(const SolvedContact&) = delete;
  SolvedContact& operator=(const SolvedContact&) = delete;
  virtual ~SolvedContact() = default;

  /// The numbers of a result: one, all of a list, or one for each place of a profile or field. BadInput if the contact
  /// does not have it.
  [[nodiscard]] const std::vector<Number>& get(ResultId id, const Places& places = {}) const;
  [[nodiscard]] const Number& number(ResultId id) const { return get(id).front(); }
  [[nodiscard]] const Number& at(ResultId id, double y) const { return get(id, {{y}}).front(); }

  [[nodiscard]] virtual ContactEnds ends() const;
  /// The ends of evenly spaced profiles: those of the contact, or of half of a symmetric nip.
  [[nodiscard]] ContactEnds profile_ends() const { return {is_symmetric ? 0 : ends().first, ends().last}; }

  /// Solves again with more terms for smaller errors; false if this is not possible.
  bool refine() {
    cache_.clear();
    return solve_again();
  }
  /// The work so far on the results, and the work on their error estimates alone.
  [[nodiscard]] virtual fast::Work work() const { return {}; }
  [[nodiscard]] virtual fast::Work error_work() const { return {}; }

  bool is_symmetric = false;
  double roller_radius = 0, speed = 1;  ///< of a nip; the speed of an elastic sheet does not matter
  double friction = 0;                  ///< Coulomb's coefficient
  Measure measure = Measure::size;

 private:
  /// Answers with what the solution itself has. Results of a nip that follow from its other results need no answer.
  virtual void answer(Asked<Number>& asked) const = 0;
  virtual bool solve_again() { return false; }

  mutable std::map<std::pair<ResultId, Places>, std::vector<Number>> cache_;
};

/// The size of a result by data::Scale, at `y` for a profile or a field, if the scene asks for this accuracy.
template <class Number>
double result_size(const SolvedContact<Number>& contact, ResultId id, double y, double accuracy);

/// Whether it is leading_moment or trailing_moment.
bool is_moment(ResultId id);
/// Whether it is the rolling resistance in another unit: eccentricity, resistance_force, power_loss.
bool is_product(ResultId id);

/// The types and functions of a path, for templates that serve both paths.
struct FastPath {
  static constexpr bool is_fast = true;
  using Accuracy = double;  ///< a scene's
  using Number = fast::Estimate;
  using Point = fast::InnerPoint;
  using Line = fast::Direction;  ///< of a half-space's surface, from the motion
  using Position = double;
  static Number exactly(double value, int) { return {value, 0}; }
  static Line line(double degrees) { return Line::of_degrees(degrees); }
  static Line reversed(const Line& psi) { return {-psi.cosine, -psi.sine, -psi.cosine_low, -psi.sine_low}; }
};
struct RefPath {
  static constexpr bool is_fast = false;
  using Accuracy = int;  ///< digits
  using Number = ref::Estimate;
  using Point = ref::InnerPoint;
  using Line = ref::Exact;  ///< degrees
  using Position = ref::Exact;
  static Number exactly(double value, int digits) { return ref::exactly(value, digits); }
  static Line line(double degrees) { return Line(degrees); }
  static Line reversed(const Line& psi) { return Line(mpq_class(psi.value() + 180)); }
};

template <class Path>
using Solved = std::unique_ptr<SolvedContact<typename Path::Number>>;
using SolvedInDouble = Solved<FastPath>;
using SolvedByRef = Solved<RefPath>;

// Solvers of a contact by each method of a scene, with all its results. They throw BadInput that names "load" or
// "contact_length" if the length of the contact is not allowed.

/// A nip by the method of its problem; `accuracy` is the scene's, or the digits. The default is the continuous contact.
///
/// In double the error of a result of line loads is its distance to the same result of the continuous contact, solved
/// to 1e-5, plus the error of that result. The kernels of line loads of a rolling nip are exact to rounding, or the
/// truncated series that the scene asks for. The reference's errors are proven bounds for line loads and for many
/// results of continuous contacts (ref/README.md, What is proven), otherwise estimates. Instantiated for the problems
/// of nips.
template <class Path = FastPath, class Problem>
Solved<Path> solve_nip(const Problem& problem, typename Path::Accuracy accuracy);

/// A body on a half-space in double. BadInput "speed" unless the speed is subcritical on every line.
SolvedInDouble solve_half_space(const data::HalfSpaceProblem& problem);

/// A body on a half-space by the reference: the errors of the response of a line and, where all lines are alike, of the
/// critical speed are proven bounds, those of the contact are estimates. BadInput "digits" if the digits cannot be
/// reached, "span" if the span of a rolling sphere is too large.
SolvedByRef solve_ref_half_space(const ref::JointResponse& surface, const data::HalfSpaceProblem& problem,
                                 int digits);

/// The contact of a scene, which Scene::check has accepted: BadInput names the scene's key that its solver refuses.
template <class Path>
Solved<Path> solved(const data::Scene& scene, typename Path::Accuracy accuracy);

/// The measures of a solved nip that are too large for linear theory: the mean strain across the sheet in the middle of
/// the nip, indentation/half-thickness, and the slope of the roller's parabola at the farther end of the contact, Y/R.
/// Throws BadInput, naming the given load or length, if that strain is 1 or more: the rollers' faces would meet.
template <class Number>
std::vector<BeyondTheory> beyond_theory(const data::Scene& scene, const SolvedContact<Number>& contact);

/// Computes all results that the scene wants, and the indentation of a nip, see beyond_theory. `accuracy` is the
/// requested one.
template <class Number>
SceneSolution<Number> collect_results(const data::Scene& scene, const SolvedContact<Number>& contact,
                                      long double accuracy);

inline bool has_full_friction(const data::ElasticNipProblem& problem) {
  return problem.friction == data::Friction::full;
}
inline bool has_full_friction(const auto&) { return false; }

/// Calls function() with what the solvers of a continuous contact take besides the load or the length.
auto with_nip(const data::ElasticNipProblem& problem, const auto& function) {
  return function(problem.nip, problem.friction);
}
auto with_nip(const data::ViscoelasticNipProblem& problem, const auto& function) {
  return function(problem.nip);
}

}  // namespace nipref::verify
