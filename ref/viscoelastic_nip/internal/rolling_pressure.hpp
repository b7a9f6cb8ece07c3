#pragma once
#include <memory>
#include <vector>

#include <nipref/ref/number/float.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/number/internal/unit_rule.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_kernel.hpp>

namespace nipref::ref {

/// A part of the contact, left <= d <= left + width, d the distance from the leading end: the pressure there
/// is sum c_k T_k(2x - 1), x = (d - left)/width, times sqrt x and sqrt(1 - x) where an end of the contact is.
struct RollingPanel {
  Float left, width;
  bool root_left, root_right;

  [[nodiscard]] bool has_root() const { return root_left || root_right; }
  /// Values of the basis, as many as there are in `values`.
  void basis(const Float& from_left, const Float& from_right, std::vector<Float>& values) const;
};

/// How a contact is cut: `terms` coefficients on each panel.
struct RollingLayout {
  int terms;
  std::vector<RollingPanel> panels;  ///< downstream

  /// Panels that begin `growth` times as far from their end as the one before, from `first` wide to `longest`
  /// half-thicknesses; one for all if `whole`.
  RollingLayout(const Float& half_length, double first, double growth, double longest, bool whole, int terms);
  [[nodiscard]] std::vector<Float> matching_points() const;
  [[nodiscard]] int unknowns() const { return static_cast<int>(panels.size()) * terms + 2; }
};

/// The contact of a steadily rolling viscoelastic sheet, of given half length A (half-thicknesses),
/// dimensionless: pressure times 2 R N_0/b, displacements times 2 R/b^2. The pressure is collocated, not with
/// its memory but with RollingKernel, which has it already:
///
///     int_0^{2A} K(d - d') p(d') dd' = edge_displacement + d (2A - d) + 2 offset d,   0 <= d <= 2A,
///
/// pressures that vanish at both ends, d counted from the leading one.
class RollingPressure {
 public:
  RollingPressure(const Float& half_length, RollingLayout layout, RollingKernel& kernel);
  RollingPressure(const RollingPressure&) = delete;
  RollingPressure& operator=(const RollingPressure&) = delete;
  ~RollingPressure();

  [[nodiscard]] const Float& half_length() const { return half_length_; }
  [[nodiscard]] const Float& edge_displacement() const { return edge_displacement_; }  ///< at the leading end
  /// Of the middle of the contact from the line through the rollers' centres, towards the leading side.
  [[nodiscard]] const Float& offset() const { return offset_; }
  [[nodiscard]] const Float& load() const { return load_; }
  /// Of the pressure about the middle of the contact, positive if more of it is on the leading side.
  [[nodiscard]] const Float& moment() const { return moment_; }
  [[nodiscard]] Float pressure(const Float& d) const;  ///< 0 outside the contact
  /// The same between the ends, by the distances from the leading one and from the other.
  [[nodiscard]] Float pressure(const Float& d, const Float& left) const;
  [[nodiscard]] Float peak_pressure() const;
  [[nodiscard]] Float place_of_peak() const;  ///< d, to all digits: the zero of the pressure's slope
  /// Displacement at any d by the normal kernel, inside the contact by the roller.
  [[nodiscard]] Float normal_displacement(const Float& d, RollingKernel& kernel) const;
  /// int kernel(d - d') p(d') dd' at any d, by quadrature; a kernel of the same memory and digits as the one that the
  /// pressure was solved with.
  [[nodiscard]] Float response(const Float& d, RollingKernel& kernel) const;
  [[nodiscard]] int unknowns() const { return layout_.unknowns(); }

 private:
  struct Rules;
  class Integrals;
  [[nodiscard]] Float nearly_place_of_peak() const;
  [[nodiscard]] Float in_panel(std::size_t panel, const Float& from_left, const Float& from_right) const;
  void integrate(const UnitRule& rule);

  Float half_length_;
  RollingLayout layout_;
  Float edge_displacement_, offset_, load_, moment_;
  std::vector<std::vector<Float>> coefficients_;
  std::unique_ptr<const Rules> rules_;
  std::vector<Integrals> pressures_;  ///< of each panel's pressure
};

}  // namespace nipref::ref
