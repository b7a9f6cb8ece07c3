#pragma once
#include <cstdint>
#include <memory>

#include <nipref/data/problem/half_space.hpp>
#include <nipref/fast/half_space/response.hpp>
#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

/// The joint response of the body and the half-space of a problem, on the line at an angle from the motion. The class
/// counts the evaluations.
class JointResponse {
 public:
  /// BadInput "speed" unless the speed is subcritical on every line.
  explicit JointResponse(const data::HalfSpaceProblem& problem);

  [[nodiscard]] LineResponse operator()(Direction from_motion) const;
  /// The response of the half-space alone: on the surface only if the depth is 0, otherwise inside.
  [[nodiscard]] PressureWaves of_half_space(double depth = 0) const;
  // Compliances, couplings and the smallest critical speed of this motion, unit of speed. The errors are rounding errors.
  [[nodiscard]] Estimate compliance(double degrees) const;
  [[nodiscard]] Estimate coupling(double degrees) const;
  [[nodiscard]] Estimate critical_speed() const;
  [[nodiscard]] std::uint64_t evaluations() const { return *evaluations_; }

 private:
  SurfaceResponse half_space_, body_;
  PressureWaves inside_;
  double critical_speed_;
  std::shared_ptr<std::uint64_t> evaluations_ = std::make_shared<std::uint64_t>(0);
};

}  // namespace nipref::fast
