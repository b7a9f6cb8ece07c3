#pragma once
#include <memory>
#include <optional>
#include <string_view>

#include <nipref/data/problem/half_space.hpp>

namespace nipref::verify {

/// What the reference says: more digits than a double's, and how far it may be off.
struct Truth {
  long double value;
  double error;
};

/// The reference about a body on a half-space, from the scene's doubles, taken exactly: what the lines answer,
/// when they are critical, and how the spans of the papers' rule go with the angle. Nothing of what takes
/// integrals over all lines: forces and ellipses.
class HalfSpaceTruth {
 public:
  explicit HalfSpaceTruth(const data::HalfSpaceProblem& problem);
  ~HalfSpaceTruth();
  HalfSpaceTruth(const HalfSpaceTruth&) = delete;
  HalfSpaceTruth& operator=(const HalfSpaceTruth&) = delete;

  /// A result by its name, of a profile at so many degrees from the motion; nothing where the reference does
  /// not have it.
  [[nodiscard]] std::optional<Truth> of(std::string_view name, double degrees) const;

 private:
  struct Implementation;
  std::unique_ptr<const Implementation> implementation_;
};

}  // namespace nipref::verify
