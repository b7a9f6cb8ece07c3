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
  OnHalfSpace(CountedResponse response, const data::HalfSpaceProblem& problem, double accuracy)
      : response_(std::move(response)),
        friction_(problem.friction),
        line_(problem.line),
        accuracy_(accuracy) {}

  [[nodiscard]] Estimate number(std::string_view name) const final {
    if (name == "span_along") return span(along);
    if (name == "span_across") return span(across);
    if (name == "span_ratio") return span_ratio(across);
    if (name == "normal_force") return force();
    if (name == "friction_force") return times(Estimate{friction_, 0}, force());
    if (name == "peak_pressure") return peak_pressure();
    if (name == "critical_speed") return to_rounding(response_.critical_speed());
    if (name == "centre_along") return centre_along();
    if (name == "centre_across") return centre_across();
    return of_ellipse(name);
  }
  /// `place`: an angle from the motion, or a position on the scene's line.
  [[nodiscard]] Estimate at(std::string_view name, double place) const final {
    if (name == "pressure") return pressure(Direction::of_degrees(*line_), place);
    if (name == "shear") return shear(Direction::of_degrees(*line_), place);
    const Direction psi = Direction::of_degrees(place);
    if (name == "span") return span(psi);
    if (name == "leading_end") return leading_end(psi);
    if (name == "trailing_end") return times(-1, leading_end(reversed(psi)));
    if (name == "creep" || name == "compressed_radius") return of_rolling(name, psi);
    const fast::LineResponse line = response_(psi);
    if (name == "compliance") return to_rounding(line.compliance);
    // Between two bodies couplings subtract, and some vanish where compliances do not.
    return {line.coupling, few_roundings * std::max(line.compliance, std::fabs(line.coupling))};
  }
  [[nodiscard]] ProfileExtent profile_extent() const final {
    if (!line_) return {-90, 90};
    const Direction psi = Direction::of_degrees(*line_);
    return {-leading_end(reversed(psi)).value, leading_end(psi).value};
  }
  [[nodiscard]] std::optional<double> least_size(std::string_view name, double place) const final {
    if (name == "pressure" || name == "shear") {
      const auto [first, last] = profile_extent();
      return traction_size(place, first, last, accuracy_) * peak_pressure().value;
    }
    if (name == "centre_along" || name == "centre_across") return span(along).value;
    return half_space_result_size(name, [&] { return response_(Direction::of_degrees(place)).compliance; });
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
  [[nodiscard]] virtual Estimate pressure(Direction psi, double x) const = 0;
  /// x+ on the line; half of the span where the point of first touch is the centre.
  [[nodiscard]] virtual Estimate leading_end(Direction psi) const { return times(0.5, span(psi)); }
  [[nodiscard]] virtual Estimate centre_along() const { return {0, 0}; }
  [[nodiscard]] virtual Estimate centre_across() const { return {0, 0}; }
  [[nodiscard]] virtual Estimate shear(Direction psi, double x) const {
    return times(Estimate{friction_, 0}, pressure(psi, x));
  }
  /// Scene::check lets this be wanted of a rolling sphere only.
  [[nodiscard]] virtual Estimate of_rolling(std::string_view name, Direction) const {
    throw data::BadInput("wanted", name, "must be out of what this method has");
  }
  /// axis_ratio, orientation, approach: Scene::check lets them be wanted of the exact method only.
  [[nodiscard]] virtual Estimate of_ellipse(std::string_view name) const {
    throw data::BadInput("wanted", name, "must be out of what this method has");
  }

 private:
  static Direction reversed(Direction psi) {
    return {-psi.cosine, -psi.sine, -psi.cosine_low, -psi.sine_low};
  }

  CountedResponse response_;
  double friction_;
  std::optional<double> line_;
  double accuracy_;  ///< that the scene asks for
};

/// Of the distances to both ends, off by `distance_error` at most: f, which grows with both, and what it changes by;
/// 0 outside of the contact.
template <class Function>
Estimate between_ends(double ahead, double behind, double distance_error, const Function& f) {
  const auto changed = [&](double change) {
    const double a = ahead + change, b = behind + change;
    return a > 0 && b > 0 ? f(a, b) : 0.0;
  };
  const double value = changed(0);
  return {value, std::max(changed(distance_error) - value, value - changed(-distance_error)) +
                     few_roundings * value};
}

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
  Exact(const CountedResponse& response, const data::HalfSpaceProblem& problem, double accuracy)
      : OnHalfSpace(response, problem, accuracy),
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
  [[nodiscard]] Estimate pressure(Direction psi, double x) const override {
    const Estimate end = leading_end(psi);
    const Estimate shape =
        between_ends(end.value - x, end.value + x, end.error + 0x1p-52 * std::fabs(x),
                     [&](double ahead, double behind) { return std::sqrt(ahead * behind) / end.value; });
    return times(load_.peak_pressure, {shape.value, shape.error + shape.value * end.error / end.value});
  }
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
                                   load.force, rule());
  }
  fast::SlidingContact operator()(const data::GivenSpan& span) const {
    return fast::sliding_for_span(response, std::visit(IndenterOf{}, problem.body), problem.friction, along,
                                  span.along, rule());
  }
  [[nodiscard]] fast::SpanRule rule() const {
    return problem.rule == data::ContourRule::similar_contour ? fast::SpanRule::similar_contour
                                                              : fast::SpanRule::stationary_force;
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
  ByRule(const CountedResponse& response, const data::HalfSpaceProblem& problem, double accuracy,
         Contact contact)
      : OnHalfSpace(response, problem, accuracy), contact_(std::move(contact)) {}

 protected:
  [[nodiscard]] Estimate span(Direction psi) const override {
    return times(span_ratio(psi), contact_.span());
  }
  [[nodiscard]] Estimate span_ratio(Direction psi) const override {
    return to_rounding(contact_.span_ratio(psi), rounding_of(contact_));
  }
  [[nodiscard]] Estimate force() const override { return contact_.force(); }
  [[nodiscard]] Estimate peak_pressure() const override { return peak(contact_); }
  /// Relative, of the lengths on a line.
  [[nodiscard]] double uncertainty() const {
    const Estimate span = contact_.span();
    return span.error / span.value + rounding_of(contact_) + few_roundings;
  }

  Contact contact_;
};

