#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include <nipref/fast/number/internal/linear_system.hpp>
#include <nipref/fast/partial_slip/internal/slope_kernels.hpp>
#include <nipref/fast/partial_slip/internal/zone_mesh.hpp>

namespace nipref::fast {

/// The equations
///     int U(e-s) p ds - int V(e-s) q ds + beta q(e) = 2 (L1 - e)        in the contact,
///     int V(e-s) p ds + int S(e-s) q ds - beta p(e) = creep             where it sticks,
///     q = sign mu p                                                     where it slips,
/// with two of load, length, traction and creep, for zones in a given order: linear in p, q, L1 and the creep, solved
/// with the zones' lengths by Newton's method. Whether it sticks and slips where it should is not looked at.
class ZoneEquations {
  using Index = Eigen::Index;

 public:
  ZoneEquations(const PartialSlipTask& task, const Zones& zones, double nats);

  /// From these zones, and from unknowns that are nearly right; false where Newton's method finds no zones of such an order.
  bool solve();
  bool solve_from(const Eigen::VectorXd& unknowns);

  [[nodiscard]] const PartialSlipTask& task() const { return task_; }
  [[nodiscard]] const Zones& zones() const { return zones_; }
  [[nodiscard]] const ZoneMesh& mesh() const { return mesh_; }
  /// Those of the mesh, L1 and the creep.
  [[nodiscard]] const Eigen::VectorXd& unknowns() const { return unknowns_; }
  [[nodiscard]] double leading_length() const { return unknowns_(mesh_.unknowns()); }
  [[nodiscard]] double creep() const { return unknowns_(mesh_.unknowns() + 1); }
  [[nodiscard]] double length() const { return length_of(zones_); }
  /// Tractions at the nodes times their weights.
  struct Forces {
    Eigen::ArrayXd normal, tangential;
  };
  [[nodiscard]] Forces forces() const;
  /// At the midpoints: u' - 2 (L1 - e), and v' - creep.
  struct Misfits {
    Eigen::ArrayXd normal, along;
  };
  [[nodiscard]] Misfits misfits() const { return misfits(kernels()); }
  /// How far rounding moves the logarithms of the zones' lengths: |J^-1|, J the derivatives of the equations by all unknowns and
  /// these, times the sizes of the equations' terms, times 2^-53 for each operation that makes a term: four for a weight, two
  /// for a traction, five for a kernel, and their product. J is the one of Newton's last steps.
  [[nodiscard]] Eigen::VectorXd rounding_of_lengths() const;
  [[nodiscard]] Eigen::ArrayXd places(const auto& points) const {
    return Eigen::ArrayXd::NullaryExpr(static_cast<Index>(points.size()), [&](Index i) {
      return mesh_.place(points[static_cast<std::size_t>(i)]);
    });
  }

 private:
  /// Cauchy's kernels -1/(pi alpha) from the nodes, columns, to the midpoints, and the rests of the kernels.
  struct Kernels {
    Eigen::MatrixXd cauchy;
    SlopeKernels rest;
  };
  [[nodiscard]] Kernels kernels() const;
  [[nodiscard]] Misfits misfits(const Kernels& kernels) const;
  using Rows = SlopeKernels::Rows;
  /// The derivatives of the misfits by the logarithms of the zones' lengths; to them are added those of the Cauchy kernels' sums
  /// over given forces at the nodes.
  [[nodiscard]] Rows by_lengths(const Kernels& kernels) const;
  void add_of_cauchy(const Eigen::MatrixXd& cauchy, const Eigen::VectorXd& forces,
                     Eigen::MatrixXd& by_lengths) const;
  /// What remains of the equations, and its derivatives by all unknowns and the logarithms of the zones' lengths.
  [[nodiscard]] Eigen::VectorXd residual(const Kernels& kernels) const;
  [[nodiscard]] Index equations() const;  ///< how many
  [[nodiscard]] bool is_square() const;
  /// Numbers of all equations in their order: of those at midpoints that are matched, of load or length, of creep or traction.
  [[nodiscard]] Eigen::VectorXd of_equations(const Misfits& at_midpoints, double of_load,
                                             double of_creep) const;
  [[nodiscard]] Eigen::MatrixXd jacobian(const Kernels& kernels) const;
  [[nodiscard]] Eigen::VectorXd weights() const;  ///< of the nodes
  /// A number for each point, row, and each zone, column.
  [[nodiscard]] Eigen::MatrixXd of_points(const auto& points, const auto& number) const {
    return Eigen::MatrixXd::NullaryExpr(
        static_cast<Index>(points.size()), static_cast<Index>(zones_.size()),
        [&](Index i, Index zone) { return number(points[static_cast<std::size_t>(i)], zone); });
  }
  /// How far each zone goes to the points' e: the derivatives of e by the logarithm of its length.
  [[nodiscard]] Eigen::MatrixXd extents(const auto& points) const;
  /// The first of the points, and how many, that lie in a zone.
  struct Range {
    Index first, count;
  };
  [[nodiscard]] Range range_of(Index zone, const auto& points) const {
    const auto number = [this](const auto& point) { return static_cast<Index>(mesh_.zone(point)); };
    const auto range = std::ranges::equal_range(points, zone, {}, number);
    return {range.begin() - points.begin(), std::ssize(range)};
  }
  bool iterate();
  /// Whether Newton's method finds a solution; `derivatives` becomes the one of its last steps.
  bool converges(Elimination& derivatives);
  void step(const Eigen::VectorXd& change, double part);

  PartialSlipTask task_;
  Zones zones_;
  ZoneMesh mesh_;
  std::vector<Index> normal_, along_;  ///< the midpoints at which the equations of u' and of v' hold
  Eigen::SparseMatrix<double> shear_here_, pressure_here_;  ///< of unit unknowns at them
  Eigen::VectorXd unknowns_;
  Eigen::MatrixXd lengths_by_equations_;  ///< rows of J^-1 as columns, a column for each zone
};

}  // namespace nipref::fast
