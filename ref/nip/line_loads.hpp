#pragma once
#include <memory>
#include <vector>

#include <nipref/ref/nip/line_load_field.hpp>
#include <nipref/ref/number/enclosure.hpp>

namespace nipref::ref {

struct SolvedLineLoads;

/// Creep ratios, dimensionless.
struct CreepRange {
  Enclosure lower, upper, chosen;
};

/// A nip whose tractions are gathered in line loads, the thesis's discrete contact, in multiprecision. The equations
/// are those of fast/nip/line_loads.hpp, so that the difference is what that path loses to its kernels and to rounding.
/// (thesis 2.2) It is made by line_loads_for_length or line_loads_for_load for an elastic nip
/// (elastic_nip/line_loads.hpp) or a viscoelastic one (viscoelastic_nip/line_loads.hpp). Every number has a proven
/// bound, see Enclosure. Bounds of loads are relative to the largest load, bounds of sums to the size of the terms.
///
/// Y is the distance along the sheet from the line through the rollers' centres, positive on the leading side, unit of
/// length, taken exactly. BadInput if it is not finite, and for displacements at the place of a line load.
class LineLoadNip {
 public:
  /// `digits` of the results; `working_digits`: of the arithmetic.
  LineLoadNip(SolvedLineLoads solved, int digits, int working_digits);

  [[nodiscard]] Enclosure contact_length() const;         ///< L = L1 + L2, unit of length
  [[nodiscard]] Enclosure leading_length() const;         ///< L1
  [[nodiscard]] Enclosure trailing_length() const;        ///< L2
  [[nodiscard]] Enclosure indentation() const;            ///< d0, unit of length
  [[nodiscard]] Enclosure leading_displacement() const;   ///< d1 = d0 - L1^2/(2R)
  [[nodiscard]] Enclosure trailing_displacement() const;  ///< d2 = d0 - L2^2/(2R)
  [[nodiscard]] Enclosure load() const;                   ///< W, force per unit width
  /// The largest normal load, or the largest magnitude of a shear load, over the width of its element, unit of stress.
  /// The position is the centre of that element, in a symmetric nip on the side Y > 0. If the bounds do not tell which
  /// element it is, the position covers the centres of all that it may be.
  [[nodiscard]] Enclosure peak_pressure() const;
  [[nodiscard]] Enclosure peak_pressure_position() const;
  [[nodiscard]] Enclosure peak_shear() const;
  [[nodiscard]] Enclosure peak_shear_position() const;
  /// Moments about the line through the rollers' centres of the loads ahead of it and of those behind it. (thesis 7.13)
  [[nodiscard]] Enclosure leading_moment() const;
  [[nodiscard]] Enclosure trailing_moment() const;
  [[nodiscard]] Enclosure rolling_resistance() const;  ///< (thesis 7.15), dimensionless
  /// (v(L1) - v(-L2))/L, dimensionless; with full friction the given or chosen creep ratio. (thesis 5.5, 5.16, 7.17)
  [[nodiscard]] Enclosure creep_ratio() const;
  /// With full friction: the creep ratio that the thesis chooses for this length, and the lowest and highest around it
  /// that meet its conditions, see data::LineLoadFriction. BadInput "contact_length" if there is none or the bounds do
  /// not tell. (thesis, section 5.5, Figure 15)
  [[nodiscard]] CreepRange creep_range() const;
  /// The borders Y >= 0, rising, between elements whose shear loads have opposite signs; the first is the middle. There
  /// are none without friction. A border covers the elements beside it whose signs the bounds do not tell.
  [[nodiscard]] std::vector<Enclosure> shear_zeros() const;
  /// The normal or the shear load of the element around Y over its width, 0 outside the contact. A place within 1e-15
  /// L1 of a border belongs to the trailing element, in a symmetric nip to the outer one.
  [[nodiscard]] Enclosure pressure(double y) const;
  [[nodiscard]] Enclosure shear(double y) const;
  [[nodiscard]] Enclosure normal_displacement(double y) const;      ///< u, towards the middle plane
  [[nodiscard]] Enclosure tangential_displacement(double y) const;  ///< v, relative to Y = 0
  [[nodiscard]] std::vector<FaceLoad> face_loads() const;           ///< from the leading end on

  [[nodiscard]] int systems() const;       ///< number of systems that were solved
  [[nodiscard]] int unknowns() const;      ///< number of unknowns of a system
  [[nodiscard]] double condition() const;  ///< condition number of its matrix in the row-sum norm

 private:
  [[nodiscard]] Enclosure enclosed(const auto& function) const;

  std::shared_ptr<const SolvedLineLoads> solved_;
  int digits_, working_digits_;
};

}  // namespace nipref::ref
