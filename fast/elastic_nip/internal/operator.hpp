#pragma once
#include <optional>
#include <vector>

#include <nipref/data/problem/friction.hpp>
#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/number/internal/double_exponential.hpp>

namespace nipref::fast {

/// One quadrature node as seen from a point of the surface: what a traction there contributes to the
/// dimensionless displacements of that point (see HalfContact), its mirror image on the other half included.
struct Influence {
  double e;  ///< distance of the node from the end of the contact
  double weight;
  double normal_by_pressure;      ///< [I1(y - s) + I1(y + s)]/pi
  double normal_by_shear;         ///< [beta I2 - I3] at y - s minus at y + s, over pi
  double tangential_by_pressure;  ///< [I3 - beta I2] at y - s plus at y + s, over pi
  double tangential_by_shear;     ///< [I6(y - s) - I6(y + s)]/pi
};

/// The influences that are wanted: only their kernels are evaluated, the others stay 0.
struct Couplings {
  bool normal_by_pressure;
  bool normal_by_shear;
  bool tangential_by_pressure;
  bool tangential_by_shear;
};

/// Quadrature of the displacements of single points over a half contact.
class ElasticNipOperator {
 public:
  /// beta = theta2/N = (1 - 2 poisson)/(2 (1 - poisson)), dimensionless.
  ElasticNipOperator(double half_length, double beta, double tolerance, CountedKernels& kernels)
      : half_length_(half_length),
        beta_(beta),
        tolerance_(tolerance),
        rule_(double_exponential_rule(tolerance)),
        kernels_(kernels) {}

  [[nodiscard]] double beta() const { return beta_; }
  /// Nodes for the piece `left` <= e <= `right` as seen from the point at distance `point` <= A from the end
  /// (negative outside the contact). `degree`: of the traction on the piece if that is a polynomial.
  [[nodiscard]] std::vector<Influence> influences(double point, double left, double right, Couplings wanted,
                                                  std::optional<int> degree = {}) const;

 private:
  [[nodiscard]] std::vector<double> cuts(double point, double left, double right) const;
  [[nodiscard]] bool is_far(double point, double left, double right) const;
  void append_nodes(const std::vector<UnitNode>& rule, double point, double left, double right,
                    std::vector<Influence>& nodes, std::vector<double>& near, std::vector<double>& far) const;

  double half_length_;
  double beta_;
  double tolerance_;
  std::vector<UnitNode> rule_;
  CountedKernels& kernels_;
};

}  // namespace nipref::fast
