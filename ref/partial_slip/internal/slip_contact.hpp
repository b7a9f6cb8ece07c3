#pragma once
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <nipref/ref/nip/internal/sheet_kernels.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/partial_slip/internal/zone_grid.hpp>

namespace nipref::ref {

class SlipField;

/// A contact that is sought, dimensionless. e >= 0 is the distance from the leading end, q the shear on the sheet along +e.
struct SlipProblem {
  Float beta, friction;
  std::optional<Float> length;  ///< L; where it is not given
  Float load = 0;               ///< int p de
  std::optional<Float> creep;   ///< xi; where it is not given
  Float shear = 0;              ///< int q de
  Float unit = 1;  ///< of lengths, creeps and tractions as unknowns: about the length of the contact
};

/// A part of the contact in which q = sign friction p, or the surface sticks if sign = 0.
struct SlipZone {
  int sign;
  Float length;
};

/// Of what there are two: p and q.
inline constexpr std::size_t pressure_part = 0, shear_part = 1;

/// Of panels, in half-thicknesses: longer ones need more nodes, shorter ones are more.
inline constexpr double longest_panel = 3;

/// Both sides of the equations of a point, without what the remainders of the tractions there add.
struct PointSums {
  ComplexFloat normal, tangential;
};

/// The equations of a contact whose zones are known but for their lengths: ref/partial_slip/README.md, The equations. All zones
/// are divided into panels. Unknowns are, for each panel, the remainders of p and, where it sticks, of q at the nodes, what is
/// left of them when their linear interpolation between the panel's ends is taken off; p at the joints of panels, and q where
/// both sides stick; L1; and xi where it is not given.
class SlipContact {
 public:
  /// Which unknown a value is, times a factor; none where it is 0.
  struct Source {
    GridIndex column = -1;
    Float factor = 1;
  };
  struct Panel {
    GridIndex zone;
    int sign;
    Float left, length;
    GridIndex first_place;  ///< of its Chebyshev points among those of all panels
    Row<PanelPoint> chebyshev;
    Matrix moments;  ///< what makes integrals against Lagrange's polynomials of the nodes' values
    std::array<Row<Source>, 2>
        sources;  ///< of p and q: remainders at the nodes, values at the left and right end
    std::array<Row<Float>, 2> values;
  };

  /// zones are not empty, and next to one that slips is one of another sign.
  SlipContact(const SlipProblem& problem, std::shared_ptr<const ZoneGrid> grid, SheetKernels& kernels,
              Row<SlipZone> zones);

  [[nodiscard]] GridIndex unknowns() const { return columns_; }
  /// Those that make the tractions, L1 and creep of another contact.
  [[nodiscard]] Vector unknowns_of(const SlipField& other) const;
  /// One for each unknown and zone.
  [[nodiscard]] GridIndex equations() const;
  void set(const Vector& unknowns);
  [[nodiscard]] Vector residual() const;
  /// The derivatives of the balanced residual by the unknowns over their sizes.
  [[nodiscard]] DenseMatrix<double> slopes() const;
  /// Differences of the residual's neighbouring rows in place of those next to a panel's end, over the root of the distance, so
  /// that rounding to double does not hide what the remainders there add, which are as small.
  [[nodiscard]] Vector balanced(const Vector& residual) const;
  /// How large unknowns are next to a panel's end: as the root of the distance.
  [[nodiscard]] const Row<Float>& sizes() const { return sizes_; }

  // In half-thicknesses, tractions as they are.
  [[nodiscard]] const SlipProblem& problem() const { return problem_; }
  [[nodiscard]] const ZoneGrid& grid() const { return *grid_; }
  [[nodiscard]] SheetKernels& kernels() const { return kernels_; }
  [[nodiscard]] const Row<SlipZone>& zones() const { return zones_; }
  [[nodiscard]] const Row<Panel>& panels() const { return panels_; }
  /// Chebyshev points of all panels, and the integrals of p and q against their Lagrange polynomials.
  [[nodiscard]] const Row<Float>& places() const { return places_; }
  [[nodiscard]] const std::array<Vector, 2>& moments() const { return moments_; }
  [[nodiscard]] const Float& leading() const { return leading_; }
  [[nodiscard]] const Float& creep() const { return creep_; }
  [[nodiscard]] PointSums sums(GridIndex panel, const PanelPoint& at) const;
  /// The same at e < 0 or e > L.
  [[nodiscard]] PointSums sums_outside(const Float& e) const;
  /// arctan(beta sign friction)/pi.
  [[nodiscard]] Float shift(int sign) const;
  /// int p de or int q de.
  [[nodiscard]] Float integral(std::size_t of) const;
  [[nodiscard]] Float length() const;

 private:
  void divide();
  void count_unknowns();
  void make_smooth_kernels();
  [[nodiscard]] ComplexFloat collocation(const Panel& panel, GridIndex row) const;
  /// Cauchy's integrals over pi of all values, with the panel and place of the point.
  void cauchy(GridIndex panel, const PanelPoint& at, Row<ComplexFloat>& sums) const;
  void add_outer(GridIndex source, const ComplexFloat& way, bool is_ahead, Row<ComplexFloat>& sums) const;
  [[nodiscard]] Row<ComplexFloat> terms(GridIndex panel, const PanelPoint& at) const;
  [[nodiscard]] Eigen::MatrixXcd panel_slopes(GridIndex panel) const;
  [[nodiscard]] Eigen::RowVectorXcd joint_slopes(GridIndex panel) const;
  /// Whether an equation's part goes on from the panel before.
  [[nodiscard]] bool is_tied(GridIndex panel, GridIndex part) const;
  [[nodiscard]] Float row_scale(const Panel& panel, GridIndex row) const;
  [[nodiscard]] Float gap(GridIndex from, GridIndex to) const;
  [[nodiscard]] PointSums add_up(const Row<ComplexFloat>& cauchy) const;
  /// Slip, then stick.
  [[nodiscard]] bool enters_stick(GridIndex panel) const;

  SlipProblem problem_;
  std::shared_ptr<const ZoneGrid> grid_;
  SheetKernels& kernels_;
  Row<SlipZone> zones_;
  Row<Panel> panels_;
  Row<Float> weights_, minus_weights_;  ///< of the rule over pi
  Row<Float> sizes_;
  Row<Float> places_;              ///< Chebyshev points of all panels, as e
  std::array<Matrix, 3> smooth_;   ///< U + 1/(pi alpha), V and S + 1/(pi alpha) between them
  std::array<Vector, 2> moments_;  ///< of p and q
  Vector normal_, tangential_;     ///< what these make of the tractions there
  Float leading_ = 0, creep_ = 0;
  GridIndex columns_ = 0, leading_column_ = 0, creep_column_ = -1;
};

/// Chebyshev's extreme points: sin^2 of equal angles, with both ends, so that interpolations of neighbouring panels meet.
Row<PanelPoint> extreme_points(int count);
/// Lagrange's polynomials of these.
Row<ComplexFloat> lagrange(const Row<PanelPoint>& points, const PanelPoint& x);

}  // namespace nipref::ref
