#pragma once
#include <memory>
#include <optional>

#include <nipref/ref/partial_slip/internal/smooth_sums.hpp>

namespace nipref::ref {

class SlipField;

/// The equations of a contact for given zones: ref/partial_slip/README.md, The equations. The unknowns are p at the
/// nodes of all panels, and q in those that stick; p at the joints of panels, and q where both panels stick; L1; and xi
/// if it is not given. There are more equations than unknowns, one for each zone's length.
class SlipContact {
 public:
  /// There is at least one zone, and the neighbours of a zone that slips have other signs.
  SlipContact(std::shared_ptr<const ZoneGrid> grid, SheetKernels& kernels, const Row<SlipZone>& zones);

  /// The unknowns for the tractions, L1 and creep of another contact.
  [[nodiscard]] Vector unknowns_of(const SlipField& other) const;
  void set(const Vector& unknowns);
  /// The scales of the unknowns. Near a panel's end they are like the root of the distance.
  [[nodiscard]] const Row<Float>& sizes() const { return sizes_; }
  /// The left sides of the equations, which should be 0; and their slopes by unknowns over sizes, precise to double.
  [[nodiscard]] Vector residual() const;
  [[nodiscard]] Eigen::MatrixXd slopes() const;

  // Lengths are in half-thicknesses, tractions not divided by their sizes.
  [[nodiscard]] const SlipProblem& problem() const { return grid_->problem(); }
  [[nodiscard]] const ZoneGrid& grid() const { return *grid_; }
  [[nodiscard]] const Row<SlipZone>& zones() const { return zones_; }
  [[nodiscard]] const ZonePanels& panels() const { return panels_; }
  [[nodiscard]] const SmoothSums& smooth() const { return smooth_; }
  [[nodiscard]] const Float& leading() const { return leading_; }
  [[nodiscard]] const Float& creep() const { return creep_; }
  /// The integrals of both equations at a point, with the local terms of the linear interpolations; the tangential ones
  /// only if wanted. The local terms of the remainders are not included.
  [[nodiscard]] PointSums sums(const ContactPoint& point, bool with_tangential) const;
  [[nodiscard]] const OfBoth<Vector>& values() const { return values_; }
  /// int p de or int q de.
  [[nodiscard]] Float integral(std::size_t of) const { return weights_.cwiseProduct(values_[of]).sum(); }

 private:
  /// A value as an unknown, given by its column, times a factor. Without a column the value is 0.
  struct Source {
    GridIndex column = -1;
    double factor = 1;
  };
  /// One of the collocation points.
  struct PointIndex {
    GridIndex panel, point;
    bool operator==(const PointIndex&) const = default;
  };
  /// A row of the system is the real (0) or imaginary (1) part of the left side at a point, times a scale. Near a
  /// panel's end it is the difference from the neighbouring point over the root of the distance. So rounding to double
  /// does not hide the effect of the values there, which are as small as the root.
  struct Equation {
    PointIndex at;
    std::optional<PointIndex> less;
    GridIndex part;
    Float scale;
  };
  /// A row after the equations: the sum of factors times the values must be `wanted`.
  struct Condition {
    OfBoth<Vector> factors;
    Float wanted;
  };

  void count_unknowns();
  void count_equations();
  void add_conditions();
  [[nodiscard]] bool sticks(GridIndex panel) const { return panels_[panel].sign == 0; }
  [[nodiscard]] ContactPoint point(const PointIndex& index) const;
  /// The left side at a point, complex if the contact sticks there.
  [[nodiscard]] ComplexFloat left_side(const ContactPoint& point) const;
  /// The factors in left_side(): of all values in Cauchy's integrals, then Lagrange's polynomials, and the linear ones.
  [[nodiscard]] Row<ComplexFloat> point_row(const PointIndex& index) const;

  std::shared_ptr<const ZoneGrid> grid_;
  Row<SlipZone> zones_;
  ZonePanels panels_;
  SmoothSums smooth_;
  OfBoth<Row<Source>> sources_;
  Vector weights_;  ///< integrals of unit values
  Row<Equation> equations_;
  Row<Condition> conditions_;
  Row<Float> sizes_;
  OfBoth<Vector> values_;
  mutable Row<ComplexFloat> cauchy_;  ///< kept, as its allocation takes time
  Float leading_ = 0, creep_ = 0;
  GridIndex leading_column_ = 0, creep_column_ = -1;
};

}  // namespace nipref::ref
