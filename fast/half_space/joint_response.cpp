#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <variant>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/anisotropic.hpp>
#include <nipref/fast/half_space/internal/critical_speed.hpp>
#include <nipref/fast/half_space/internal/line_errors.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/joint_response.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>

namespace nipref::fast {
namespace {

Direction motion_of(const data::HalfSpaceProblem& problem) {
  return Direction::of_degrees(problem.direction);
}

Estimate to_rounding(double value) { return {value, internal::response_rounding * std::fabs(value)}; }

void refuse_supercritical(double speed, double limit, std::string_view of) {
  if (speed < limit) return;
  throw data::BadInput("speed", speed,
                       fmt::format("must be below {}, where the line along the motion is critical: the "
                                   "Rayleigh speed of the {}",
                                   limit, of));
}

double critical_speed(const data::IsotropicSolid& solid) {
  return std::sqrt(solid.shear / solid.density) * isotropic_rayleigh_speed(solid.poisson);
}

/// A surface and its critical speed. A rigid body has no response and an infinite critical speed.
struct Surface {
  SurfaceResponse response;
  PressureWaves inside = {};  ///< for a half-space only
  double critical_speed = std::numeric_limits<double>::infinity();
};

template <class HalfSpace>
Surface surface_of(const HalfSpace& solid, Direction motion, double critical_speed) {
  return {[=](Direction from_motion) { return solid.along(from_motion.turned(motion)); },
          [=](Direction from_motion) { return solid.inside(from_motion.turned(motion)); }, critical_speed};
}

struct HalfSpaceOf {
  const data::HalfSpaceProblem& problem;

  Surface operator()(const data::IsotropicSolid& solid) const {
    const double critical = critical_speed(solid);
    refuse_supercritical(problem.speed, critical, "half-space");
    return {[solid, speed = problem.speed](Direction from_motion) {
              return isotropic_response(solid, speed, from_motion);
            },
            [solid, speed = problem.speed](Direction from_motion) {
              return isotropic_pressure_wave(solid, speed, from_motion);
            },
            critical};
  }
  Surface operator()(const data::TransverselyIsotropicBody& body) const {
    const Direction motion = motion_of(problem);
    const TransverselyIsotropicHalfSpace solid(body.solid, body.axis, motion, problem.speed);
    return surface_of(solid, motion, solid.critical_speed());
  }
  Surface operator()(const data::Stiffness& solid) const {
    const Direction motion = motion_of(problem);
    // The response on one line does not show whether another line is critical.
    const auto critical = fast::critical_speed(solid, motion);
    if (problem.speed >= critical.speed) throw internal::supercritical(problem.speed, critical);
    return surface_of(AnisotropicHalfSpace(solid, motion, problem.speed), motion, critical.speed);
  }
};

struct BodyOf {
  double speed;

  Surface operator()(const data::ElasticSphere& sphere) const {
    Surface surface;
    if (sphere.moving_patch) {
      surface.critical_speed = critical_speed(sphere.solid);
      refuse_supercritical(speed, surface.critical_speed, "sphere");
    }
    const double of_patch = sphere.moving_patch ? speed : 0;
    surface.response = [solid = sphere.solid, of_patch](Direction from_motion) {
      return isotropic_response(solid, of_patch, from_motion);
    };
    return surface;
  }
  /// A rigid body.
  template <class Body>
  Surface operator()(const Body&) const {
    return {};
  }
};

}  // namespace

JointResponse::JointResponse(const data::HalfSpaceProblem& problem) {
  const Surface half_space = std::visit(HalfSpaceOf{problem}, problem.half_space),
                body = std::visit(BodyOf{problem.speed}, problem.body);
  half_space_ = half_space.response;
  inside_ = half_space.inside;
  body_ = body.response;
  critical_speed_ = std::min(half_space.critical_speed, body.critical_speed);
}

LineResponse JointResponse::operator()(Direction from_motion) const {
  ++*evaluations_;
  const LineResponse half_space = half_space_(from_motion);
  return body_ ? in_contact(half_space, body_(from_motion)) : half_space;
}

PressureWaves JointResponse::of_half_space(double depth) const {
  return [response = depth > 0 ? inside_ : PressureWaves(half_space_),
          evaluations = evaluations_](Direction from_motion) {
    ++*evaluations;
    return response(from_motion);
  };
}

Estimate JointResponse::compliance(double degrees) const {
  return to_rounding((*this)(Direction::of_degrees(degrees)).compliance);
}

Estimate JointResponse::coupling(double degrees) const {
  const Direction from_motion = Direction::of_degrees(degrees);
  const LineResponse line = (*this)(from_motion);
  // The couplings of two bodies are subtracted, and their difference may be far smaller than the sum of their sizes, which
  // is at most that of the difference and twice that of one.
  const double sizes = std::fabs(line.coupling) + (body_ ? 2 * std::fabs(body_(from_motion).coupling) : 0);
  return {line.coupling, to_rounding(std::max(line.compliance, sizes)).error};
}

Estimate JointResponse::critical_speed() const { return to_rounding(critical_speed_); }

}  // namespace nipref::fast
