#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/joint_response.hpp>
#include <nipref/fast/half_space/rolling_sphere.hpp>
#include <nipref/fast/half_space/sliding.hpp>
#include <nipref/ref/half_space/elliptic.hpp>
#include <nipref/ref/half_space/joint_response.hpp>
#include <nipref/ref/half_space/rolling_sphere.hpp>
#include <nipref/ref/half_space/sliding.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/support/internal/common.hpp>

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
  LoadedEllipse(const fast::JointResponse& response, const Problem& problem)
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
  [[nodiscard]] auto displacement(const fast::PressureWaves& half_space, double depth) const {
    return [one = *this, half_space, depth](Direction psi, double x) {
      return one.contact_.displacement(one.load_, half_space, psi, x, depth);
    };
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

LoadedEllipse ellipse(const fast::JointResponse& response, const Problem& problem, int) {
  return {response, problem};
}
ref::EllipticContact ellipse(const ref::JointResponse& surface, const Problem& problem, int digits) {
  return {surface.answer(), ref_indenter(problem), problem.given, digits};
}

fast::SlidingContact slide(const fast::JointResponse& response, const Problem& problem, int) {
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
ref::SlidingContact slide(const ref::JointResponse& surface, const Problem& problem, int digits) {
  const bool similar = problem.rule == data::ContourRule::similar_contour;
  return ref::SlidingContact(surface.answer(), ref_indenter(problem), ref::Exact(problem.friction),
                             problem.given, digits,
                             similar ? ref::SpanRule::similar_contour : ref::SpanRule::stationary_force);
}

fast::RollingSphere roll(const fast::JointResponse&, const Problem& problem, int) {
  const auto& solid = std::get<data::IsotropicSolid>(problem.half_space);
  const double radius = std::get<data::RigidRollingSphere>(problem.body).radius;
  return for_given(
      problem,
      [&](double force) { return fast::rolling_sphere_for_force(solid, radius, problem.speed, force); },
      [&](double span) { return fast::rolling_sphere_for_span(solid, radius, problem.speed, span); });
}
ref::RollingSphere roll(const ref::JointResponse& surface, const Problem& problem, int digits) {
  return {surface.answer(), std::get<data::RigidRollingSphere>(problem.body).radius, problem.given, digits};
}

/// The angle in degrees plus that of the motion. The two senses of an axis are equivalent, so that it is from -90 to
/// 90.
fast::Estimate from_x1(const fast::Estimate& from_motion, double motion) {
  return {std::remainder(from_motion.value + motion, 180),
          from_motion.error + 0x1p-52 * (std::fabs(from_motion.value) + std::fabs(motion))};
}
ref::Estimate from_x1(ref::Estimate angle, double motion) {
  mpfr_prec_round(ref::raw(angle.value), ref::bits_of(angle.value) + 64, MPFR_RNDN);
  mpfr_add_d(ref::raw(angle.value), ref::raw(angle.value), motion, MPFR_RNDN);
  ref::Float half_turn = ref::zero_of_bits(64);
  mpfr_set_ui(ref::raw(half_turn), 180, MPFR_RNDN);
  mpfr_remainder(ref::raw(angle.value), ref::raw(angle.value), ref::raw(half_turn), MPFR_RNDN);
  return angle;
}

/// A body on a half-space by either path: `contact` is solved when a result first needs it; `surface` gives what
/// depends on the solids and the speed alone.
template <class Path, class Surface, class Contact>
struct BodyOnHalfSpace {
  using Number = typename Path::Number;
  using Position = typename Path::Position;

  Surface surface;
  Problem problem;
  int digits;  ///< the reference's
  Contact (*make)(const Surface&, const Problem&, int digits);
  std::optional<Contact> made = {};
  /// At x on a line, at the scene's depth: along the motion, across it and into the half-space.
  std::function<std::array<Number, 3>(const typename Path::Line&, const Position&)> displaced = {};

  const Contact& contact() {
    if (!made) made = make(surface, problem, digits);
    return *made;
  }
  [[nodiscard]] Number exactly(double value) const { return Path::exactly(value, digits); }
  /// The reference returns what the scene gives without an error.
  Number span(double degrees) {
    const auto* given = std::get_if<data::GivenSpan>(&problem.given);
    if (!Path::is_fast && given != nullptr && degrees == 0) return exactly(given->along);
    return contact().span(Path::line(degrees));
  }
  Number normal_force() {
    const auto* given = std::get_if<data::GivenNormalForce>(&problem.given);
    if (!Path::is_fast && given != nullptr) return exactly(given->force);
    return contact().force();
  }
  Number by_friction(const Number& normal) { return exactly(problem.friction) * normal; }
  Number pressure(double x) { return contact().pressure(Path::line(*problem.line), Position(x)); }
  /// Friction times the pressure of a sliding body, or the shear under a rolling sphere.
  Number shear(double x) {
    if constexpr (requires { contact().shear(Path::line(x), Position(x)); })
      return contact().shear(Path::line(*problem.line), Position(x));
    return by_friction(pressure(x));
  }
  /// At x on the scene's line.
  std::array<Number, 3> displacement(double x) {
    const Position depth(problem.depth);
    if (!displaced) displaced = contact().displacement(surface.of_half_space(depth), depth);
    return displaced(Path::line(*problem.line), Position(x));
  }
  /// x+ on the line in this direction; it is half of the span where the centre is the point of first touch.
  Number end(const typename Path::Line& psi) {
    if constexpr (requires { contact().leading_end(psi); }) return contact().leading_end(psi);
    return 0.5 * contact().span(psi);
  }
  Number leading_end(double degrees) { return end(Path::line(degrees)); }
  /// Lines differ in it only where their contours are the body's own.
  Number peak_on_line(double degrees) {
    if constexpr (requires { contact().peak_pressure(Path::line(degrees)); })
      return contact().peak_pressure(Path::line(degrees));
    return contact().peak_pressure();
  }
  Number trailing_end(double degrees) { return -1 * end(Path::reversed(Path::line(degrees))); }
  ContactEnds ends() {
    if (!problem.line) return {-90, 90};
    return {value_of(trailing_end(*problem.line)), value_of(leading_end(*problem.line))};
  }
  [[nodiscard]] fast::Work work() const { return {.line_responses = surface.evaluations()}; }
};

template <class Path, class Contact, class Surface>
std::unique_ptr<SolvedContact<typename Path::Number>> solved(const Surface& surface, const Problem& problem,
                                                             int digits,
                                                             Contact (*make)(const Surface&, const Problem&,
                                                                             int)) {
  using Number = typename Path::Number;
  using Body = BodyOnHalfSpace<Path, Surface, Contact>;
  auto contact = std::make_unique<SolvedContact<Number>>();
  const auto body = std::make_shared<Body>(Body{surface, problem, digits, make});
  const auto set = [&](ResultId id, auto function) { contact->set(id, body, function); };
  set(ResultId::span_along, [](Body& one) { return one.span(0); });
  set(ResultId::span_across, [](Body& one) { return one.span(90); });
  set(ResultId::span_ratio, [](Body& one) { return one.contact().span_ratio(Path::line(90)); });
  set(ResultId::normal_force, &Body::normal_force);
  set(ResultId::friction_force, [](Body& one) { return one.by_friction(one.normal_force()); });
  set(ResultId::peak_pressure, [](Body& one) { return one.contact().peak_pressure(); });
  set(ResultId::critical_speed, [](Body& one) { return one.surface.critical_speed(); });
  set(ResultId::pressure, &Body::pressure);
  set(ResultId::shear, &Body::shear);
  set(ResultId::span, &Body::span);
  set(ResultId::leading_end, &Body::leading_end);
  set(ResultId::trailing_end, &Body::trailing_end);
  set(ResultId::peak_on_line, &Body::peak_on_line);
  set(ResultId::compliance, [](Body& one, double psi) { return one.surface.compliance(psi); });
  set(ResultId::coupling, [](Body& one, double psi) { return one.surface.coupling(psi); });
  for (const ResultId centre : {ResultId::centre_along, ResultId::centre_across})
    set(centre, [](Body& one) { return one.exactly(0); });
  if constexpr (requires(const Contact& one) { one.centre_along(); }) {
    if (Path::is_fast || problem.friction != 0) {
      set(ResultId::centre_along, [](Body& one) { return one.contact().centre_along(); });
      set(ResultId::centre_across, [](Body& one) { return one.contact().centre_across(); });
    }
  }
  if constexpr (requires(const Contact& one) { one.creep(Path::line(0)); }) {
    set(ResultId::creep, [](Body& one, double psi) { return one.contact().creep(Path::line(psi)); });
    set(ResultId::compressed_radius,
        [](Body& one, double psi) { return one.contact().compressed_radius(Path::line(psi)); });
  }
  if constexpr (requires(const Contact& one) { one.axis_ratio(); }) {
    using Displacement = std::array<Number, 3>;
    contact->template set_parts<Displacement>(
        [body](const Places& places) {
          return mapped(places, [&](const Place& place) { return body->displacement(place.y); });
        },
        {{ResultId::tangential_displacement, [](const Displacement& u) { return u[0]; }},
         {ResultId::transverse_displacement, [](const Displacement& u) { return u[1]; }},
         {ResultId::normal_displacement, [](const Displacement& u) { return u[2]; }}});
    set(ResultId::axis_ratio, [](Body& one) { return one.contact().axis_ratio(); });
    set(ResultId::approach, [](Body& one) { return one.contact().approach(); });
    set(ResultId::orientation,
        [](Body& one) { return from_x1(one.contact().orientation(), one.problem.direction); });
  }
  contact->ends = [body] { return body->ends(); };
  contact->work = [body] { return body->work(); };
  return contact;
}

template <class Path, class Surface>
auto solve_by(const Surface& surface, const Problem& problem, int digits) {
  if (problem.rule == data::ContourRule::exact) return solved<Path>(surface, problem, digits, ellipse);
  return std::holds_alternative<data::RigidRollingSphere>(problem.body)
             ? solved<Path>(surface, problem, digits, roll)
             : solved<Path>(surface, problem, digits, slide);
}

}  // namespace

SolvedInDouble solve_half_space(const Problem& problem) {
  return solve_by<FastPath>(fast::JointResponse(problem), problem, 0);
}

SolvedByRef solve_ref_half_space(const ref::JointResponse& surface, const Problem& problem, int digits) {
  return solve_by<RefPath>(surface, problem, digits);
}

}  // namespace nipref::verify