class BySlidingRule : public ByRule<fast::SlidingContact> {
 public:
  using ByRule::ByRule;

 private:
  [[nodiscard]] Estimate leading_end(Direction psi) const override {
    const fast::SlidingLine line = contact_.along(psi);
    return {line.leading_end(), uncertainty() * line.span};
  }
  [[nodiscard]] Estimate centre_along() const override { return contact_.centre_along(); }
  [[nodiscard]] Estimate centre_across() const override { return contact_.centre_across(); }
  [[nodiscard]] Estimate pressure(Direction psi, double x) const override {
    const fast::SlidingLine line = contact_.along(psi);
    const double lead = line.leading_share, trail = line.trailing_share;
    const double ahead = line.leading_end() - x, behind = x - line.trailing_end();
    const double distance_error = uncertainty() * line.span + 0x1p-52 * std::fabs(x);
    const Estimate shape = between_ends(ahead, behind, distance_error, [&](double a, double b) {
      return std::pow(a / (trail * line.span), trail) * std::pow(b / (lead * line.span), lead);
    });
    const auto logarithm = [&](double distance) {
      return std::fabs(std::log(std::max(distance, distance_error) / line.span));
    };
    const double of_powers = uncertainty() * (4 + logarithm(ahead) + logarithm(behind));
    const Estimate peak{line.peak_pressure, uncertainty() * line.peak_pressure};
    return times(peak, {shape.value, shape.error + shape.value * of_powers});
  }
};

class ByRollingRule : public ByRule<fast::RollingSphere> {
 public:
  ByRollingRule(const CountedResponse& response, const data::HalfSpaceProblem& problem, double accuracy,
                fast::RollingSphere contact)
      : ByRule(response, problem, accuracy, std::move(contact)),
        radius_(std::get<data::RigidRollingSphere>(problem.body).radius) {}

 private:
  [[nodiscard]] Estimate pressure(Direction psi, double x) const override {
    const fast::ViscoelasticLine line = contact_.along(psi);
    return traction(line, x, -line.normal_traction(x), line.amplitude);
  }
  [[nodiscard]] Estimate shear(Direction psi, double x) const override {
    const fast::ViscoelasticLine line = contact_.along(psi);
    return traction(line, x, line.shear_traction(x), line.amplitude * line.shear_share);
  }
  /// sqrt(L^2 - 4x^2) times an amplitude and a wave: of the phase P ln(ahead/behind), and of B and Phi, which have a
  /// difference in them.
  [[nodiscard]] Estimate traction(const fast::ViscoelasticLine& line, double x, double value,
                                  double amplitude) const {
    const double half = line.span / 2, ahead = half - x, behind = half + x;
    const double distance_error = uncertainty() * half + 0x1p-52 * std::fabs(x);
    const Estimate root =
        between_ends(ahead, behind, distance_error, [](double a, double b) { return 2 * std::sqrt(a * b); });
    const double size = amplitude * (1 + std::fabs(x) / line.lean);
    if (root.value == 0) return {0, size * root.error};
    const double phase = line.index * (distance_error / ahead + distance_error / behind +
                                       uncertainty() * (1 + std::fabs(std::log(ahead / behind))));
    const double relative = uncertainty() * (3 + 2 * line.index * line.span / line.lean);
    return {value, size * (root.error + root.value * (std::min(2.0, phase) + relative))};
  }
  [[nodiscard]] Estimate of_rolling(std::string_view name, Direction psi) const override {
    const fast::ViscoelasticLine line = contact_.along(psi);
    if (name == "compressed_radius") return to_rounding(line.compressed_radius(), 2 * uncertainty());
    const double relative = line.span / radius_, squared = 4 * line.index * line.index;
    const double size = relative * (relative / 16 * (1 + squared) + line.index / line.shear_share);
    return {line.creep, 3 * uncertainty() * size};
  }

  double radius_;
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
  if (problem.rule == data::ContourRule::exact)
    return std::make_unique<Exact>(response, problem, scene.accuracy);
  if (std::holds_alternative<data::RigidRollingSphere>(problem.body)) {
    return std::make_unique<ByRollingRule>(response, problem, scene.accuracy,
                                           std::visit(Roll{problem}, problem.given));
  }
  return std::make_unique<BySlidingRule>(response, problem, scene.accuracy,
                                         std::visit(Slide{response, problem}, problem.given));
}

}  // namespace nipref::verify
