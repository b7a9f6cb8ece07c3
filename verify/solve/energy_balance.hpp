#pragma once
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nipref/data/problem/nip.hpp>
#include <nipref/data/scene/scene.hpp>
#include <nipref/fast/number/estimate.hpp>
#include <nipref/verify/solve/solve.hpp>

namespace nipref::verify {

/// The work that drives a rolling nip and the energy that its sheet loses, both for a unit of length rolled: force per
/// unit width.
struct EnergyBalance {
  std::string title;
  fast::Estimate work;  ///< W mu_R, the rolling resistance
  fast::Estimate loss;  ///< from the Fourier transform of the pressure, see loss_integral
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

/// The energy that a steadily rolling sheet loses in a unit of length rolled, as the sum of its losses at all
/// frequencies,
///
///     (1/pi) int_0^inf S(q b) |p^(q)|^2 (-Im N(i q speed)) dq,   S(s) = 2 sinh^2 s/(sinh 2s + 2s),
///
/// where b is the half-thickness and p^ the Fourier transform of the pressure between the contact's ends. Unit: force
/// per unit width, which is energy per length and width. The loss equals W mu_R. It is computed without the kernels,
/// the memory and the linear systems by which the contact was solved, so that it is an independent check.
///
/// The pressure is expanded in Legendre polynomials on panels whose length doubles with the distance from each end;
/// their Fourier transforms are spherical Bessel functions. A smooth partition divides the frequencies into octaves. In
/// each octave the trapezoidal rule takes steps that are small against the octave. They either resolve the oscillation
/// e^{2 i q A} of |p^|^2, which comes from the two ends of the contact, or are an odd number of its half periods, which
/// cancel.
///
/// The error estimate is the sum of twice the change by a finer rule and more polynomials, of the largest change that
/// the pressure's own error can cause, and of rounding.
fast::Estimate loss_integral(const data::ViscoelasticNip& nip, double first, double last,
                             const std::function<fast::Estimate(double y)>& pressure);

}  // namespace nipref::verify
