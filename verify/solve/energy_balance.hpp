#pragma once
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <nipref/data/scene/scene.hpp>
#include <nipref/fast/number/estimate.hpp>
#include <nipref/verify/solve/solve.hpp>

namespace nipref::verify {

/// The work that drives a rolling nip and the energy that its sheet loses, both for a unit of length rolled: force per
/// unit width.
struct EnergyBalance {
  std::string title;
  fast::Estimate work;  ///< W mu_R, the rolling resistance
  fast::Estimate loss;  ///< from the Fourier transform of the pressure, see internal/loss_integral.hpp
  std::vector<BeyondTheory> warnings;
  double seconds = 0;  ///< wall clock, for all of it

  [[nodiscard]] double difference() const { return work.value - loss.value; }
  /// The sum of both errors.
  [[nodiscard]] double allowed() const { return work.error + loss.error; }
  [[nodiscard]] bool meets() const { return std::fabs(difference()) <= allowed(); }
};

/// The energy balance of the converged contact of a rolling nip, solved in double or, if `digits` are given, by the
/// reference. The list of wanted results is not used. BadInput, naming the scene's key, for every other scene and if
/// the solver refuses the scene, for example because the rollers' faces would meet.
[[nodiscard]] EnergyBalance energy_balance(const data::Scene& scene, std::optional<int> digits = {});

}  // namespace nipref::verify
