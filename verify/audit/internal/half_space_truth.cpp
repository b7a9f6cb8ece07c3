#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <variant>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/elliptic.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/half_space/rolling_sphere.hpp>
#include <nipref/ref/half_space/sliding.hpp>
#include <nipref/verify/audit/internal/half_space_truth.hpp>

namespace nipref::verify {
namespace {

using ref::Exact;
using ref::SurfaceDirection;

constexpr int truth_digits = 20, ellipse_digits = 16;
/// Beyond these the ellipse takes thousands of lines.
constexpr double most_slender = 10, fastest_with_ellipse = 0.7;

Truth as_truth(const ref::Enclosure& number) { return truth_of(number.value_text(), number.bound_text()); }
Truth as_truth(const ref::Estimated& number) { return truth_of(number.value_text(), number.error_text()); }

Truth multiplied(long double factor, const Truth& truth) {
  const double rounding = 1e-18 * std::fabs(static_cast<double>(factor * truth.value));
  return {factor * truth.value, std::fabs(static_cast<double>(factor)) * truth.error + rounding};
}

ref::Real joined(const ref::Real& a, const ref::Real& b, int sign) {
  ref::Real total = a;
  if (sign > 0) {
    mpfr_add(total.get(), a.get(), b.get(), MPFR_RNDN);
  } else {
    mpfr_sub(total.get(), a.get(), b.get(), MPFR_RNDN);
  }
  return total;
}

/// A solid that is touched, and how fast the contact moves over it.
struct Surface {
  ref::ExactStiffness solid;
  Exact speed;
  double direction;

  [[nodiscard]] ref::LineResponse along(const Exact& from_motion, int digits) const {
    const Exact psi(mpq_class(from_motion.value() + Exact(direction).value()));
    return ref::line_response(solid, speed, SurfaceDirection::of_degrees(Exact(direction)),
                              SurfaceDirection::of_degrees(psi), digits);
  }
};

struct SolidOf {
  ref::ExactStiffness operator()(const data::IsotropicSolid& solid) const {
    return ref::sagittal_stiffness(ref::ExactTransverse(solid));
  }
  ref::ExactStiffness operator()(const data::TransverselyIsotropicBody& body) const {
    const ref::ExactTransverse solid(body.solid);
    return body.axis == data::SymmetryAxis::normal ? ref::sagittal_stiffness(solid)
                                                   : ref::exact_stiffness(solid, body.axis);
  }
};

struct CurvatureOf {
  long double degrees;

  long double operator()(const data::RigidDie& die) const {
    const long double psi = degrees * std::numbers::pi_v<long double> / 180;
    const long double across = std::fabs(degrees) == 90 ? 0 : std::cos(psi) * std::cos(psi);
    return across / die.radius_along + std::sin(psi) * std::sin(psi) / die.radius_across;
  }
  long double operator()(const auto& sphere) const { return 1 / static_cast<long double>(sphere.radius); }
};

}  // namespace

Truth truth_of(const std::string& value, const std::string& error) {
  // A long double has 19 digits.
  const long double number = std::strtold(value.c_str(), nullptr);
  return {number, std::strtod(error.c_str(), nullptr) + 1e-19 * std::fabs(static_cast<double>(number))};
}

struct HalfSpaceTruth::Implementation {
  data::HalfSpaceProblem problem;
  Surface half_space;
  std::optional<Surface> body;  ///< none: rigid
  bool dear;

