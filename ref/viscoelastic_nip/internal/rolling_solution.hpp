#pragma once
#include <array>
#include <map>
#include <optional>
#include <vector>

#include <nipref/ref/nip/internal/nip_solution.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_sheet.hpp>
#include <nipref/ref/viscoelastic_nip/internal/trace.hpp>

namespace nipref::ref {

/// The contact of a steadily rolling viscoelastic sheet as that of an elastic one, so that by RollingSheet
///
///     K p = f = u + sum_j b_j (int_0^x e^(-s_j (x - t)) u(t) dt + n_j e^(-s_j x)),   0 <= x <= 2A,
///     n_j = int_0^inf e^(-s_j w) u(-w) dw = sum_i a_i/(s_j - r_i) int_0^inf e^(-r_i w) f(-w) dw,
///
/// where the last integral, of what the elastic sheet would do ahead of the contact, is one of the pressure. The even and
/// the odd part of the pressure are those of elastic contacts with other right-hand sides: one for u as far as it is
/// known, for edge_displacement, for the offset and for each n_j. Each is solved with a bounded pressure and a constant or
/// a line beside f. These two must vanish in the sum, and the n_j be those of its pressure, which gives the unknowns.
class RollingSolution : public NipSolution {
 public:
  /// Integrals are good to about e^-nats.
  RollingSolution(const RollingSheet& sheet, Tractions tractions, double nats, SheetKernels& kernels);

  [[nodiscard]] int unknowns() const override { return unknowns_; }
  /// The contact that rolls the other way has the same load and the ends exchanged.
  [[nodiscard]] Float growth() const override;
  [[nodiscard]] Float normal(const Float& x, SheetKernels& kernels) const override;
  [[nodiscard]] Float tangential(const Float& x, SheetKernels& kernels) const override;
  [[nodiscard]] Float strain(const Float& x, SheetKernels& kernels) const override;

 private:
  [[nodiscard]] Vector direct_row(const Float& x) const;
  [[nodiscard]] Matrix memory_rows(SheetKernels& kernels) const;
  [[nodiscard]] std::array<Matrix, 2> bounded_parts(SheetKernels& kernels) const;
  [[nodiscard]] Matrix conditions(const std::array<Matrix, 2>& parts, SheetKernels& kernels) const;
  void solve(SheetKernels& kernels);

  [[nodiscard]] Float elastic(Influence kind, const Float& x, SheetKernels& kernels) const;
  [[nodiscard]] const Trace& pressure_trace() const;
  [[nodiscard]] const Trace& elastic_trace(Influence kind, SheetKernels& kernels) const;

  const RollingSheet& sheet_;
  std::vector<TractionPanel>
      outside_;  ///< panels from an end outwards, to where the elastic sheet moves no more
  double nats_;
  Vector amplitudes_;  ///< of the columns of direct_row()
  int unknowns_ = 0;
  mutable std::optional<Trace> pressure_;
  mutable std::map<Influence, Trace> elastic_;
};

}  // namespace nipref::ref
