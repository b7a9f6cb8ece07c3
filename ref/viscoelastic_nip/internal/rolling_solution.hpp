#pragma once
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <nipref/ref/nip/internal/nip_solution.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_sheet.hpp>
#include <nipref/ref/viscoelastic_nip/internal/trace.hpp>

namespace nipref::ref {

/// The contact of a steadily rolling viscoelastic sheet as that of an elastic one, of half length A (half-thicknesses),
/// dimensionless: pressure times 2 R N_0/b, displacements times 2 R/b^2; x is the distance behind the leading end. In the
/// contact u = edge_displacement + x (2A - x) + 2 offset x, so that by RollingSheet
///
///     K p = f = u + sum_j b_j (int_0^x e^(-s_j (x - t)) u(t) dt + n_j e^(-s_j x)),   0 <= x <= 2A,
///     n_j = int_0^inf e^(-s_j w) u(-w) dw = sum_i a_i/(s_j - r_i) int_0^inf e^(-r_i w) f(-w) dw,
///
/// where the last integral, of what the elastic sheet would do ahead of the contact, is one of the pressure. The even and
/// the odd part of the pressure are those of elastic contacts with other right-hand sides: one for u as far as it is
/// known, for edge_displacement, for the offset and for each n_j. Each is solved with a bounded pressure and a constant or
/// a line beside f. These two must vanish in the sum, and the n_j be those of its pressure, which gives the unknowns.
class RollingSolution {
 public:
  /// Integrals are good to about e^-nats.
  RollingSolution(std::shared_ptr<const RollingSheet> sheet, Tractions tractions, double nats,
                  SheetKernels& kernels);

  [[nodiscard]] const Float& half_length() const { return tractions_.half_length(); }
  [[nodiscard]] const Float& edge_displacement() const { return edge_displacement_; }
  /// Of the middle of the contact from the line through the rollers' centres, towards the leading side.
  [[nodiscard]] const Float& offset() const { return offset_; }
  [[nodiscard]] const Float& load() const { return load_; }
  /// Of the pressure about the middle of the contact, positive if more of it is on the leading side.
  [[nodiscard]] const Float& moment() const { return moment_; }
  /// d ln W/d ln A: dW/dA goes with the product of how the pressure grows at both ends, as the contact that rolls the other
  /// way has the same load and the ends exchanged.
  [[nodiscard]] Float growth() const;
  [[nodiscard]] std::vector<Float> signature() const;
  [[nodiscard]] int unknowns() const { return unknowns_; }

  [[nodiscard]] Float pressure(const Float& x) const;  ///< 0 outside the contact
  /// The same between the ends, by the distances from both.
  [[nodiscard]] Float pressure(const Float& from_leading, const Float& from_trailing) const;
  [[nodiscard]] Float normal(const Float& x, SheetKernels& kernels) const;
  /// Upstream, up to a constant; and its slope upstream.
  [[nodiscard]] Float tangential(const Float& x, SheetKernels& kernels) const;
  [[nodiscard]] Float strain(const Float& x, SheetKernels& kernels) const;

 private:
  [[nodiscard]] Vector direct_row(const Float& x) const;
  [[nodiscard]] Matrix memory_rows(SheetKernels& kernels) const;
  [[nodiscard]] std::array<Matrix, 2> bounded_parts(SheetKernels& kernels) const;
  [[nodiscard]] Matrix conditions(const std::array<Matrix, 2>& parts, SheetKernels& kernels) const;
  void solve(SheetKernels& kernels);

  [[nodiscard]] Float elastic(Influence kind, const Float& x, SheetKernels& kernels) const;
  [[nodiscard]] const Trace& pressure_trace() const;
  [[nodiscard]] const Trace& elastic_trace(Influence kind, SheetKernels& kernels) const;

  std::shared_ptr<const RollingSheet> sheet_;
  Tractions tractions_;
  std::vector<TractionPanel>
      outside_;  ///< panels from an end outwards, to where the elastic sheet moves no more
  double nats_;
  Vector leading_,
      trailing_;       ///< coefficients of the pressure on both halves, by the distance from their ends
  Vector amplitudes_;  ///< of the columns of direct_row()
  Float edge_displacement_, offset_, load_, moment_;
  int unknowns_ = 0;
  mutable std::optional<Trace> pressure_;
  mutable std::map<Influence, Trace> elastic_;
};

}  // namespace nipref::ref
