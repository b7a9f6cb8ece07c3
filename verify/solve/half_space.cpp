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
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/solve/internal/result_sizes.hpp>

namespace nipref::verify {
namespace {

using fast::Direction;
using fast::Estimate;

constexpr double degree = std::numbers::pi / 180;

/// The rounding error of compliances, couplings and critical speeds.
Estimate to_rounding(double value) { return {value, 0x1.8p-51 * std::fabs(value)}; }

constexpr Direction along{1, 0}, across{0, 1};

/// The part that all methods share.
class OnHalfSpace : public SolvedContact<Estimate> {
 public:
  OnHalfSpace(CountedResponse response, const data::HalfSpaceProblem& problem, double accuracy)
      : response_(std::move(response)),
        friction_(problem.friction),
        line_(problem.line),
        accuracy_(accuracy) {}

  [[nodiscard]] Estimate number(ResultId id) const final {
    if (id == ResultId::span_along) return span(along);
    if (id == ResultId::span_across) return span(across);
    if (id == ResultId::span_ratio) return span_ratio(across);
    if (id == ResultId::normal_force) return force();
    if (id == ResultId::friction_force) return Estimate{friction_, 0} * force();
    if (id == ResultId::peak_pressure) return peak_pressure();
    if (id == ResultId::critical_speed) return to_rounding(response_.critical_speed());
    if (id == ResultId::centre_along) return centre_along();
    if (id == ResultId::centre_across) return centre_across();
    return of_ellipse(id);
  }
  /// `place`: an angle from the motion, or a position on the scene's line.
  [[nodiscard]] Estimate at(ResultId id, double place) const final {
    if (id == ResultId::pressure) return pressure(Direction::of_degrees(*line_), place);
    if (id == ResultId::shear) return shear(Direction::of_degrees(*line_), place);
    const Direction psi = Direction::of_degrees(place);
    if (id == ResultId::span) return span(psi);
    if (id == ResultId::leading_end) return leading_end(psi);
    if (id == ResultId::trailing_end) return -1 * leading_end(reversed(psi));
    if (id == ResultId::creep || id == ResultId::compressed_radius) return of_rolling(id, psi);
    const fast::LineResponse line = response_(psi);
    if (id == ResultId::compliance) return to_rounding(line.compliance);
    // The couplings of two bodies subtract, and their difference may be far smaller than they are.
    return {line.coupling, std::max(to_rounding(line.compliance).error, to_rounding(line.coupling).error)};
  }
  [[nodiscard]] ProfileExtent profile_extent() const final {
    if (!line_) return {-90, 90};
    const Direction psi = Direction::of_degrees(*line_);
    return {-leading_end(reversed(psi)).value, leading_end(psi).value};
  }
  [[nodiscard]] std::optional<double> least_size(ResultId id, double place) const final {
    return half_space_result_size(id, place, accuracy_, *this,
                                  [&] { return response_(Direction::of_degrees(place)).compliance; });
  }
  [[nodiscard]] fast::Work work() const final {
    fast::Work work;
    work.line_responses = response_.evaluations();
    return work;
  }

 protected:
  [[nodiscard]] virtual Estimate span_ratio(
      Direction psi) const = 0;  ///< span over the span along the motion
  [[nodiscard]] virtual Estimate span(Direction psi) const = 0;
  [[nodiscard]] virtual Estimate force() const = 0;
  [[nodiscard]] virtual Estimate peak_pressure() const = 0;
  [[nodiscard]] virtual Estimate pressure(Direction psi, double x) const = 0;
  /// x+ on the line; it is half of the span where the centre is the point of first touch.
  [[nodiscard]] virtual Estimate leading_end(Direction psi) const { return 0.5 * span(psi); }
  [[nodiscard]] virtual Estimate centre_along() const { return {0, 0}; }
  [[nodiscard]] virtual Estimate centre_across() const { return {0, 0}; }
  [[nodiscard]] virtual Estimate shear(Direction psi, double x) const {
    return Estimate{friction_, 0} * pressure(psi, x);
  }
  /// Scene::check allows this result for a rolling sphere only.
  [[nodiscard]] virtual Estimate of_rolling(ResultId id, Direction) const {
    throw data::BadInput("wanted", data::scene_result(id).name, "must be out of what this method has");
  }
  /// Scene::check allows axis_ratio, orientation and approach for the exact method only.
  [[nodiscard]] virtual Estimate of_ellipse(ResultId id) const {
    throw data::BadInput("wanted", data::scene_result(id).name, "must be out of what this method has");
  }

