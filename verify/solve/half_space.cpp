#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/joint_response.hpp>
#include <nipref/fast/half_space/rolling_sphere.hpp>
#include <nipref/fast/half_space/sliding.hpp>
#include <nipref/ref/half_space/elliptic.hpp>
#include <nipref/ref/half_space/joint_response.hpp>
#include <nipref/ref/half_space/rolling_sphere.hpp>
#include <nipref/ref/half_space/sliding.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>
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

/// An ellipse of fast together with its load.
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

/// The angle in degrees plus that of the motion, from -90 to 90: the two senses of an axis are equivalent.
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

/// A body on a half-space by either path: its contact is solved when a result first needs it; `surface` gives what
/// depends on the solids and the speed alone.
template <class Path, class Surface, class Contact>
class BodyOnHalfSpace final : public SolvedContact<typename Path::Number> {
  using Number = typename Path::Number;
  using Position = typename Path::Position;
  using Line = typename Path::Line;

 public:
  using Make = Contact(const Surface&, const Problem&, int digits);
  BodyOnHalfSpace(const Surface& surface, const Problem& problem, int digits, Make* make)
      : surface_(surface), problem_(problem), digits_(digits), make_(make) {}

  [[nodiscard]] ContactEnds ends() const override {
    if (!problem_.line) return {-90, 90};
    return {value_of(trailing_end_of(*problem_.line)), value_of(end(Path::line(*problem_.line)))};
  }
  [[nodiscard]] fast::Work work() const override { return {.line_responses = surface_.evaluations()}; }

 private:
  void answer(Asked<Number>& asked) const override {
    using enum ResultId;
    const auto set = [&](ResultId id, const auto& function) { asked.set(id, function); };
    set(span_along, [&] { return span_of(0); });
    set(span_across, [&] { return span_of(90); });
    set(span_ratio, [&] { return contact().span_ratio(Path::line(90)); });
    set(normal_force, [&] { return force(); });
    set(friction_force, [&] { return by_friction(force()); });
    set(peak_pressure, [&] { return contact().peak_pressure(); });
    set(critical_speed, [&] { return surface_.critical_speed(); });
    set(pressure, [&](double x) { return pressure_at(x); });
    set(shear, [&](double x) { return shear_at(x); });
    set(span, [&](double psi) { return span_of(psi); });
    set(leading_end, [&](double psi) { return end(Path::line(psi)); });
    set(trailing_end, [&](double psi) { return trailing_end_of(psi); });
    set(peak_on_line, [&](double psi) { return peak_of_line(psi); });
    set(compliance, [&](double psi) { return surface_.compliance(psi); });
    set(coupling, [&](double psi) { return surface_.coupling(psi); });
    if constexpr (requires(const Contact& one) { one.creep(Path::line(0)); }) {
      set(creep, [&](double psi) { return contact().creep(Path::line(psi)); });
      set(compressed_radius, [&](double psi) { return contact().compressed_radius(Path::line(psi)); });
    }
    if constexpr (requires(const Contact& one) { one.axis_ratio(); }) {
      set(axis_ratio, [&] { return contact().axis_ratio(); });
      set(approach, [&] { return contact().approach(); });
      set(orientation, [&] { return from_x1(contact().orientation(), problem_.direction); });
      const auto part = [](ResultId id, std::size_t i) {
        return std::pair(id, [i](const std::array<Number, 3>& u) { return u[i]; });
      };
      asked.set_parts(
          [&] { return mapped(asked.places, [&](const Place& place) { return displacement(place.y); }); },
          part(tangential_displacement, 0), part(transverse_displacement, 1), part(normal_displacement, 2));
    }
    if constexpr (requires(const Contact& one) { one.centre_along(); }) {
      if (Path::is_fast || problem_.friction != 0) {
        set(centre_along, [&] { return contact().centre_along(); });
        set(centre_across, [&] { return contact().centre_across(); });
        return;
      }
    }
    for (const ResultId centre : {centre_along, centre_across}) set(centre, [&] { return exact(0); });
  }

  const Contact& contact() const {
    if (!made_) made_ = make_(surface_, problem_, digits_);
    return *made_;
  }
  Number exact(double value) const { return Path::exactly(value, digits_); }
  /// The reference returns what the scene gives without an error.
  Number span_of(double degrees) const {
    const auto* given = std::get_if<data::GivenSpan>(&problem_.given);
    if (!Path::is_fast && given != nullptr && degrees == 0) return exact(given->along);
    return contact().span(Path::line(degrees));
  }
  Number force() const {
    const auto* given = std::get_if<data::GivenNormalForce>(&problem_.given);
    if (!Path::is_fast && given != nullptr) return exact(given->force);
    return contact().force();
  }
  Number by_friction(const Number& normal) const { return exact(problem_.friction) * normal; }
  Number pressure_at(double x) const { return contact().pressure(Path::line(*problem_.line), Position(x)); }
  /// The shear: friction times the pressure of a sliding body, or the shear under a rolling sphere.
  Number shear_at(double x) const {
    if constexpr (requires { contact().shear(Path::line(x), Position(x)); })
      return contact().shear(Path::line(*problem_.line), Position(x));
    return by_friction(pressure_at(x));
  }
  /// The displacements at x on the line and at the depth of the scene: along the motion, across it and downwards.
  std::array<Number, 3> displacement(double x) const {
    const Position depth(problem_.depth);
    if (!displaced_) displaced_ = contact().displacement(surface_.of_half_space(depth), depth);
    return displaced_(Path::line(*problem_.line), Position(x));
  }
  /// The end x+ of the contact on a line: half of the span if the centre is the point of first touch.
  Number end(const Line& psi) const {
    if constexpr (requires { contact().leading_end(psi); }) return contact().leading_end(psi);
    return 0.5 * contact().span(psi);
  }
  Number trailing_end_of(double degrees) const { return -1 * end(Path::reversed(Path::line(degrees))); }
  /// The largest pressure on a line. It differs between lines only if the contour is similar to those of the body.
  Number peak_of_line(double degrees) const {
    if constexpr (requires { contact().peak_pressure(Path::line(degrees)); })
      return contact().peak_pressure(Path::line(degrees));
    return contact().peak_pressure();
  }

  Surface surface_;
  Problem problem_;
  int digits_;  ///< the reference's
  Make* make_;
  mutable std::optional<Contact> made_;
  mutable std::function<std::array<Number, 3>(const Line&, const Position&)> displaced_;
};

template <class Path, class Surface, class Contact>
Solved<Path> body_on(const Surface& surface, const Problem& problem, int digits,
                     Contact (*make)(const Surface&, const Problem&, int)) {
  return std::make_unique<BodyOnHalfSpace<Path, Surface, Contact>>(surface, problem, digits, make);
}

template <class Path, class Surface>
auto solve_by(const Surface& surface, const Problem& problem, int digits) {
  if (problem.rule == data::ContourRule::exact)
    return body_on<Path, Surface>(surface, problem, digits, ellipse);
  return std::holds_alternative<data::RigidRollingSphere>(problem.body)
             ? body_on<Path, Surface>(surface, problem, digits, roll)
             : body_on<Path, Surface>(surface, problem, digits, slide);
}

}  // namespace

SolvedInDouble solve_half_space(const Problem& problem) {
  return solve_by<FastPath>(fast::JointResponse(problem), problem, 0);
}

SolvedByRef solve_ref_half_space(const ref::JointResponse& surface, const Problem& problem, int digits) {
  return solve_by<RefPath>(surface, problem, digits);
}

}  // namespace nipref::verify
