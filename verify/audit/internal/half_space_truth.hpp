#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <nipref/data/problem/half_space.hpp>

namespace nipref::verify {

/// What the reference says: more digits than a double's, and how far it may be off.
struct Truth {
  long double value;
  double error;
};

/// Of the reference's decimal text, the rounding to a long double in the error.
Truth truth_of(const std::string& value, const std::string& error);

/// The reference about a body on a half-space, from the scene's doubles, taken exactly: what the lines answer,
/// when those of isotropic solids are critical, and how the spans of the papers' rule go with the angle. If it
/// may be `dear`, seconds, the critical speed of the others too and, where curvatures are no farther apart than
/// 1 to 10 and the speed is at most 0.7 of the critical one, axis ratio and approach of the exact ellipse.
class HalfSpaceTruth {
 public:
  HalfSpaceTruth(const data::HalfSpaceProblem& problem, bool dear);
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
