#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include <nipref/data/scene/scene.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/half_space/stiffness.hpp>
#include <nipref/verify/solve/solve.hpp>

namespace nipref::verify {

/// What body and half-space of a scene answer together by the reference, by the angle from the motion, and how
/// often it was asked: of the scene's doubles, taken exactly.
class RefSurface {
 public:
  explicit RefSurface(const data::HalfSpaceProblem& problem);

  /// BadInput naming the scene's speed unless it is subcritical on every line: for a line next to which that is
  /// not known to be the worst, a scan of seconds.
  void check_subcritical(const data::SceneOrigin& origin) const;

  /// Good to 10^-digits.
  [[nodiscard]] ref::SurfaceAnswer answer() const;
  /// With proven bounds.
  [[nodiscard]] ref::Enclosure compliance(double degrees, int digits) const;
  [[nodiscard]] ref::Enclosure coupling(double degrees, int digits) const;
  /// The smallest critical speed of this motion, unit of speed: proven where all lines are alike, otherwise
  /// estimated, in seconds.
  [[nodiscard]] ref::Estimate critical_speed(int digits) const;
  [[nodiscard]] bool all_lines_are_alike() const { return half_space_.is_alike; }
  [[nodiscard]] std::uint64_t evaluations() const { return *evaluations_; }

 private:
  /// A solid that is touched, and how fast the contact moves over it.
  struct Surface {
    ref::ExactStiffness solid;
    double speed;
    bool is_alike;      ///< in all directions
    bool moves = true;  ///< the contact, over it, be its speed 0
  };
  struct SurfaceOf;
  [[nodiscard]] ref::LineResponse along(const Surface& surface, const ref::Exact& degrees, int digits) const;
  [[nodiscard]] ref::Estimate critical(const Surface& surface, int digits) const;

  bool rolls_;
  double direction_;
  Surface half_space_;
  std::optional<Surface> body_;  ///< none: rigid
  std::shared_ptr<std::uint64_t> evaluations_ = std::make_shared<std::uint64_t>(0);
};

}  // namespace nipref::verify
