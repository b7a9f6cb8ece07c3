#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <variant>

#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/rolling_sphere.hpp>
#include <nipref/fast/half_space/sliding.hpp>
#include <nipref/ref/half_space/elliptic.hpp>
#include <nipref/ref/half_space/rolling_sphere.hpp>
#include <nipref/ref/half_space/sliding.hpp>
#include <nipref/verify/solve/internal/counted_response.hpp>
#include <nipref/verify/solve/internal/half_space_contact.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/solve/internal/ref_surface.hpp>

namespace nipref::verify {
namespace {

using fast::Direction;
using Problem = data::HalfSpaceProblem;

constexpr Direction along{1, 0};

/// The radii of curvature of a body along the motion and across it.
struct RadiiOf {
  std::pair<double, double> operator()(const data::RigidDie& die) const {
    return {die.radius_along, die.radius_across};
  }
  std::pair<double, double> operator()(const auto& sphere) const { return {sphere.radius, sphere.radius}; }
};

fast::Indenter indenter(const Problem& problem) {
  const auto [radius_along, radius_across] = std::visit(RadiiOf(), problem.body);
  return {1 / radius_along, 1 / radius_across};
}
ref::Indenter ref_indenter(const Problem& problem) {
  const auto [radius_along, radius_across] = std::visit(RadiiOf(), problem.body);
  return ref::Indenter::of_radii(radius_along, radius_across);
}

/// Calls for_force or for_span with the number that the scene gives.
auto for_given(const Problem& problem, const auto& for_force, const auto& for_span) {
  const auto* const load = std::get_if<data::GivenNormalForce>(&problem.given);
  return load != nullptr ? for_force(load->force) : for_span(std::get<data::GivenSpan>(problem.given).along);
}

/// fast's ellipse together with its load.
class LoadedEllipse {
 public:
  LoadedEllipse(const CountedResponse& response, const Problem& problem)
      : contact_(response, indenter(problem)),
        load_(for_given(
            problem, [&](double force) { return contact_.for_force(force); },
            [&](double span) { return contact_.for_radius(along, span / 2); })) {}

  [[nodiscard]] fast::Estimate span(Direction psi) const {
    return 2 * (contact_.radius_ratio(psi) * load_.semi_major);
  }
  [[nodiscard]] fast::Estimate span_ratio(Direction psi) const { return contact_.span_ratio(psi, along); }
  [[nodiscard]] fast::Estimate force() const { return load_.force; }
  [[nodiscard]] fast::Estimate peak_pressure() const { return load_.peak_pressure; }
  [[nodiscard]] fast::Estimate pressure(Direction psi, double x) const {
    return contact_.pressure(load_, psi, x);
  }
  [[nodiscard]] fast::Estimate axis_ratio() const { return contact_.axis_ratio(); }
  [[nodiscard]] fast::Estimate approach() const { return load_.approach; }
  [[nodiscard]] fast::Estimate orientation() const {  ///< degrees from the motion
    constexpr double degree = std::numbers::pi / 180;
    const auto [angle, error] = contact_.orientation();
    return {angle / degree, error / degree};
  }

 private:
  fast::EllipticContact contact_;
  fast::EllipticLoad load_;
};

LoadedEllipse ellipse(const CountedResponse& response, const Problem& problem, int) {
  return {response, problem};
}
ref::EllipticContact ellipse(const RefSurface& surface, const Problem& problem, int digits) {
  return {surface.answer(), ref_indenter(problem), problem.given, digits};
}

fast::SlidingContact slide(const CountedResponse& response, const Problem& problem, int) {
  const bool similar = problem.rule == data::ContourRule::similar_contour;
  const auto rule = similar ? fast::SpanRule::similar_contour : fast::SpanRule::stationary_force;
  return for_given(
      problem,
      [&](double force) {
        return fast::sliding_for_force(response, indenter(problem), problem.friction, along, force, rule);
      },
      [&](double span) {
        return fast::sliding_for_span(response, indenter(problem), problem.friction, along, span, rule);
      });
}
ref::SlidingContact slide(const RefSurface& surface, const Problem& problem, int digits) {
  const bool similar = problem.rule == data::ContourRule::similar_contour;
  return {surface.answer(),
          ref_indenter(problem),
          ref::Exact(problem.friction),
          problem.given,
          digits,
          similar ? ref::SpanRule::similar_contour : ref::SpanRule::stationary_force};
}

fast::RollingSphere roll(const CountedResponse&, const Problem& problem, int) {
  const auto& solid = std::get<data::IsotropicSolid>(problem.half_space);
  const double radius = std::get<data::RigidRollingSphere>(problem.body).radius;
  return for_given(
      problem,
      [&](double force) { return fast::rolling_sphere_for_force(solid, radius, problem.speed, force); },
      [&](double span) { return fast::rolling_sphere_for_span(solid, radius, problem.speed, span); });
}
ref::RollingSphere roll(const RefSurface& surface, const Problem& problem, int digits) {
  return {surface.answer(), std::get<data::RigidRollingSphere>(problem.body).radius, problem.given, digits};
}

template <class Path, class Contact, class Surface>
std::unique_ptr<SolvedContact<typename Path::Number>> solved(const Surface& surface, const Problem& problem,
                                                             double accuracy, int digits,
                                                             Contact (*make)(const Surface&, const Problem&,
                                                                             int)) {
  return std::make_unique<HalfSpaceContact<Path, Surface, Contact>>(surface, problem, accuracy, digits, make);
}

template <class Path, class Surface>
auto solve_by(const Surface& surface, const Problem& problem, double accuracy, int digits) {
  if (problem.rule == data::ContourRule::exact)
    return solved<Path>(surface, problem, accuracy, digits, ellipse);
  return std::holds_alternative<data::RigidRollingSphere>(problem.body)
             ? solved<Path>(surface, problem, accuracy, digits, roll)
             : solved<Path>(surface, problem, accuracy, digits, slide);
}

}  // namespace

SolvedInDouble solve_half_space(const data::Scene& scene, const Problem& problem) {
  return solve_by<FastPath>(CountedResponse(problem, scene.origin), problem, scene.accuracy, 0);
}

SolvedByRef solve_ref_half_space(const RefSurface& surface, const Problem& problem, int digits) {
  return solve_by<RefPath>(surface, problem, std::pow(10.0, -digits), digits);
}

}  // namespace nipref::verify
