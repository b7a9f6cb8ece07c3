#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <nipref/fast/nip/inner_stresses.hpp>
#include <nipref/fast/nip/work.hpp>
#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

class NipEquations;
struct NipShape;
struct GivenContact;

/// The continuous contact of a nip: tractions bounded at both ends. (thesis 2.1-2.6 as integral equations, not as line
/// loads)
///
/// It is made by converged_for_length or converged_for_load for an elastic nip without or with full friction
/// (elastic_nip/converged.hpp), or for a viscoelastic one in steady frictionless rolling
/// (viscoelastic_nip/converged.hpp). Up to L/B = 4, or 12 if rounding then allows the accuracy, the tractions are one
/// expansion over the whole contact. Otherwise they are expanded on panels whose widths double from both ends
/// (nip/internal/tractions.hpp). The number of terms follows from the accuracy. Every result is computed when it is
/// asked for. Its error estimate covers truncation and rounding (nip/internal/solution.hpp), with a given load also
/// their effect on the length. If rounding does not allow the accuracy (very thin sheets with full friction), the
/// estimate says so.
///
/// Y is the distance along the sheet from the line through the rollers' centres, positive on the leading (entry) side,
/// any finite value, unit of length; otherwise BadInput. The contact of an elastic sheet is symmetric about Y = 0.
class ConvergedNip {
 public:
  ConvergedNip(ConvergedNip&&) noexcept;
  ~ConvergedNip();

  [[nodiscard]] Estimate contact_length() const;   ///< L = L1 + L2, unit of length
  [[nodiscard]] Estimate leading_length() const;   ///< L1, contact on the entry side, unit of length
  [[nodiscard]] Estimate trailing_length() const;  ///< L2, on the exit side; may be negative, unit of length
  [[nodiscard]] Estimate load() const;             ///< W, force per unit width
  [[nodiscard]] Estimate indentation() const;  ///< d0, approach of roller and middle plane, unit of length
  [[nodiscard]] Estimate leading_displacement() const;   ///< d1 = d0 - L1^2/(2R), unit of length
  [[nodiscard]] Estimate trailing_displacement() const;  ///< d2 = d0 - L2^2/(2R), unit of length
  [[nodiscard]] Estimate pressure(double y) const;       ///< unit of stress, 0 outside the contact
  /// Along Y on the sheet, unit of stress; 0 outside the contact and without friction.
  [[nodiscard]] Estimate shear(double y) const;
  [[nodiscard]] Estimate peak_pressure() const;  ///< unit of stress
  [[nodiscard]] Estimate peak_shear() const;     ///< largest magnitude, unit of stress
  /// Y of the largest pressure, unit of length. In a symmetric contact it is the middle: in all contacts tried the
  /// pressure falls from there outwards. Its error is that of the pressure's slope over the curvature. If another
  /// maximum, inside or at an end, may be larger, the error covers its place, too.
  [[nodiscard]] Estimate peak_pressure_position() const;
  /// Y > 0 of the largest magnitude of the shear, unit of length, with an error like that of peak_pressure_position().
  /// With full friction, otherwise BadInput.
  [[nodiscard]] Estimate peak_shear_position() const;
  /// Places Y >= 0, rising, at which the shear changes its sign, unit of length; the first is the middle. With full
  /// friction, otherwise BadInput. Each is sure: the shear is larger than its error on both sides. Towards an end they
  /// become denser in a geometric progression; those within 1e-6 of L/2 from the end are left out.
  [[nodiscard]] std::vector<Estimate> shear_zeros() const;
  /// int p Y dY/(W R): the coefficient of rolling resistance, dimensionless; 0 in a symmetric contact. (thesis 7.15)
  [[nodiscard]] Estimate rolling_resistance() const;
  /// (v(L1) - v(-L2))/L: mean stretch of the surface in the contact; with full friction v'(Y), which is constant.
  /// Dimensionless. (thesis 5.5, 5.16, 7.17)
  [[nodiscard]] Estimate creep_ratio() const;
  /// u, towards the middle plane, and v, relative to Y = 0; unit of length.
  [[nodiscard]] Estimate normal_displacement(double y) const;
  [[nodiscard]] Estimate tangential_displacement(double y) const;
  /// v'(Y), the strain of the surface along the sheet, in the contact and outside, dimensionless. In an elastic sheet
  /// without friction it is (N/pi) int I3' p - theta2 p. With full friction it is the creep ratio in the contact, and
  /// outside N/2 times the stress along the face. (thesis 2.5)
  [[nodiscard]] Estimate surface_strain(double y) const;
  /// surface_strain(y) - creep_ratio(), dimensionless. Its error is less than the sum of the two errors, because a
  /// common error counts once. 0 in a contact with full friction.
  [[nodiscard]] Estimate slip(double y) const;
  /// The stresses inside the sheet, see InnerStresses.
  [[nodiscard]] std::vector<InnerStresses> inner_stresses(std::span<const InnerPoint> points) const;
  [[nodiscard]] GreatestShear greatest_shear() const;
  /// normal_displacement and tangential_displacement at any depth of an elastic sheet; BadInput in rolling.
  [[nodiscard]] std::vector<InnerDisplacements> inner_displacements(std::span<const InnerPoint> points) const;
  /// Solves with more terms, on which all later results rest. Returns false if more terms do not help.
  bool refine();
  [[nodiscard]] Work work() const;  ///< spent so far

 private:
  struct Implementation;
  explicit ConvergedNip(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> nip_;
  friend ConvergedNip converged_nip(const NipShape& shape, double compliance,
                                    std::shared_ptr<const NipEquations> equations, const GivenContact& given,
                                    double accuracy);
};

}  // namespace nipref::fast
