#pragma once
#include <memory>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/scene/scene.hpp>
#include <nipref/fast/half_space/direction.hpp>
#include <nipref/fast/nip/inner_stresses.hpp>
#include <nipref/fast/number/estimate.hpp>
#include <nipref/ref/half_space/joint_response.hpp>
#include <nipref/ref/nip/inner_stresses.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/estimate.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>

namespace nipref::verify {

/// What differs between the paths for a template that serves both.
struct FastPath {
  static constexpr bool is_fast = true;
  using Accuracy = double;  ///< a scene's
  using Number = fast::Estimate;
  using Point = fast::InnerPoint;
  using Stresses = fast::InnerStresses;
  using Displacements = fast::InnerDisplacements;
  using Greatest = fast::GreatestShear;
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
  using Stresses = ref::InnerStresses;
  using Displacements = ref::InnerDisplacements;
  using Greatest = ref::GreatestShear;
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

// A contact solved by each method of a scene, with all its results. BadInput that names "load" or "contact_length" if
// the contact's length is not allowed.

/// A nip by its problem's method; `accuracy` is the scene's, or the digits. Without a method it is the continuous contact.
///
/// In double the error of a result of line loads is its distance to the same result of the continuous contact, solved to
/// 1e-5, whose own error is added. The kernels of line loads of a rolling nip are exact to rounding, or the truncated
/// series that the scene asks for. The reference's errors are proven bounds for line loads, and for much of what the
/// continuous contacts have (ref/README.md, What is proven), otherwise estimates. Instantiated for the problems of nips.
template <class Path = FastPath, class Problem>
Solved<Path> solve_nip(const Problem& problem, typename Path::Accuracy accuracy);

/// What line loads do on the roller.
inline data::Grip grip_of(const data::ElasticNipProblem& problem) {
  if (problem.friction == data::Friction::none) return {};
  if (problem.creep_ratio) return {data::Grip::Creep::given, *problem.creep_ratio};
  return {data::Grip::Creep::thesis};
}

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

/// A body on a half-space in double. BadInput "speed" unless the speed is subcritical on every line.
SolvedInDouble solve_half_space(const data::HalfSpaceProblem& problem);

/// A body on a half-space by the reference: the errors of the response of a line and, where all lines are alike, of the
/// critical speed are proven bounds, those of the contact are estimates. BadInput "digits" if the digits cannot be
/// reached, "span" if the span of a rolling sphere is too large.
SolvedByRef solve_ref_half_space(const ref::JointResponse& surface, const data::HalfSpaceProblem& problem,
                                 int digits);

/// Throws a solver's error again and names the scene's key: Scene::check has accepted the scene, so that the solver can
/// refuse it only because of its load or length, its speed, the material, or the digits.
[[noreturn]] void refuse_by_key(const data::Scene& scene, const data::BadInput& error);
/// Calls solve(), whose refusal names the scene's key.
auto naming_keys(const data::Scene& scene, const auto& solve) {
  try {
    return solve();
  } catch (const data::BadInput& error) {
    refuse_by_key(scene, error);
  }
}

/// The measures of a solved nip that are too large for linear theory: the mean strain across the sheet in the middle of
/// the nip, indentation/half-thickness, and the slope of the roller's parabola at the farther end of the contact, Y/R.
/// Throws BadInput, naming the given load or length, if that strain is 1 or more: the rollers' faces would meet.
template <class Number>
std::vector<BeyondTheory> beyond_theory(const data::Scene& scene, const SolvedContact<Number>& contact);

/// Whether the scene is solved by line loads.
bool is_by_line_loads(const data::Scene& scene);

/// Computes all results that the scene wants, and the indentation of a nip, see beyond_theory. `accuracy` is the
/// requested one.
template <class Number>
SceneSolution<Number> collect_results(const data::Scene& scene, const SolvedContact<Number>& contact,
                                      long double accuracy);

}  // namespace nipref::verify
