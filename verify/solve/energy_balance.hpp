#pragma once
#include <optional>
#include <string>
#include <vector>

#include <nipref/data/scene/scene.hpp>
#include <nipref/fast/number/estimate.hpp>
#include <nipref/verify/solve/solve.hpp>

namespace nipref::verify {

/// What drives a rolling nip against what its sheet loses, both in a unit of length rolled: force per unit width.
struct EnergyBalance {
  std::string title;
  fast::Estimate work;  ///< W mu_R, the rolling resistance
  fast::Estimate loss;  ///< by the frequencies that the pressure holds: internal/loss_integral.hpp
  std::vector<BeyondTheory> warnings;
  double seconds = 0;  ///< wall clock, for all of it

  [[nodiscard]] double difference() const;
  /// The sum of both errors.
  [[nodiscard]] double allowed() const { return work.error + loss.error; }
  [[nodiscard]] bool meets() const;
};

/// Of the converged contact of a rolling nip, solved in double or, where `digits` are given, by the reference.
/// What the scene wants does not matter. BadInput, naming the scene's key, for every other scene and for what the
/// solver refuses, faces that meet among it.
[[nodiscard]] EnergyBalance energy_balance(const data::Scene& scene, std::optional<int> digits = {});

}  // namespace nipref::verify
