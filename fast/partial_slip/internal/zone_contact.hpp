#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include <nipref/fast/partial_slip/internal/zone_equations.hpp>

namespace nipref::fast {

/// A solution of ZoneEquations: its tractions, strains and displacements at any place, and numbers of the whole.
class ZoneContact {
 public:
  using Traction = ZoneMesh::Traction;

  /// Nothing where Newton's method finds no zones of such an order.
  static std::optional<ZoneContact> solved(const PartialSlipTask& task, const Zones& zones, double nats);
  /// The same from another solution, to which it is near.
  static std::optional<ZoneContact> solved(const PartialSlipTask& task, const ZoneContact& near, double nats);

  /// Whether the zones are those of another discretisation: in the same order, and none is longer by half but for what the coarser
  /// leaves. The discretised equations have solutions too in which a zone that sticks between opposite slips shrinks as the
  /// mesh does.
  [[nodiscard]] bool is_like(const ZoneContact& other) const;

  [[nodiscard]] const Zones& zones() const { return equations_.zones(); }
  [[nodiscard]] double length() const { return equations_.length(); }
  [[nodiscard]] double leading_length() const { return equations_.leading_length(); }  ///< L1
  [[nodiscard]] double creep() const { return equations_.creep(); }
  [[nodiscard]] double load() const { return forces_.normal.sum(); }
  [[nodiscard]] double tangential_load() const { return forces_.tangential.sum(); }
  /// D, by which the rollers press in the surface at the line through their centres.
  [[nodiscard]] double approach() const {
    return displacement(0).normal + leading_length() * leading_length();
  }
  [[nodiscard]] Eigen::Index unknowns() const { return equations_.unknowns().size(); }
  [[nodiscard]] Eigen::VectorXd rounding_of_lengths() const { return equations_.rounding_of_lengths(); }
  /// int p (L1 - e) de
  [[nodiscard]] double moment() const;
  /// -int q (v' - creep) de
  [[nodiscard]] double dissipation() const;

  /// 0 outside.
  [[nodiscard]] Traction traction(double e) const;
  [[nodiscard]] Traction traction_at(const ZoneMesh::Point& point) const;
  /// Of the zone that e in the contact lies in, and where it begins.
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
  /// u and v along e, against what is the same for all e. In the contact u is the rollers' parabola, and where the sheet
  /// sticks the strain is the creep; elsewhere tractions between the nodes enter.
  [[nodiscard]] Displacement displacement(double e) const;
  /// The place that corresponds to e of `other`, which has the same zones, nearly as long: the ends of both correspond, and the
  /// boundaries where they begin to slip, at which tractions are like roots, and between these e is linear.
  [[nodiscard]] double corresponding_place(const ZoneContact& other, double e) const;

  /// Tractions and slip v' - creep at the midpoints, in their order.
  struct Sample {
    ZoneMesh::Point point;
    int zone, sign;
    double e, weight, pressure, shear, slip;
    double ratio;  ///< |q/p|, where it sticks the largest from here to the next sample
  };
  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }

  struct Peak {
    double size, e;
    ZoneMesh::Point point;
  };
  /// The local maxima of a traction's size, of which some may be cusps at boundaries of zones.
  [[nodiscard]] std::vector<Peak> peaks(double Traction::*part) const;
  /// Its e as the zero of the slope beside it, if there is one.
  [[nodiscard]] double place_of(const Peak& peak, double Traction::*part) const;
  /// The derivative of a traction's size by the panel's s at 0 < e < length.
  [[nodiscard]] double slope(double e, double Traction::*part) const {
    return slope(mesh().point_at(e), part);
  }
  [[nodiscard]] double nats() const { return mesh().nats(); }
  [[nodiscard]] double step() const { return mesh().step(); }

 private:
  explicit ZoneContact(ZoneEquations solved);
  [[nodiscard]] const ZoneMesh& mesh() const { return equations_.mesh(); }
  [[nodiscard]] double slope(const ZoneMesh::Point& point, double Traction::*part) const;
  /// The largest |q/p| between a sample that sticks and the next one, 0 for others.
  [[nodiscard]] double ratio_after(const ZoneMesh::Point& point) const;
  [[nodiscard]] Displacement displacement_under(double distance, const Traction& load) const;
  /// The nodes of all panels but one.
  [[nodiscard]] Displacement displacement_by_nodes(double e, int but_of_panel) const;
  /// But for the local term.
  [[nodiscard]] static double strain_under(double distance, const Traction& load);
  /// Calls add(distance, weight times traction) for the nodes of all panels but one.
  template <class Add>
  void for_nodes_beyond(int panel, double e, const Add& add) const;

  ZoneEquations equations_;
  ZoneEquations::Forces forces_;
  std::vector<Sample> samples_;
};

}  // namespace nipref::fast
