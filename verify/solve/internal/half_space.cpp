#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>
#include <variant>

#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/rolling_sphere.hpp>
#include <nipref/fast/half_space/sliding.hpp>
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>
#include <nipref/verify/solve/internal/counted_response.hpp>
#include <nipref/verify/solve/internal/half_space.hpp>
#include <nipref/verify/solve/internal/result_sizes.hpp>

namespace nipref::verify {
namespace {

using fast::Direction;
using fast::Estimate;

constexpr double degree = std::numbers::pi / 180;

Estimate times(double factor, const Estimate& estimate) {
  return {factor * estimate.value, std::fabs(factor) * estimate.error};
}

/// The product, with its rounding.
Estimate times(const Estimate& a, const Estimate& b) {
  const double value = a.value * b.value;
  return {value, std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + 0x1p-53 * std::fabs(value)};
}

/// Of compliances and couplings.
constexpr double few_roundings = 0x1.8p-51;

Estimate to_rounding(double value, double relative = few_roundings) {
  return {value, relative * std::fabs(value)};
}

constexpr Direction along{1, 0}, across{0, 1};

/// What all methods have in common: everything about lines through the point of first touch.
class OnHalfSpace : public SolvedContact<Estimate> {
 public:
  OnHalfSpace(CountedResponse response, double friction)
      : response_(std::move(response)), friction_(friction) {}

  [[nodiscard]] Estimate number(std::string_view name) const final {
    if (name == "span_along") return span(along);
    if (name == "span_across") return span(across);
    if (name == "span_ratio") return span_ratio(across);
    if (name == "normal_force") return force();
    if (name == "friction_force") return times(Estimate{friction_, 0}, force());
    if (name == "peak_pressure") return peak_pressure();
    if (name == "critical_speed") return to_rounding(response_.critical_speed());
    return of_ellipse(name);
  }
  [[nodiscard]] Estimate at(std::string_view name, double degrees) const final {
    const Direction psi = Direction::of_degrees(degrees);
    if (name == "span") return span(psi);
    const fast::LineResponse line = response_(psi);
    if (name == "compliance") return to_rounding(line.compliance);
    // Between two bodies couplings subtract, and some vanish where compliances do not.
    return {line.coupling, few_roundings * std::max(line.compliance, std::fabs(line.coupling))};
  }
  [[nodiscard]] ProfileExtent profile_extent() const final { return {-90, 90}; }
  [[nodiscard]] std::optional<double> least_size(std::string_view name, double degrees) const final {
    return half_space_result_size(name, [&] { return response_(Direction::of_degrees(degrees)).compliance; });
  }
  [[nodiscard]] fast::Work work() const final {
    fast::Work work;
    work.line_responses = response_.evaluations();
    return work;
  }

 protected:
  [[nodiscard]] virtual Estimate span_ratio(Direction psi) const = 0;  ///< over the span along the motion
  [[nodiscard]] virtual Estimate span(Direction psi) const = 0;
  [[nodiscard]] virtual Estimate force() const = 0;
  [[nodiscard]] virtual Estimate peak_pressure() const = 0;
  /// axis_ratio, orientation, approach: Scene::check lets them be wanted of the exact method only.
  [[nodiscard]] virtual Estimate of_ellipse(std::string_view name) const {
    throw data::BadInput("wanted", name, "must be out of what this method has");
  }

 private:
  CountedResponse response_;
  double friction_;
};

struct IndenterOf {
  fast::Indenter operator()(const data::RigidDie& die) const {
    return {1 / die.radius_along, 1 / die.radius_across};
  }
  template <class Sphere>
  fast::Indenter operator()(const Sphere& sphere) const {
    return fast::Indenter::sphere(sphere.radius);
  }
};

/// The scene's load on an ellipse.
struct LoadEllipse {
  const fast::EllipticContact& contact;

  fast::EllipticLoad operator()(const data::GivenNormalForce& load) const {
    return contact.for_force(load.force);
  }
  fast::EllipticLoad operator()(const data::GivenSpan& span) const {
    return contact.for_radius(along, span.along / 2);
  }
};

class Exact : public OnHalfSpace {
 public:
  Exact(const CountedResponse& response, const data::HalfSpaceProblem& problem)
      : OnHalfSpace(response, 0),
        contact_(response, std::visit(IndenterOf{}, problem.body)),
        load_(std::visit(LoadEllipse{contact_}, problem.given)),
        motion_(problem.direction) {}

