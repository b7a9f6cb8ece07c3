#pragma once
#include <array>
#include <map>
#include <optional>
#include <vector>

#include <nipref/ref/nip/internal/nip_solution.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_sheet.hpp>
#include <nipref/ref/viscoelastic_nip/internal/trace.hpp>

namespace nipref::ref {

/// The contact of a steadily rolling viscoelastic sheet as a sum of elastic ones, whose right-hand sides are what the inverse of
/// its compliance makes of the displacement: ref/viscoelastic_nip/README.md, Rolling contacts. n_j is what of the memory j comes
/// from ahead of the contact.
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
