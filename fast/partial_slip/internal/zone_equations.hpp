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
/// with given load or length and given traction or creep, for zones in a given order. They are linear in p, q, L1 and
/// the creep. Newton's method solves them with the zones' lengths. The conditions of stick and slip are not checked.
class ZoneEquations {
  using Index = Eigen::Index;

 public:
  ZoneEquations(const PartialSlipTask& task, const Zones& zones, double nats);

  /// Solves from the zones or from nearly right unknowns; false if Newton's method finds no zones in this order.
  bool solve();
  bool solve_from(const Eigen::VectorXd& unknowns);

  [[nodiscard]] const PartialSlipTask& task() const { return task_; }
  [[nodiscard]] const Zones& zones() const { return zones_; }
  [[nodiscard]] const ZoneMesh& mesh() const { return mesh_; }
  /// The unknowns of the mesh, L1 and the creep.
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
  [[nodiscard]] Misfits misfits() const;
  /// Rounding errors: of the zones' ends, as distances from the leading end, of the creep and of L1.
  struct Rounding {
    Eigen::VectorXd ends;
    double creep, leading_length;
  };
  /// They are |E J^-1| times the sizes of the equations' terms, among them load and traction, times rounding_of_term.
  /// J, the derivatives with respect to all unknowns and the logarithms of the zones' lengths, is that of Newton's last
  /// steps. E has the derivatives of the ends, of the creep and of L1 with respect to all these.
  [[nodiscard]] Rounding rounding() const;
  /// Three standard deviations of the 96 roundings of a term, each with a variance of up to 2^-106/3: 8 in a weight, 12
  /// in a traction, 15 in a kernel, 1 in their product, 49 for the exponentials of s, whose errors count about
  /// sevenfold in differences of next nodes, and 11 for the sum of terms.
  static constexpr double rounding_of_term = 17 * 0x1p-53;
  [[nodiscard]] Eigen::ArrayXd places(const auto& points) const {
    return Eigen::ArrayXd::NullaryExpr(static_cast<Index>(points.size()), [&](Index i) {
      return mesh_.place(points[static_cast<std::size_t>(i)]);
    });
  }

 private:
  /// Cauchy's kernels -1/(pi alpha) from the nodes, columns, to the midpoints, rows; and the rests of the kernels.
  struct Kernels {
    Eigen::MatrixXd cauchy;
    SlopeKernels rest;
  };
  void set_kernels();
  using Rows = SlopeKernels::Rows;
  /// The derivatives of the misfits with respect to the logarithms of the zones' lengths. add_of_cauchy adds those of
  /// the sums of Cauchy's kernels over given forces at the nodes.
  [[nodiscard]] Rows by_lengths() const;
  void add_of_cauchy(const Eigen::MatrixXd& cauchy, const Eigen::VectorXd& forces,
                     Eigen::MatrixXd& by_lengths) const;
  /// The residual of the equations. jacobian() has its derivatives with respect to all unknowns and these logarithms.
  [[nodiscard]] Eigen::VectorXd residual() const;
  [[nodiscard]] Index equations() const;  ///< number of equations
  [[nodiscard]] bool is_square() const;
  /// A number for each equation in order: at matched midpoints, of load or length, of creep or traction.
  [[nodiscard]] Eigen::VectorXd of_equations(const Misfits& at_midpoints, double of_load,
                                             double of_creep) const;
  [[nodiscard]] Eigen::MatrixXd jacobian() const;
  [[nodiscard]] Eigen::VectorXd weights() const;  ///< of the nodes
  /// The matrix of a number for each point, row, and each zone, column.
  [[nodiscard]] Eigen::MatrixXd of_points(const auto& points, const auto& number) const {
    return Eigen::MatrixXd::NullaryExpr(
        static_cast<Index>(points.size()), static_cast<Index>(zones_.size()),
        [&](Index i, Index zone) { return number(points[static_cast<std::size_t>(i)], zone); });
  }
  /// The length of each zone up to the points: the derivatives of their e with respect to the logarithm of its length.
  [[nodiscard]] Eigen::MatrixXd extents(const auto& points) const;
  /// The points in a zone: the number of the first one, and their count.
  struct Range {
    Index first, count;
  };
  [[nodiscard]] Range range_of(Index zone, const auto& points) const {
    const auto number = [this](const auto& point) { return static_cast<Index>(mesh_.zone(point)); };
    const auto range = std::ranges::equal_range(points, zone, {}, number);
    return {range.begin() - points.begin(), std::ssize(range)};
  }
  bool iterate();
  /// Whether Newton's method finds a solution; `derivatives` becomes the factorised J of its last steps.
  bool converges(Elimination& derivatives);
  void step(const Eigen::VectorXd& change, double part);

  PartialSlipTask task_;
  Zones zones_;
  ZoneMesh mesh_;
  std::vector<Index> normal_, along_;  ///< the midpoints at which the equations of u' and of v' hold
  Eigen::SparseMatrix<double> shear_here_, pressure_here_;  ///< of unit unknowns at these midpoints
  Kernels kernels_;                                         ///< of the present zones
  Eigen::VectorXd unknowns_;
  Eigen::MatrixXd by_equations_;  ///< rows of J^-1 as columns: for the length of each zone, the creep and L1
};

}  // namespace nipref::fast
