#pragma once
#include <memory>
#include <optional>

#include <nipref/ref/partial_slip/internal/smooth_sums.hpp>

namespace nipref::ref {

class SlipField;

/// The equations of a contact whose zones are known but for their lengths: ref/partial_slip/README.md, The equations. Unknowns
/// are, for each panel, the values of p and, where it sticks, of q at the nodes; p at the joints of panels, and q where both
/// sides stick; L1; and xi where it is not given.
class SlipContact {
 public:
  /// zones are not empty, and next to one that slips is one of another sign.
  SlipContact(std::shared_ptr<const ZoneGrid> grid, SheetKernels& kernels, const Row<SlipZone>& zones);

  /// Those that make the tractions, L1 and creep of another contact.
  [[nodiscard]] Vector unknowns_of(const SlipField& other) const;
  void set(const Vector& unknowns);
  /// How large unknowns are: next to a panel's end as the root of the distance.
  [[nodiscard]] const Row<Float>& sizes() const { return sizes_; }
  /// The left sides, whose right sides are 0; and what they change by with the unknowns over their sizes, each entry precise in
  /// double.
  [[nodiscard]] Vector residual() const;
  [[nodiscard]] Eigen::MatrixXd slopes() const;

  // In half-thicknesses, tractions as they are.
  [[nodiscard]] const SlipProblem& problem() const { return grid_->problem(); }
  [[nodiscard]] const ZoneGrid& grid() const { return *grid_; }
  [[nodiscard]] const Row<SlipZone>& zones() const { return zones_; }
  [[nodiscard]] const ZonePanels& panels() const { return panels_; }
  [[nodiscard]] const SmoothSums& smooth() const { return smooth_; }
  [[nodiscard]] const Float& leading() const { return leading_; }
  [[nodiscard]] const Float& creep() const { return creep_; }
  /// The integrals of both equations, and what the linear interpolations add at the point; tangential ones only where they are
  /// wanted. In the contact the remainders there add the rest.
  [[nodiscard]] PointSums sums(const ContactPoint& point, bool with_tangential) const;
  [[nodiscard]] const OfBoth<Vector>& values() const { return values_; }
  /// int p de or int q de.
  [[nodiscard]] Float integral(std::size_t of) const { return weights_.cwiseProduct(values_[of]).sum(); }

 private:
  /// Which unknown a value is, times a factor; none where it is 0.
  struct Source {
    GridIndex column = -1;
    double factor = 1;
  };
  /// One of the points where equations are asked.
  struct PointIndex {
    GridIndex panel, point;
    bool operator==(const PointIndex&) const = default;
  };
  /// A row of the system is the real (0) or imaginary (1) part of the left side at a point, times a scale. Next to a panel's end
  /// it is the difference from the neighbouring point over the root of the distance, so that rounding to double does not hide
  /// what the values there add, which are as small.
  struct Equation {
    PointIndex at;
    std::optional<PointIndex> less;
    GridIndex part;
    Float scale;
  };
  /// The rows after these: a sum of factors times the values is to be `wanted`.
  struct Condition {
    OfBoth<Vector> factors;
    Float wanted;
  };

  void count_unknowns();
  void count_equations();
  void add_conditions();
  [[nodiscard]] bool sticks(GridIndex panel) const { return panels_[panel].sign == 0; }
  [[nodiscard]] ContactPoint point(const PointIndex& index) const;
  /// Complex where the contact sticks.
  [[nodiscard]] ComplexFloat left_side(const ContactPoint& point) const;
  /// What it is made of: Cauchy's integrals by all values, Lagrange's polynomials, and the linear ones of the panel's ends.
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
  mutable Row<ComplexFloat> cauchy_;  ///< of the last point, as to make it takes time
  Float leading_ = 0, creep_ = 0;
  GridIndex leading_column_ = 0, creep_column_ = -1;
};

}  // namespace nipref::ref
