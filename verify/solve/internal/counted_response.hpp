#pragma once
#include <cstdint>
#include <memory>

#include <nipref/data/scene/scene.hpp>
#include <nipref/fast/half_space/response.hpp>
#include <nipref/fast/number/estimate.hpp>

namespace nipref::verify {

/// The joint response of a scene's body and half-space on the line at an angle from the motion; it counts its own
/// evaluations.
class CountedResponse {
 public:
  /// BadInput naming the scene's speed unless it is subcritical on every line.
  CountedResponse(const data::HalfSpaceProblem& problem, const data::SceneOrigin& origin);

  [[nodiscard]] fast::LineResponse operator()(fast::Direction from_motion) const;
  // Compliances, couplings and the smallest critical speed of this motion, unit of speed; the errors are of rounding.
  [[nodiscard]] fast::Estimate compliance(double degrees) const;
  [[nodiscard]] fast::Estimate coupling(double degrees) const;
  [[nodiscard]] fast::Estimate critical_speed() const;
  [[nodiscard]] std::uint64_t evaluations() const { return *evaluations_; }

 private:
  const data::HalfSpaceProblem* problem_;
  fast::SurfaceResponse half_space_, body_;
  std::shared_ptr<std::uint64_t> evaluations_ = std::make_shared<std::uint64_t>(0);
};

}  // namespace nipref::verify
