#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include <nipref/data/scene/scene.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/half_space/stiffness.hpp>
#include <nipref/verify/solve/solve.hpp>

namespace nipref::verify {

/// The reference's joint response of a scene's body and half-space on the line at an angle from the motion, for exactly
/// the scene's doubles; it counts its own evaluations.
class RefSurface {
 public:
  /// The relative accuracy of what it computes is 10^-digits.
  RefSurface(const data::HalfSpaceProblem& problem, int digits);

  /// BadInput naming the scene's speed unless it is subcritical on every line. Where the slowest line is not known in
  /// advance, all lines are scanned, which takes seconds.
  void check_subcritical(const data::SceneOrigin& origin) const;

  [[nodiscard]] ref::SurfaceAnswer answer() const;  ///< to as many digits as it is asked for
  /// The error bounds are proven.
  [[nodiscard]] ref::Enclosure compliance(double degrees) const;
  [[nodiscard]] ref::Enclosure coupling(double degrees) const;
  /// The smallest critical speed of this motion, unit of speed. Its error is proven where all lines are alike;
  /// otherwise it is estimated, and the computation takes seconds.
  [[nodiscard]] ref::Estimate critical_speed() const;
  [[nodiscard]] bool all_lines_are_alike() const { return half_space_.is_alike; }
  [[nodiscard]] std::uint64_t evaluations() const { return *evaluations_; }

 private:
  /// A solid and the speed at which the contact moves over it.
  struct Surface {
    ref::ExactStiffness solid;
    double speed;
    bool is_alike;      ///< the response is the same in all directions
    bool moves = true;  ///< whether the contact moves over it, possibly at speed 0
  };
  struct SurfaceOf;
  [[nodiscard]] ref::LineResponse along(const Surface& surface, const ref::Exact& degrees, int digits) const;
  [[nodiscard]] ref::Estimate critical(const Surface& surface) const;

  int digits_;
  bool rolls_;
  double direction_;
  Surface half_space_;
  std::optional<Surface> body_;  ///< nothing if the body is rigid
  std::shared_ptr<std::uint64_t> evaluations_ = std::make_shared<std::uint64_t>(0);
};

}  // namespace nipref::verify
