#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include <nipref/data/problem/half_space.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/half_space/stiffness.hpp>

namespace nipref::ref {

/// The joint response of the body and the half-space of a problem along lines, which are given by their angles from the
/// motion. The doubles of the problem are taken as exact numbers. The evaluations are counted.
class JointResponse {
 public:
  /// Results have a relative accuracy of 10^-digits.
  JointResponse(const data::HalfSpaceProblem& problem, int digits);

  /// Throws BadInput "speed" unless the speed is subcritical on every line. If not all lines are alike, all lines are
  /// searched, which takes seconds.
  void check_subcritical() const;

  /// The joint response, to the digits that the caller of the answer asks for.
  [[nodiscard]] SurfaceAnswer answer() const;
  /// The same for the half-space alone, with the decay if the depth is not 0.
  [[nodiscard]] SurfaceAnswer of_half_space(const Exact& depth = Exact(0.0)) const;
  /// The joint compliance and coupling; the error bounds are proven.
  [[nodiscard]] Enclosure compliance(double degrees) const {
    return joint(degrees, &LineResponse::compliance, 1);
  }
  [[nodiscard]] Enclosure coupling(double degrees) const {
    return joint(degrees, &LineResponse::coupling, -1);
  }
  /// The smallest critical speed of this motion, unit of speed. If all lines are alike, its error is a proven bound.
  /// Otherwise it is an estimate, and the computation takes seconds.
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
  /// A component of the half-space's response plus `sign` times that of the body's.
  [[nodiscard]] Enclosure joint(double degrees, Enclosure LineResponse::*of, long sign) const;
  [[nodiscard]] Estimate critical(const Surface& surface) const;

  int digits_;
  double direction_;
  Surface half_space_;
  std::optional<Surface> body_;  ///< nothing if the body is rigid
  std::shared_ptr<std::uint64_t> evaluations_ = std::make_shared<std::uint64_t>(0);
};

}  // namespace nipref::ref
