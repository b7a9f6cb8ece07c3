#pragma once
#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include <nipref/fast/partial_slip/internal/zone_equations.hpp>

namespace nipref::fast {

/// A solution of ZoneEquations: its tractions, strains and displacements at any place, and numbers of the whole.
class ZoneContact {
 public:
  using Traction = ZoneMesh::Traction;

  /// The solution from these zones or from a solution near it; nothing if Newton's method finds no zones in this order.
  static std::optional<ZoneContact> solved(const PartialSlipTask& task, const Zones& zones, double nats);
  static std::optional<ZoneContact> solved(const PartialSlipTask& task, const ZoneContact& near, double nats);

  /// Whether the zones are those of another discretisation: they have the same order, and no length differs by more
  /// than half of it or than e^(-nats/2) of the longest zone beside. The discretised equations also have solutions in
  /// which a zone of stick between opposite slips shrinks with the mesh.
  [[nodiscard]] bool is_like(const ZoneContact& other) const;

  [[nodiscard]] const Zones& zones() const { return equations_->zones(); }
  [[nodiscard]] double length() const { return equations_->length(); }
  [[nodiscard]] double leading_length() const { return equations_->leading_length(); }  ///< L1
  [[nodiscard]] double creep() const { return equations_->creep(); }
  [[nodiscard]] double load() const { return forces_.normal.sum(); }
  [[nodiscard]] double tangential_load() const { return forces_.tangential.sum(); }
  /// D, the displacement that the rollers impose on the surface at the line through their centres.
  [[nodiscard]] double approach() const {
    return displacement(0).normal + leading_length() * leading_length();
  }
  [[nodiscard]] std::size_t nodes() const { return mesh().nodes().size(); }  ///< number of nodes
  [[nodiscard]] ZoneEquations::Rounding rounding() const { return equations_->rounding(); }
  /// int p (L1 - e) de
  [[nodiscard]] double moment() const;
  /// -int q (v' - creep) de
  [[nodiscard]] double dissipation() const;

  /// 0 outside the contact.
  [[nodiscard]] Traction traction(double e) const;
  [[nodiscard]] Traction traction_at(const ZoneMesh::Point& point) const;
  /// The sums of the sizes of the terms whose sums are the tractions at e.
  [[nodiscard]] Traction sizes_at(double e) const;
  /// The sign of the zone that contains e, a place in the contact, and the place where this zone begins.
  [[nodiscard]] int sign(double e) const;
  [[nodiscard]] double start_of_zone(double e) const;
  /// The strain v' of the surface, in the contact and outside.
  [[nodiscard]] double strain(double e) const;
  struct Displacement {
    double normal, along;
    void operator+=(const Displacement& other) {
      normal += other.normal;
      along += other.along;
    }
  };
  /// u, and v along e up to a constant. In the contact u is the rollers' parabola. Where the sheet sticks, the strain
  /// of v is the creep; elsewhere v needs the tractions between the nodes.
  [[nodiscard]] Displacement displacement(double e) const;
  /// The place that corresponds to e of `other`, which has the same zones, nearly as long. The map of e is piecewise
  /// linear between the ends and the boundaries where stick turns into slip, at which tractions are like roots.
  [[nodiscard]] double corresponding_place(const ZoneContact& other, double e) const;

  /// Tractions and slip v' - creep at the midpoints, in their order.
  struct Sample {
    ZoneMesh::Point point;
    int zone, sign;
    double e, weight, pressure, shear, slip;
    double ratio;  ///< |q/p|; where the sheet sticks, the largest from here to the next sample
  };
  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }

  struct Peak {
    double size, e;
    ZoneMesh::Point point;
  };
  /// The local maxima of a traction's magnitude; some may be cusps at boundaries of zones.
  [[nodiscard]] std::vector<Peak> peaks(double Traction::*part) const;
  /// e of a peak, as the zero of the slope beside it if there is one.
  [[nodiscard]] double place_of(const Peak& peak, double Traction::*part) const;
  /// The derivative of a traction's magnitude with respect to the panel's s, at 0 < e < length.
  [[nodiscard]] double slope(double e, double Traction::*part) const {
    return slope(mesh().point_at(e), part);
  }
  [[nodiscard]] double nats() const { return mesh().nats(); }
  [[nodiscard]] double step() const { return mesh().step(); }

 private:
  explicit ZoneContact(std::shared_ptr<const ZoneEquations> solved);
  [[nodiscard]] const ZoneMesh& mesh() const { return equations_->mesh(); }
  [[nodiscard]] double slope(const ZoneMesh::Point& point, double Traction::*part) const;
  /// The sums, over the terms that make up the tractions at a point, of a function of a term.
  [[nodiscard]] Traction sum_of_terms(const ZoneMesh::Point& point, const auto& of_term) const;
  /// The largest |q/p| between a sample that sticks and the next one, 0 for others.
  [[nodiscard]] double ratio_after(const ZoneMesh::Point& point) const;
  [[nodiscard]] Displacement displacement_under(double distance, const Traction& load) const;
  /// The displacement under the nodes of all panels but one.
  [[nodiscard]] Displacement displacement_by_nodes(double e, int but_of_panel) const;
  /// The strain under a load, without the local term.
  [[nodiscard]] static double strain_under(double distance, const Traction& load);
  /// Calls add(distance, weight times traction) for the nodes of all panels but one.
  template <class Add>
  void for_nodes_beyond(int panel, double e, const Add& add) const;

  std::shared_ptr<const ZoneEquations> equations_;  ///< which copies of a contact share
  ZoneEquations::Forces forces_;
  std::vector<Sample> samples_;
};

}  // namespace nipref::fast