 private:
  static Direction reversed(Direction psi) {
    return {-psi.cosine, -psi.sine, -psi.cosine_low, -psi.sine_low};
  }

  CountedResponse response_;
  double friction_;
  std::optional<double> line_;
  double accuracy_;  ///< requested by the scene
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

/// The ellipse under the scene's load or of its span.
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
    return 2 * (contact_.radius_ratio(psi) * load_.semi_major);
  }
  [[nodiscard]] Estimate span_ratio(Direction psi) const override { return contact_.span_ratio(psi, along); }
  [[nodiscard]] Estimate force() const override { return load_.force; }
  [[nodiscard]] Estimate peak_pressure() const override { return load_.peak_pressure; }
  [[nodiscard]] Estimate pressure(Direction psi, double x) const override {
    return contact_.pressure(load_, psi, x);
  }
  [[nodiscard]] Estimate of_ellipse(ResultId id) const override {
    if (id == ResultId::axis_ratio) return contact_.axis_ratio();
    if (id == ResultId::approach) return load_.approach;
    const auto [angle, error] = contact_.orientation();
    // The two senses of an axis are equivalent, so that its angle is from -90 to 90 degrees.
    return {std::remainder(angle / degree + motion_, 180),
            error / degree + 0x1p-52 * (std::fabs(angle / degree) + std::fabs(motion_))};
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

/// By the papers' rule: Contact is fast::SlidingContact or fast::RollingSphere.
template <class Contact>
class ByRule : public OnHalfSpace {
 public:
  ByRule(const CountedResponse& response, const data::HalfSpaceProblem& problem, double accuracy,
         Contact contact)
      : OnHalfSpace(response, problem, accuracy), contact_(std::move(contact)) {}

 protected:
  [[nodiscard]] Estimate span(Direction psi) const override { return span_ratio(psi) * contact_.span(); }
  [[nodiscard]] Estimate span_ratio(Direction psi) const override { return contact_.span_ratio(psi); }
  [[nodiscard]] Estimate force() const override { return contact_.force(); }
  [[nodiscard]] Estimate peak_pressure() const override { return contact_.peak_pressure(); }
  Contact contact_;
};

class BySlidingRule : public ByRule<fast::SlidingContact> {
 public:
  using ByRule::ByRule;

 private:
  [[nodiscard]] Estimate leading_end(Direction psi) const override {
    return contact_.along(psi).leading_end();
  }
  [[nodiscard]] Estimate centre_along() const override { return contact_.centre_along(); }
  [[nodiscard]] Estimate centre_across() const override { return contact_.centre_across(); }
  [[nodiscard]] Estimate pressure(Direction psi, double x) const override {
    return contact_.along(psi).pressure(x);
  }
};

class ByRollingRule : public ByRule<fast::RollingSphere> {
 public:
  using ByRule::ByRule;

 private:
  [[nodiscard]] Estimate pressure(Direction psi, double x) const override {
    return -1 * contact_.along(psi).normal_traction(x);
  }
  [[nodiscard]] Estimate shear(Direction psi, double x) const override {
    return contact_.along(psi).shear_traction(x);
  }
  [[nodiscard]] Estimate of_rolling(ResultId id, Direction psi) const override {
    const fast::RollingLine line = contact_.along(psi);
    return id == ResultId::creep ? line.creep : line.compressed_radius();
  }
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

SolvedInDouble solve_half_space(const data::Scene& scene, const data::HalfSpaceProblem& problem) {
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
