#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include <nipref/fast/partial_slip/internal/slope_kernels.hpp>
#include <nipref/fast/partial_slip/internal/zone_mesh.hpp>

namespace nipref::fast {

/// The solution of
///     int U(e-s) p ds - int V(e-s) q ds + beta q(e) = 2 (L1 - e)        in the contact,
///     int V(e-s) p ds + int S(e-s) q ds - beta p(e) = creep             where it sticks,
///     q = sign mu p                                                     where it slips,
/// with two of load, length, traction and creep, for zones in a given order: linear in p, q, L1 and the creep, solved
/// with the zones' lengths by Newton's method. Whether it sticks and slips where it should is not looked at.
class ZoneContact {
 public:
  /// Nothing where Newton's method finds no zones of such an order; `last` gets the last zones that it tried.
  static std::optional<ZoneContact> solved(const PartialSlipTask& task, const std::vector<Zone>& zones,
                                           double nats, std::vector<Zone>* last = nullptr);

  [[nodiscard]] const std::vector<Zone>& zones() const { return zones_; }
  [[nodiscard]] double length() const;
  [[nodiscard]] double leading_length() const { return unknowns_(mesh_.unknowns()); }  ///< L1
  [[nodiscard]] double creep() const { return unknowns_(mesh_.unknowns() + 1); }
  [[nodiscard]] double load() const;
  [[nodiscard]] double tangential_load() const;
  /// D, by which the rollers press in the surface at the line through their centres.
  [[nodiscard]] double approach() const {
    return displacement(0).normal + leading_length() * leading_length();
  }
  [[nodiscard]] Eigen::Index unknowns() const { return unknowns_.size(); }
  /// int p (L1 - e) de
  [[nodiscard]] double moment() const;
  /// -int q (v' - creep) de
  [[nodiscard]] double dissipation() const;

  struct Traction {
    double pressure, shear;
    friend Traction operator*(double factor, const Traction& traction) {
      return {factor * traction.pressure, factor * traction.shear};
    }
  };
  /// 0 outside.
  [[nodiscard]] Traction traction(double e) const;
  /// The strain v' of the surface, in the contact and outside.
  [[nodiscard]] double strain(double e) const;
  struct Displacement {
    double normal, along;
  };
  /// u and v along e, against what is the same for all e.
  [[nodiscard]] Displacement displacement(double e) const;

  /// Tractions and slip v' - creep at the midpoints, in their order.
  struct Sample {
    ZoneMesh::Point point;
    int zone, sign;
    double e, weight, pressure, shear, slip;
  };
  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }

 private:
  ZoneContact(const PartialSlipTask& task, const std::vector<Zone>& zones, double nats);
  struct Strains {
    Eigen::MatrixXd normal, along;  ///< u' and v' at the midpoints, rows, of each unknown
  };
  [[nodiscard]] Strains strains() const;
  struct Equations {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd right;
  };
  [[nodiscard]] Equations equations() const;
  /// The derivatives of the equations' left sides less their right ones by the logarithms of the zones' lengths.
  [[nodiscard]] Eigen::MatrixXd by_lengths() const;
  [[nodiscard]] Displacement displacement_under(double distance, const Traction& load) const;
  /// But for the local term.
  [[nodiscard]] static double strain_under(double distance, const Traction& load);
  /// Calls add(distance, weight times traction) for the nodes of all panels but one.
  template <class Add>
  void for_nodes_beyond(int panel, double e, const Add& add) const;
  [[nodiscard]] Traction traction_at(const ZoneMesh::Point& point) const;
  void add_integrals(Equations& equations, Eigen::Index row) const;
  bool iterate();
  void take_samples();
  /// Then there is no traction, by symmetry, which is an equation less.
  [[nodiscard]] bool sticks_everywhere() const;

  PartialSlipTask task_;
  std::vector<Zone> zones_;
  ZoneMesh mesh_;
  SlopeKernels kernels_;
  Eigen::VectorXd unknowns_;  ///< those of the mesh, L1, creep
  std::vector<Sample> samples_;
};

}  // namespace nipref::fast
