#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string_view>
#include <variant>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/anisotropic.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/joint_response.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>

namespace nipref::fast {
namespace {

Direction motion_of(const data::HalfSpaceProblem& problem) {
  return Direction::of_degrees(problem.direction);
}

Estimate to_rounding(double value) { return {value, 0x1.8p-51 * std::fabs(value)}; }

struct CriticalSpeedOf {
  Direction motion;

  double operator()(const data::IsotropicSolid& solid) const {
    return std::sqrt(solid.shear / solid.density) * isotropic_rayleigh_speed(solid.poisson);
  }
  double operator()(const data::TransverselyIsotropicBody& body) const {
    return critical_speed(body.solid, body.axis, motion).speed;
  }
  double operator()(const data::Stiffness& solid) const { return critical_speed(solid, motion).speed; }
};

struct ResponseOf {
  const data::HalfSpaceProblem& problem;

  SurfaceResponse operator()(const data::IsotropicSolid& solid) const {
    return [solid, speed = problem.speed](Direction from_motion) {
      return isotropic_response(solid, speed, from_motion);
    };
  }
  SurfaceResponse operator()(const data::TransverselyIsotropicBody& body) const {
    const Direction motion = motion_of(problem);
    const auto surface =
        std::make_shared<const TransverselyIsotropicHalfSpace>(body.solid, body.axis, motion, problem.speed);
    return [surface, motion](Direction from_motion) { return surface->along(from_motion.turned(motion)); };
  }
  SurfaceResponse operator()(const data::Stiffness& solid) const {
    const Direction motion = motion_of(problem);
    // No line tells by itself that another is critical.
    if (const auto critical = critical_speed(solid, motion); problem.speed >= critical.speed) {
      throw data::BadInput("speed", problem.speed,
                           fmt::format("must be below {}, which is critical on the line psi = {:.6g} degrees",
                                       critical.speed, critical.psi * 180 / std::numbers::pi));
    }
    const auto surface = std::make_shared<const AnisotropicHalfSpace>(solid, motion, problem.speed);
    return [surface, motion](Direction from_motion) { return surface->along(from_motion.turned(motion)); };
  }
};

struct BodyResponse {
  double speed;

  SurfaceResponse operator()(const data::ElasticSphere& sphere) const {
    const double of_patch = sphere.moving_patch ? speed : 0;
    return [solid = sphere.solid, of_patch](Direction from_motion) {
      return isotropic_response(solid, of_patch, from_motion);
    };
  }
  /// Rigid.
  template <class Body>
  SurfaceResponse operator()(const Body&) const {
    return {};
  }
};

void refuse_supercritical(double speed, double limit, std::string_view of) {
  if (speed < limit) return;
  throw data::BadInput("speed", speed,
                       fmt::format("must be below {:.6g}, where the line along the motion is critical: the "
                                   "Rayleigh speed of the {}",
                                   limit, of));
}

}  // namespace

JointResponse::JointResponse(const data::HalfSpaceProblem& problem) : problem_(&problem) {
  const CriticalSpeedOf critical{motion_of(problem)};
  if (const auto* solid = std::get_if<data::IsotropicSolid>(&problem.half_space))
    refuse_supercritical(problem.speed, critical(*solid), "half-space");
  if (const auto* sphere = std::get_if<data::ElasticSphere>(&problem.body); sphere && sphere->moving_patch)
    refuse_supercritical(problem.speed, critical(sphere->solid), "sphere");
  half_space_ = std::visit(ResponseOf{problem}, problem.half_space);
  body_ = std::visit(BodyResponse{problem.speed}, problem.body);
}

LineResponse JointResponse::operator()(Direction from_motion) const {
  ++*evaluations_;
  const LineResponse half_space = half_space_(from_motion);
  return body_ ? in_contact(half_space, body_(from_motion)) : half_space;
}

Estimate JointResponse::compliance(double degrees) const {
  return to_rounding((*this)(Direction::of_degrees(degrees)).compliance);
}

Estimate JointResponse::coupling(double degrees) const {
  const LineResponse line = (*this)(Direction::of_degrees(degrees));
  // The couplings of two bodies subtract, and their difference may be far smaller than they are.
  return {line.coupling, std::max(to_rounding(line.compliance).error, to_rounding(line.coupling).error)};
}

Estimate JointResponse::critical_speed() const {
  const CriticalSpeedOf critical{motion_of(*problem_)};
  const auto* sphere = std::get_if<data::ElasticSphere>(&problem_->body);
  const double of_body =
      sphere && sphere->moving_patch ? critical(sphere->solid) : std::numeric_limits<double>::infinity();
  return to_rounding(std::min(std::visit(critical, problem_->half_space), of_body));
}

}  // namespace nipref::fast
