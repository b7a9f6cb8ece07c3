#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <nipref/fast/number/estimate.hpp>
#include <nipref/verify/audit/internal/drawn_scene.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/random.hpp>

namespace nipref::verify {

/// The same contact put in another way.
struct Variant {
  std::string name;
  DrawnScene scene;
  /// What one of its numbers says about the same number of the contact itself.
  std::function<fast::Estimate(const data::SceneResult& what, const fast::Estimate& number)> back;
};

/// Whatever of these the scene allows; `solved` is its solution.
/// - Units: lengths, moduli and times multiplied by small odd numbers, where all products are exact.
/// - Given back: the load (force) that was found for the length (span) is given, or the other way round. What
///   its error does to the answer is in the estimate, with exponents of the load's growth from 1 to 5.
/// - Elastic limit: a rolling sheet that is elastic is a nip that does not roll.
/// - Mirror: elastic nips at -Y; half-spaces with direction and angles negated.
/// - Turned: over a surface without directions of its own the motion's direction does not matter.
/// - Isotropic limit: an isotropic half-space as a transversely isotropic one, where its moduli are exact.
std::vector<Variant> variants_of(const DrawnScene& drawn, const SceneSolution<fast::Estimate>& solved,
                                 Random& random);

}  // namespace nipref::verify
