#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include <nipref/ref/half_space/elliptic.hpp>
#include <nipref/ref/half_space/rolling_sphere.hpp>
#include <nipref/ref/half_space/sliding.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/solve/internal/ref_surface.hpp>
#include <nipref/verify/solve/internal/result_sizes.hpp>

namespace nipref::verify {
namespace {

struct RefIndenterOf {
  ref::Indenter operator()(const data::RigidDie& die) const {
    return ref::Indenter::of_radii(die.radius_along, die.radius_across);
  }
  ref::Indenter operator()(const auto& sphere) const {
    return ref::Indenter::of_radii(sphere.radius, sphere.radius);
  }
};

constexpr int least_digits = 16;

/// The exact product of two doubles.
ref::Estimate exactly(double value, double factor, int digits) {
  ref::Real exact(2 * std::numeric_limits<double>::digits);
  mpfr_set_d(exact.get(), value, MPFR_RNDN);
  mpfr_mul_d(exact.get(), exact.get(), factor, MPFR_RNDN);
  return ref::Enclosure{exact, ref::Real(exact.precision()), digits};
}

/// The part that all methods share; the functions of Contact have the names of the results.
template <class Contact>
class RefOnHalfSpace : public SolvedContact<ref::Estimate> {
 public:
  using Make = Contact (*)(const RefSurface&, const data::HalfSpaceProblem&, int digits);

  RefOnHalfSpace(RefSurface surface, const data::HalfSpaceProblem& problem, int digits, Make make)
      : surface_(std::move(surface)), problem_(problem), digits_(digits), make_(make) {}

  [[nodiscard]] ref::Estimate number(ResultId id) const final {
    if (id == ResultId::span_along) return span(0);
    if (id == ResultId::span_across) return span(90);
    if (id == ResultId::span_ratio) return contact().span_ratio(ref::Exact(90.0));
    if (id == ResultId::normal_force) return force();
    if (id == ResultId::friction_force) return friction_force();
    if (id == ResultId::peak_pressure) return contact().peak_pressure();
    if (id == ResultId::critical_speed) return surface_.critical_speed(digits_);
    if (id == ResultId::centre_along || id == ResultId::centre_across) return centre(id);
    return of_ellipse(id);
  }
  /// `place`: an angle from the motion, or a position on the scene's line.
  [[nodiscard]] ref::Estimate at(ResultId id, double place) const final {
    if (id == ResultId::pressure) return pressure(place);
    if (id == ResultId::shear) return shear(place);
    if (id == ResultId::span) return span(place);
    if (id == ResultId::leading_end) return leading_end(ref::Exact(place));
    if (id == ResultId::trailing_end) return trailing_end(place);
    if (id == ResultId::creep || id == ResultId::compressed_radius) return of_rolling(id, ref::Exact(place));
    if (id == ResultId::compliance) return surface_.compliance(place, digits_);
    return surface_.coupling(place, digits_);
  }
  [[nodiscard]] ProfileExtent profile_extent() const final {
    if (!problem_.line) return {-90, 90};
    return {trailing_end(*problem_.line).to_double(), leading_end(ref::Exact(*problem_.line)).to_double()};
  }
  [[nodiscard]] std::optional<double> least_size(ResultId id, double place) const final {
    return half_space_result_size(id, place, std::pow(10.0, -digits_), *this,
                                  [&] { return surface_.compliance(place, least_digits).to_double(); });
  }
  [[nodiscard]] fast::Work work() const override {
    fast::Work work;
    work.line_responses = surface_.evaluations();
    return work;
  }