 private:
  [[nodiscard]] Estimate span(Direction psi) const override {
    return times(2, times(contact_.radius_ratio(psi), load_.semi_major));
  }
  [[nodiscard]] Estimate span_ratio(Direction psi) const override {
    const Estimate radius = contact_.radius_ratio(psi), of_motion = contact_.radius_ratio(along);
    const double relative = radius.error / radius.value + of_motion.error / of_motion.value;
    return to_rounding(radius.value / of_motion.value, relative + few_roundings);
  }
  [[nodiscard]] Estimate force() const override { return load_.force; }
  [[nodiscard]] Estimate peak_pressure() const override { return load_.peak_pressure; }
  [[nodiscard]] Estimate of_ellipse(std::string_view name) const override {
    if (name == "axis_ratio") return contact_.axis_ratio();
    if (name == "approach") return load_.approach;
    const Estimate from_motion = times(1 / degree, contact_.orientation());
    // An axis has no sense: -90 to 90 degrees.
    return {std::remainder(from_motion.value + motion_, 180),
            from_motion.error + 0x1p-52 * (std::fabs(from_motion.value) + std::fabs(motion_))};
  }

  fast::EllipticContact contact_;
  fast::EllipticLoad load_;
  double motion_;
};

struct Slide {
  const CountedResponse& response;
  const data::HalfSpaceProblem& problem;

  fast::SlidingContact operator()(const data::GivenNormalForce& load) const {
    return fast::sliding_for_force(response, std::visit(IndenterOf{}, problem.body), problem.friction, along,
                                   load.force);
  }
  fast::SlidingContact operator()(const data::GivenSpan& span) const {
    return fast::sliding_for_span(response, std::visit(IndenterOf{}, problem.body), problem.friction, along,
                                  span.along);
  }
};

double rounding_of(const fast::SlidingContact& contact) { return contact.rounding(); }
double rounding_of(const fast::RollingSphere& contact) { return contact.rounding; }

Estimate peak(const fast::SlidingContact& contact) { return contact.peak_pressure(); }
/// At the centre, the same on every line.
Estimate peak(const fast::RollingSphere& contact) {
  const Estimate span = contact.span();
  const fast::ViscoelasticLine line = contact.along(along);
  const double pressure = -line.normal_traction(0);
  // B is a difference.
  const double condition = 1 + 2 * line.index * line.span / line.lean;
  return {pressure, pressure * condition * (span.error / span.value + contact.rounding)};
}

/// By the papers' rule: Contact is fast::SlidingContact or fast::RollingSphere.
template <class Contact>
class ByRule : public OnHalfSpace {
 public:
  ByRule(const CountedResponse& response, double friction, Contact contact)
      : OnHalfSpace(response, friction), contact_(std::move(contact)) {}

 private:
  [[nodiscard]] Estimate span(Direction psi) const override {
    return times(span_ratio(psi), contact_.span());
  }
  [[nodiscard]] Estimate span_ratio(Direction psi) const override {
    return to_rounding(contact_.span_ratio(psi), rounding_of(contact_));
  }
  [[nodiscard]] Estimate force() const override { return contact_.force(); }
  [[nodiscard]] Estimate peak_pressure() const override { return peak(contact_); }

  Contact contact_;
};

struct Roll {
  const data::HalfSpaceProblem& problem;

  [[nodiscard]] const data::IsotropicSolid& solid() const {
    return std::get<data::IsotropicSolid>(problem.half_space);
  }
  [[nodiscard]] double radius() const { return std::get<data::RigidRollingSphere>(problem.body).radius; }

  fast::RollingSphere operator()(const data::GivenNormalForce& load) const {
    return fast::rolling_sphere_for_force(solid(), radius(), problem.speed, load.force);
  }
  fast::RollingSphere operator()(const data::GivenSpan& span) const {
    return fast::rolling_sphere_for_span(solid(), radius(), problem.speed, span.along);
  }
};

}  // namespace

std::unique_ptr<SolvedContact<Estimate>> solve_half_space(const data::Scene& scene,
                                                          const data::HalfSpaceProblem& problem) {
  const CountedResponse response(problem, scene.origin);
  if (problem.rule == data::ContourRule::exact) return std::make_unique<Exact>(response, problem);
  if (std::holds_alternative<data::RigidRollingSphere>(problem.body))
    return std::make_unique<ByRule<fast::RollingSphere>>(response, 0,
                                                         std::visit(Roll{problem}, problem.given));
  return std::make_unique<ByRule<fast::SlidingContact>>(response, problem.friction,
                                                        std::visit(Slide{response, problem}, problem.given));
}

}  // namespace nipref::verify
