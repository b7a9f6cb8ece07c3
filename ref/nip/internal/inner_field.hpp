#pragma once
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include <nipref/ref/number/internal/float.hpp>

namespace nipref::ref {

/// Pressure, and shear along the sheet.
struct FaceTraction {
  Float pressure, shear;
};

/// sigma_x across the sheet, sigma_y along it, tau_xy, tension positive.
struct FloatStresses {
  Float across, along, shear;
};

/// How finely a field is computed: stresses to about 10^-digits of `scale`. Fields that differ in `fineness`, 1 or more,
/// share no node.
struct FieldFineness {
  int digits;
  double fineness;
  Float scale;
};

/// The stresses inside the sheet between the faces x = +-1 under the same tractions on both, between two ends, in
/// half-thicknesses and the tractions' unit. (thesis 3.19, 4.3, 4.14 as integrals over the contact)
///
/// Each face's part is that of a half-plane (Flamant),
///
///     sigma = -(2/pi) int (d p + u q)/r^4 (d^2, u^2, -+ d u) d alpha',    u = alpha - alpha', r^2 = u^2 + d^2
///
/// d the distance from the face, by the double exponential rule in w, u = d sinh w, both sides of the place together:
/// nearer than the nearer end its integrand is analytic whatever d, and at d = 0 it is the principal value.
///
/// What is left are the symbols of the sheet without those of both half-planes, which fall like z^2 e^(-2z), times the
/// tractions' Fourier transforms, by Gauss's rule in z. Neither needs the kernels of sheet/field.hpp.
class InnerField {
 public:
  /// Continuous and 0 at the ends, analytic between; distances from the left end and from the right one, > 0.
  using Tractions = std::function<FaceTraction(const Float& from_left, const Float& from_right)>;

  InnerField(const Float& middle, const Float& half_length, Tractions tractions, FieldFineness fineness);

  /// -1 <= depth <= 1.
  [[nodiscard]] FloatStresses at(const Float& alpha, const Float& depth) const;

 private:
  /// Of the double exponential rule on 0 .. 1, one level's nodes beside those of the levels before.
  struct UnitNode {
    Float from_left, from_right, slope;
  };
  /// A place on one of the faces' lines.
  struct Place;
  /// |alpha - alpha'| from `start` on; sources on both sides of the place or on one of them.
  struct Segment;
  struct Charge {
    Float place;  ///< from the middle
    FaceTraction weighted;
  };
  /// One node of Gauss's rule: z, its weight over pi, 2 sinh z/D and 2 cosh z/D with D = sinh 2z + 2z, e^-z and the
  /// tractions' integrals with cos and sin.
  struct Wave {
    Float z, weight, sinh_part, cosh_part, fall;
    FaceTraction cosine, sine;
  };

  [[nodiscard]] const std::vector<UnitNode>& level(int number) const;
  void add_segment(const Segment& segment, const Place& place, FloatStresses& sum) const;
  [[nodiscard]] FloatStresses half_plane(const Float& alpha, const Float& depth, int face) const;
  void add_beside(const Float& alpha, const Float& depth, FloatStresses& sum) const;
  [[nodiscard]] const std::vector<Charge>& charges() const;
  [[nodiscard]] const std::vector<Wave>& waves(const Float& alpha) const;

  Float middle_, half_length_;
  Tractions tractions_;
  FieldFineness fineness_;
  mutable std::vector<std::unique_ptr<std::vector<UnitNode>>> levels_;
  mutable std::vector<Charge> charges_;
  mutable std::map<int, std::vector<Wave>> waves_;  ///< by how far off they are good, see waves()
};

}  // namespace nipref::ref