 private:
  [[nodiscard]] const Contact& contact() const {
    if (!contact_) contact_ = make_(surface_, problem_, digits_);
    return *contact_;
  }
  [[nodiscard]] ref::Estimate span(double degrees) const {
    const auto* given = std::get_if<data::GivenSpan>(&problem_.given);
    if (given != nullptr && degrees == 0) return exactly(given->along, 1, digits_);
    return contact().span(ref::Exact(degrees));
  }
  [[nodiscard]] ref::Estimate force() const {
    if (const auto* given = std::get_if<data::GivenNormalForce>(&problem_.given))
      return exactly(given->force, 1, digits_);
    return contact().force();
  }
  [[nodiscard]] ref::Estimate friction_force() const {
    if (problem_.friction == 0) return exactly(0, 1, digits_);
    if (const auto* given = std::get_if<data::GivenNormalForce>(&problem_.given))
      return exactly(given->force, problem_.friction, digits_);
    if constexpr (requires { contact().friction_force(); }) return contact().friction_force();
    throw data::BadInput("wanted", "friction_force", "must be of a contact that slides");
  }
  [[nodiscard]] ref::Estimate pressure(double x) const {
    return contact().pressure(ref::Exact(*problem_.line), ref::Exact(x));
  }
  /// Friction times the pressure of a sliding body, or the shear under a rolling sphere.
  [[nodiscard]] ref::Estimate shear(double x) const {
    if constexpr (requires { contact().shear(ref::Exact(x), ref::Exact(x)); })
      return contact().shear(ref::Exact(*problem_.line), ref::Exact(x));
    if (problem_.friction == 0) return exactly(0, 1, digits_);
    ref::Estimate result = pressure(x);
    mpfr_mul_d(result.value.get(), result.value.get(), problem_.friction, MPFR_RNDN);
    mpfr_mul_d(result.error.get(), result.error.get(), problem_.friction * (1 + 0x1p-40), MPFR_RNDU);
    return result;
  }
  /// x+ on the line in this direction; it is half of the span where the centre is the point of first touch.
  [[nodiscard]] ref::Estimate leading_end(const ref::Exact& degrees) const {
    if constexpr (requires { contact().leading_end(degrees); }) return contact().leading_end(degrees);
    ref::Estimate half = contact().span(degrees);
    mpfr_div_2ui(half.value.get(), half.value.get(), 1, MPFR_RNDN);
    mpfr_div_2ui(half.error.get(), half.error.get(), 1, MPFR_RNDU);
    return half;
  }
  [[nodiscard]] ref::Estimate trailing_end(double degrees) const {
    ref::Estimate end = leading_end(ref::Exact(mpq_class(ref::Exact(degrees).value() + 180)));
    mpfr_neg(end.value.get(), end.value.get(), MPFR_RNDN);
    return end;
  }
  [[nodiscard]] ref::Estimate centre(ResultId id) const {
    if constexpr (requires { contact().centre_along(); }) {
      if (problem_.friction != 0)
        return id == ResultId::centre_along ? contact().centre_along() : contact().centre_across();
    }
    return exactly(0, 1, digits_);
  }
  /// Scene::check allows these results for a rolling sphere only.
  [[nodiscard]] ref::Estimate of_rolling(ResultId id, const ref::Exact& degrees) const {
    if constexpr (requires { contact().creep(degrees); }) {
      return id == ResultId::creep ? contact().creep(degrees) : contact().compressed_radius(degrees);
    }
    throw data::BadInput("wanted", data::scene_result(id).name, "must be out of what this method has");
  }
  /// Scene::check allows these results for the exact method only.
  [[nodiscard]] ref::Estimate of_ellipse(ResultId id) const {
    if constexpr (requires { contact().axis_ratio(); }) {
      if (id == ResultId::axis_ratio) return contact().axis_ratio();
      if (id == ResultId::approach) return contact().approach();
      return orientation();
    }
    throw data::BadInput("wanted", data::scene_result(id).name, "must be out of what this method has");
  }
  /// The angle from x1, from -90 to 90 degrees, as the two senses of an axis are equivalent.
  [[nodiscard]] ref::Estimate orientation() const {
    ref::Estimate from_motion = contact().orientation();
    mpfr_prec_round(from_motion.value.get(), from_motion.value.precision() + 64, MPFR_RNDN);
    mpfr_add_d(from_motion.value.get(), from_motion.value.get(), problem_.direction, MPFR_RNDN);
    ref::Real half_turn(64);
    mpfr_set_ui(half_turn.get(), 180, MPFR_RNDN);
    mpfr_remainder(from_motion.value.get(), from_motion.value.get(), half_turn.get(), MPFR_RNDN);
    return from_motion;
  }

  RefSurface surface_;
  data::HalfSpaceProblem problem_;
  int digits_;
  Make make_;
  mutable std::optional<Contact> contact_;
};

ref::EllipticContact ellipse(const RefSurface& surface, const data::HalfSpaceProblem& problem, int digits) {
  return {surface.answer(), std::visit(RefIndenterOf{}, problem.body), problem.given, digits};
}

ref::SlidingContact slide(const RefSurface& surface, const data::HalfSpaceProblem& problem, int digits) {
  const bool similar = problem.rule == data::ContourRule::similar_contour;
  return {surface.answer(),
          std::visit(RefIndenterOf{}, problem.body),
          ref::Exact(problem.friction),
          problem.given,
          digits,
          similar ? ref::SpanRule::similar_contour : ref::SpanRule::stationary_force};
}

ref::RollingSphere roll(const RefSurface& surface, const data::HalfSpaceProblem& problem, int digits) {
  return {surface.answer(), std::get<data::RigidRollingSphere>(problem.body).radius, problem.given, digits};
}

}  // namespace

SolvedByRef solve_ref_half_space(const RefSurface& surface, const data::HalfSpaceProblem& problem,
                                 int digits) {
  if (problem.rule == data::ContourRule::exact)
    return std::make_unique<RefOnHalfSpace<ref::EllipticContact>>(surface, problem, digits, ellipse);
  if (std::holds_alternative<data::RigidRollingSphere>(problem.body))
    return std::make_unique<RefOnHalfSpace<ref::RollingSphere>>(surface, problem, digits, roll);
  return std::make_unique<RefOnHalfSpace<ref::SlidingContact>>(surface, problem, digits, slide);
}

}  // namespace nipref::verify
