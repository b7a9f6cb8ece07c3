#include <string>
#include <utility>
#include <variant>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/joint_response.hpp>
#include <nipref/ref/half_space/response.hpp>

namespace nipref::ref {
struct JointResponse::SurfaceOf {
  double speed;

  Surface operator()(const data::IsotropicSolid& solid) const {
    return {sagittal_stiffness(ExactTransverse(solid)), speed, true};
  }
  Surface operator()(const data::TransverselyIsotropicBody& body) const {
    const ExactTransverse solid(body.solid);
    if (body.axis == data::SymmetryAxis::normal) return {sagittal_stiffness(solid), speed, true};
    return {exact_stiffness(solid, body.axis), speed, false};
  }
  Surface operator()(const data::Stiffness& solid) const { return {exact_stiffness(solid), speed, false}; }
};

JointResponse::JointResponse(const data::HalfSpaceProblem& problem, int digits)
    : digits_(digits),
      direction_(problem.direction),
      half_space_(std::visit(SurfaceOf{problem.speed}, problem.half_space)) {
  if (const auto* sphere = std::get_if<data::ElasticSphere>(&problem.body)) {
    body_ = SurfaceOf{sphere->moving_patch ? problem.speed : 0}(sphere->solid);
    body_->moves = sphere->moving_patch;
  }
}

void JointResponse::check_subcritical() const {
  const SurfaceDirection motion = SurfaceDirection::of_degrees(Exact(direction_));
  const auto check = [&](const Surface& surface) {
    if (surface.is_alike) {
      ref::check_subcritical(surface.solid, Exact(surface.speed), motion, motion);
    } else {
      ref::check_subcritical(surface.solid, Exact(surface.speed), motion);
    }
  };
  check(half_space_);
  if (body_) check(*body_);
}

LineResponse JointResponse::along(const Surface& surface, const Exact& from_motion, int digits,
                                  bool with_decay) const {
  ++*evaluations_;
  const Exact psi(mpq_class(from_motion.value() + Exact(direction_).value()));
  return line_response(surface.solid, Exact(surface.speed), SurfaceDirection::of_degrees(Exact(direction_)),
                       SurfaceDirection::of_degrees(psi), digits, with_decay);
}

SurfaceAnswer JointResponse::of_half_space(const Exact& depth) const {
  return [surface = *this, is_below = depth.sign() > 0](const Exact& degrees, int digits) -> LineAnswer {
    LineResponse line = surface.along(surface.half_space_, degrees, digits, is_below);
    return {line.compliance.value, line.coupling.value,         line.coupling_across.value,
            line.in_line.value,    line.shear_compliance.value, line.shear_compliance_across.value,
            std::move(line.decay)};
  };
}

SurfaceAnswer JointResponse::answer() const {
  if (!body_) return of_half_space();
  return [surface = *this, below = of_half_space()](const Exact& degrees, int digits) -> LineAnswer {
    LineAnswer joint = below(degrees, digits);
    const LineResponse above = surface.along(*surface.body_, degrees, digits);
    joint.compliance += above.compliance.value;
    joint.coupling -= above.coupling.value;
    joint.coupling_across -= above.coupling_across.value;
    joint.shear_compliance -= above.shear_compliance.value;
    joint.shear_compliance_across -= above.shear_compliance_across.value;
    return joint;
  };
}

Enclosure JointResponse::joint(double degrees, Enclosure LineResponse::*of, long sign) const {
  const Enclosure below = along(half_space_, Exact(degrees), digits_).*of;
  if (!body_) return below;
  return enclosure_of(interval_of(below) + sign * interval_of(along(*body_, Exact(degrees), digits_).*of),
                      digits_);
}

Estimate JointResponse::critical(const Surface& surface) const {
  const SurfaceDirection motion = SurfaceDirection::of_degrees(Exact(direction_));
  if (!surface.is_alike) return ref::critical_speed(surface.solid, motion, digits_).speed;
  const auto of_wave = surface_wave_speed(surface.solid, motion, motion, digits_);
  return of_wave ? *of_wave : limiting_speed(surface.solid, motion, motion, digits_);
}

Estimate JointResponse::critical_speed() const {
  Estimate slowest = critical(half_space_);
  // A contact that does not move over the body is never critical for the body.
  if (body_ && body_->moves) {
    Estimate of_body = critical(*body_);
    const bool proven = slowest.proven && of_body.proven;
    if (mpfr_less_p(raw(of_body.value), raw(slowest.value)) != 0) slowest = std::move(of_body);
    slowest.proven = proven;
  }
  return slowest;
}

}  // namespace nipref::ref
