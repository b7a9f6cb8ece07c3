#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include <nipref/data/problem/half_space.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/half_space/stiffness.hpp>

namespace nipref::ref {

/// The joint response of the body and the half-space of a problem on the line at an angle from the motion, for exactly
/// the problem's doubles. It counts its own evaluations.
class JointResponse {
 public:
  /// The relative accuracy of what it computes is 10^-digits.
  JointResponse(const data::HalfSpaceProblem& problem, int digits);

  /// BadInput "speed" unless the speed is subcritical on every line. Where the slowest line is not known in advance, all
  /// lines are scanned, which takes seconds.
  void check_subcritical() const;

  // To as many digits as they are asked for: of both bodies, and of the half-space alone, with its decay if the depth is not 0.
  [[nodiscard]] SurfaceAnswer answer() const;
  [[nodiscard]] SurfaceAnswer of_half_space(const Exact& depth = Exact(0.0)) const;
  /// The error bounds are proven.
  [[nodiscard]] Enclosure compliance(double degrees) const {
    return joint(degrees, &LineResponse::compliance, 1);
  }
  [[nodiscard]] Enclosure coupling(double degrees) const {
    return joint(degrees, &LineResponse::coupling, -1);
  }
  /// The smallest critical speed of this motion, unit of speed. Its error is proven where all lines are alike;
  /// otherwise it is estimated, and the computation takes seconds.
  [[nodiscard]] Estimate critical_speed() const;
  [[nodiscard]] bool all_lines_are_alike() const { return half_space_.is_alike; }
  [[nodiscard]] std::uint64_t evaluations() const { return *evaluations_; }

 private:
  /// A solid and the speed at which the contact moves over it.
  struct Surface {
    ExactStiffness solid;
    double speed;
    bool is_alike;      ///< the response is the same in all directions
    bool moves = true;  ///< whether the contact moves over it, possibly at speed 0
  };
  struct SurfaceOf;
  [[nodiscard]] LineResponse along(const Surface& surface, const Exact& degrees, int digits,
                                   bool with_decay = false) const;
  /// Of the half-space, plus `sign` times that of the body.
  [[nodiscard]] Enclosure joint(double degrees, Enclosure LineResponse::*of, long sign) const;
  [[nodiscard]] Estimate critical(const Surface& surface) const;

  int digits_;
  double direction_;
  Surface half_space_;
  std::optional<Surface> body_;  ///< nothing if the body is rigid
  std::shared_ptr<std::uint64_t> evaluations_ = std::make_shared<std::uint64_t>(0);
};

}  // namespace nipref::ref
