#include <string>
#include <utility>
#include <variant>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/solve/internal/ref_surface.hpp>

namespace nipref::verify {
namespace {

ref::Real joined(const ref::Real& a, const ref::Real& b, int sign) {
  ref::Real total = a;
  if (sign > 0) {
    mpfr_add(total.get(), a.get(), b.get(), MPFR_RNDN);
  } else {
    mpfr_sub(total.get(), a.get(), b.get(), MPFR_RNDN);
  }
  return total;
}

}  // namespace

struct RefSurface::SurfaceOf {
  double speed;

  Surface operator()(const data::IsotropicSolid& solid) const {
    return {ref::sagittal_stiffness(ref::ExactTransverse(solid)), speed, true};
  }
  Surface operator()(const data::TransverselyIsotropicBody& body) const {
    const ref::ExactTransverse solid(body.solid);
    if (body.axis == data::SymmetryAxis::normal) return {ref::sagittal_stiffness(solid), speed, true};
    return {ref::exact_stiffness(solid, body.axis), speed, false};
  }
  Surface operator()(const data::Stiffness& solid) const {
    return {ref::exact_stiffness(solid), speed, false};
  }
};

RefSurface::RefSurface(const data::HalfSpaceProblem& problem, int digits)
    : digits_(digits),
      rolls_(std::holds_alternative<data::RigidRollingSphere>(problem.body)),
      direction_(problem.direction),
      half_space_(std::visit(SurfaceOf{problem.speed}, problem.half_space)) {
  if (const auto* sphere = std::get_if<data::ElasticSphere>(&problem.body)) {
    body_ = SurfaceOf{sphere->moving_patch ? problem.speed : 0}(sphere->solid);
    body_->moves = sphere->moving_patch;
  }
}

void RefSurface::check_subcritical(const data::SceneOrigin& origin) const {
  const ref::SurfaceDirection motion = ref::SurfaceDirection::of_degrees(ref::Exact(direction_));
  const auto check = [&](const Surface& surface) {
    if (surface.is_alike) {
      ref::check_subcritical(surface.solid, ref::Exact(surface.speed), motion, motion);
    } else {
      ref::check_subcritical(surface.solid, ref::Exact(surface.speed), motion);
    }
  };
  try {
    check(half_space_);
    if (body_) check(*body_);
  } catch (const data::BadInput& error) {
    origin.refuse_as(rolls_ ? "rolling.speed" : "sliding.speed", error);
  }
}

ref::LineResponse RefSurface::along(const Surface& surface, const ref::Exact& from_motion, int digits) const {
  ++*evaluations_;
  const ref::Exact psi(mpq_class(from_motion.value() + ref::Exact(direction_).value()));
  return ref::line_response(surface.solid, ref::Exact(surface.speed),
                            ref::SurfaceDirection::of_degrees(ref::Exact(direction_)),
                            ref::SurfaceDirection::of_degrees(psi), digits);
}

ref::SurfaceAnswer RefSurface::answer() const {
  return [surface = *this](const ref::Exact& degrees, int digits) -> ref::LineAnswer {
    const ref::LineResponse below = surface.along(surface.half_space_, degrees, digits);
    if (!surface.body_)
      return {below.compliance.value, below.coupling.value,         below.coupling_across.value,
              below.in_line.value,    below.shear_compliance.value, below.shear_compliance_across.value};
    const ref::LineResponse above = surface.along(*surface.body_, degrees, digits);
    return {joined(below.compliance.value, above.compliance.value, 1),
            joined(below.coupling.value, above.coupling.value, -1),
            joined(below.coupling_across.value, above.coupling_across.value, -1),
            below.in_line.value,
            joined(below.shear_compliance.value, above.shear_compliance.value, -1),
            joined(below.shear_compliance_across.value, above.shear_compliance_across.value, -1)};
  };
}

ref::Enclosure RefSurface::compliance(double degrees) const {
  const ref::Enclosure below = along(half_space_, ref::Exact(degrees), digits_).compliance;
  if (!body_) return below;
  const ref::Enclosure above = along(*body_, ref::Exact(degrees), digits_).compliance;
  return ref::enclosure_of(ref::interval_of(below) + ref::interval_of(above), digits_);
}

ref::Enclosure RefSurface::coupling(double degrees) const {
  const ref::Enclosure below = along(half_space_, ref::Exact(degrees), digits_).coupling;
  if (!body_) return below;
  const ref::Enclosure above = along(*body_, ref::Exact(degrees), digits_).coupling;
  return ref::enclosure_of(ref::interval_of(below) - ref::interval_of(above), digits_);
}

ref::Estimate RefSurface::critical(const Surface& surface) const {
  const ref::SurfaceDirection motion = ref::SurfaceDirection::of_degrees(ref::Exact(direction_));
  if (!surface.is_alike) return ref::critical_speed(surface.solid, motion, digits_).speed;
  const auto of_wave = ref::surface_wave_speed(surface.solid, motion, motion, digits_);
  return of_wave ? *of_wave : ref::limiting_speed(surface.solid, motion, motion, digits_);
}

ref::Estimate RefSurface::critical_speed() const {
  ref::Estimate slowest = critical(half_space_);
  // A patch that does not move in the body is never critical there.
  if (body_ && body_->moves) {
    ref::Estimate of_body = critical(*body_);
    const bool proven = slowest.proven && of_body.proven;
    if (mpfr_less_p(of_body.value.get(), slowest.value.get()) != 0) slowest = std::move(of_body);
    slowest.proven = proven;
  }
  return slowest;
}

}  // namespace nipref::verify
