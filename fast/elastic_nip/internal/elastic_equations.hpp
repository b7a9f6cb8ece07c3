#pragma once
#include <nipref/data/problem/friction.hpp>
#include <nipref/fast/nip/internal/solved_nip.hpp>

namespace nipref::fast {

/// The contact of an elastic sheet: the surface follows u = D + 2 A e - e^2, and with full friction v = creep y. Unknowns
/// are D, the displacement at the end, and with full friction the creep. At an end with full friction the sign terms of
/// the coupling make g = pressure + i shear a power e^(1/2 - i epsilon), epsilon = atanh(theta2/N)/pi = ln(3 - 4 poisson)/
/// (2 pi). (thesis 2.2, 2.5, 5.3, 5.5; continuous form)
class ElasticEquations : public NipEquations {
 public:
  ElasticEquations(data::Friction friction, double poisson);

  static constexpr int edge_displacement = 0, creep = 1;  ///< numbers of the unknowns
  [[nodiscard]] bool grips() const { return grips_; }
  [[nodiscard]] double beta() const { return beta_; }  ///< theta2/N

  [[nodiscard]] Resolution resolution(double nats) const override;
  [[nodiscard]] Solution solve(double half_length, const std::vector<Panel>& panels, double tolerance,
                               CountedKernels& kernels) const override;
  [[nodiscard]] std::vector<AccuracyTarget> accuracy_targets(const Solution& solution) const override;
  [[nodiscard]] double half_length_guess(double load) const override;

  /// Normal displacement, tangential displacement and the nonlocal part of the strain along the surface.
  [[nodiscard]] Tractions::Kernel normal(CountedKernels& kernels) const;
  [[nodiscard]] Tractions::Kernel tangential(CountedKernels& kernels) const;
  [[nodiscard]] Tractions::Kernel strain() const;

 private:
  [[nodiscard]] Tractions::Kernel both(CountedKernels& kernels) const;
  [[nodiscard]] Tractions::SplitKernel matching(CountedKernels& kernels) const;

  bool grips_;
  double beta_;
  double decay_;
};

}  // namespace nipref::fast
