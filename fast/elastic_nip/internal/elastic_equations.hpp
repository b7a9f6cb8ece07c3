#pragma once
#include <nipref/data/problem/nip.hpp>
#include <nipref/fast/nip/internal/nip_equations.hpp>

namespace nipref::fast {

/// The contact of an elastic sheet: the surface follows u = D + 2 A e - e^2, and with full friction v = creep y.
/// Unknowns are D, the displacement at the end, and with full friction the creep. At an end with full friction the sign
/// terms of the coupling make g = pressure + i shear a power e^(1/2 - i epsilon),
/// epsilon = atanh(theta2/N)/pi = ln(3 - 4 poisson)/(2 pi). (thesis 2.2, 2.5, 5.3, 5.5; continuous form)
class ElasticEquations : public NipEquations {
 public:
  ElasticEquations(data::Friction friction, double poisson);

  static constexpr int edge_displacement = 0, creep = 1;  ///< numbers of the unknowns
  [[nodiscard]] Resolution resolution(double nats) const override;
  [[nodiscard]] Solution solve(double half_length, const std::vector<Panel>& panels, double tolerance,
                               CountedKernels& kernels) const override;
  [[nodiscard]] std::vector<AccuracyTarget> accuracy_targets(const Solution& solution) const override;

  /// Less than 1 for a long sheet that sticks: a film, stiffer than one without friction.
  [[nodiscard]] double softening_over(double half_length) const override;

  [[nodiscard]] bool sticks() const override { return sticks_; }
  [[nodiscard]] Functional roller_displacement(const Solution& solution, double y) const override;
  [[nodiscard]] Functional end_displacement(const Solution& solution, bool trailing) const override;
  [[nodiscard]] Functional normal_displacement(const Solution& solution, const ContactPlace& place,
                                               CountedKernels& kernels) const override;
  [[nodiscard]] AlongSurface along_surface(const Solution& solution, const ContactPlace& place,
                                           CountedKernels& kernels) const override;
  [[nodiscard]] Functional creep_ratio(const Solution& solution, CountedKernels& kernels) const override;
  [[nodiscard]] std::optional<internal::Shares> shares() const override { return {{1 - beta_, beta_}}; }

 private:
  /// The kernel of v under the pressure and, with the other sign, of u under the shear.
  [[nodiscard]] Eigen::RowVectorXd coupling(CountedKernels::Alphas alpha, CountedKernels& kernels) const;
  /// The kernel, without friction, of the displacement along the surface and of the nonlocal part of its strain; and
  /// the kernel of the displacements that are matched.
  [[nodiscard]] Tractions::Kernel along_kernel(CountedKernels& kernels) const;
  [[nodiscard]] Tractions::SplitKernel matching(CountedKernels& kernels) const;

  /// The size of the contributions from both sides of a place, which cancel: the coupling is at most 0.2505 + beta/2, as
  /// I3 overshoots its limit pi/4 by 0.2 %.
  [[nodiscard]] double cancelling_sides(const Solution& solution) const;

  bool sticks_;
  double beta_;  ///< theta2/N
  double decay_;
};

}  // namespace nipref::fast