  [[nodiscard]] ref::LineAnswer answer(const Exact& degrees, int digits) const {
    const ref::LineResponse below = half_space.along(degrees, digits);
    if (!body)
      return {below.compliance.value, below.coupling.value, below.coupling_across.value, below.in_line.value};
    const ref::LineResponse above = body->along(degrees, digits);
    return {joined(below.compliance.value, above.compliance.value, 1),
            joined(below.coupling.value, above.coupling.value, -1),
            joined(below.coupling_across.value, above.coupling_across.value, -1), below.in_line.value};
  }
  [[nodiscard]] Truth line(double degrees, ref::Enclosure ref::LineResponse::*member, int sign) const {
    const Exact psi(degrees);
    Truth truth = as_truth(half_space.along(psi, truth_digits).*member);
    if (body) {
      const Truth above = as_truth(body->along(psi, truth_digits).*member);
      truth.value += sign * above.value;
      truth.error += above.error + 1e-19 * std::fabs(static_cast<double>(above.value));
    }
    return truth;
  }
  [[nodiscard]] ref::SurfaceAnswer surface() const {
    return [this](const Exact& psi, int digits) { return answer(psi, digits); };
  }
  /// Over that along the motion.
  [[nodiscard]] Truth span_ratio(double degrees) const {
    if (std::holds_alternative<data::RigidRollingSphere>(problem.body))
      return as_truth(ref::rolling_span_ratio(surface(), Exact(degrees), truth_digits));
    const Truth weighted =
        as_truth(ref::sliding_span_ratio(surface(), Exact(problem.friction), Exact(degrees), truth_digits));
    return multiplied(
        std::visit(CurvatureOf{0}, problem.body) / std::visit(CurvatureOf{degrees}, problem.body), weighted);
  }
  [[nodiscard]] std::optional<Truth> span(double degrees) const {
    const auto* given = std::get_if<data::GivenSpan>(&problem.given);
    if (given == nullptr) return {};
    return multiplied(given->along, span_ratio(degrees));
  }
  /// The body's curvature across the motion over that along it, and the mean radius of curvature.
  [[nodiscard]] Exact curvature_ratio() const {
    const auto* die = std::get_if<data::RigidDie>(&problem.body);
    if (die == nullptr) return Exact(1.0);
    return Exact(mpq_class(Exact(die->radius_along).value() / Exact(die->radius_across).value()));
  }
  [[nodiscard]] long double mean_radius() const {
    return 2 / (std::visit(CurvatureOf{0}, problem.body) + std::visit(CurvatureOf{90}, problem.body));
  }
  /// The surface in units in which its compliances are about 1: the ellipse's digits count from there.
  [[nodiscard]] ref::SurfaceAnswer in_units(int exponent) const {
    return [this, exponent](const Exact& psi, int digits) {
      ref::LineAnswer line = answer(psi, digits);
      mpfr_mul_2si(line.compliance.get(), line.compliance.get(), exponent, MPFR_RNDN);
      return line;
    };
  }
  /// Of the ellipse; the approach by F = stiffness sqrt(R) approach^(3/2).
  [[nodiscard]] std::optional<Truth> of_ellipse(std::string_view name) const {
    const double ratio = curvature_ratio().value().get_d();
    if (!dear || std::max(ratio, 1 / ratio) > most_slender ||
        problem.speed > fastest_with_ellipse * critical_speed().value)
      return {};
    const int exponent = -std::ilogb(line(0, &ref::LineResponse::compliance, 1).value);
    if (name == "axis_ratio")
      return as_truth(ref::elliptic_axis_ratio(in_units(exponent), curvature_ratio(), ellipse_digits));
    const auto* given = std::get_if<data::GivenNormalForce>(&problem.given);
    if (name != "approach" || given == nullptr) return {};
    const Truth stiffness =
        as_truth(ref::elliptic_stiffness(in_units(exponent), curvature_ratio(), ellipse_digits));
    const long double force = std::ldexp(static_cast<long double>(given->force), -exponent);
    const long double approach = std::pow(force / (stiffness.value * std::sqrt(mean_radius())), 2.0L / 3);
    const auto size = static_cast<double>(approach);
    return Truth{approach, size * (stiffness.error / static_cast<double>(stiffness.value) + 1e-18)};
  }
  [[nodiscard]] bool is_isotropic() const {
    return std::holds_alternative<data::IsotropicSolid>(problem.half_space);
  }
  [[nodiscard]] static Truth critical(const Surface& surface, bool is_isotropic) {
    const SurfaceDirection motion = SurfaceDirection::of_degrees(Exact(surface.direction));
    if (is_isotropic)
      return as_truth(ref::surface_wave_speed(surface.solid, motion, motion, truth_digits).value());
    return as_truth(ref::critical_speed(surface.solid, motion, truth_digits).speed);
  }
  [[nodiscard]] Truth critical_speed() const {
    const Truth below = critical(half_space, is_isotropic());
    const auto* sphere = std::get_if<data::ElasticSphere>(&problem.body);
    if (sphere == nullptr || !sphere->moving_patch) return below;
    const Truth above = critical(*body, true);
    return above.value < below.value ? above : below;
  }
  [[nodiscard]] std::optional<Truth> of(std::string_view name, double degrees) const {
    if (name == "compliance") return line(degrees, &ref::LineResponse::compliance, 1);
    if (name == "coupling") return line(degrees, &ref::LineResponse::coupling, -1);
    if (name == "critical_speed" && (dear || is_isotropic())) return critical_speed();
    if (problem.rule == data::ContourRule::exact) return of_ellipse(name);
    if (name == "span_ratio") return span_ratio(90);
    if (name == "span_along") return span(0);
    if (name == "span_across") return span(90);
    if (name == "span") return span(degrees);
    return {};
  }
};

HalfSpaceTruth::HalfSpaceTruth(const data::HalfSpaceProblem& problem, bool dear) {
  Implementation made{problem,
                      {std::visit(SolidOf{}, problem.half_space), Exact(problem.speed), problem.direction},
                      {},
                      dear};
  if (const auto* sphere = std::get_if<data::ElasticSphere>(&problem.body)) {
    made.body = Surface{SolidOf{}(sphere->solid), Exact(sphere->moving_patch ? problem.speed : 0.0),
                        problem.direction};
  }
  implementation_ = std::make_unique<const Implementation>(std::move(made));
}

HalfSpaceTruth::~HalfSpaceTruth() = default;

std::optional<Truth> HalfSpaceTruth::of(std::string_view name, double degrees) const {
  try {
    return implementation_->of(name, degrees);
  } catch (const data::BadInput&) {
    return {};  // where no proof is found
  }
}

}  // namespace nipref::verify
