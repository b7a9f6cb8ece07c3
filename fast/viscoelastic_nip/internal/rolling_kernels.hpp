#pragma once
#include <complex>
#include <vector>

#include <nipref/fast/memory/internal/fading.hpp>
#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/nip/internal/tractions.hpp>
#include <nipref/fast/viscoelastic_nip/internal/rolling_compliance.hpp>

namespace nipref::fast {

/// The compliances of a rolling sheet, over N at once and by half-thicknesses of way instead of time.
struct RollingSheet {
  RollingCompliance normal;  ///< N
  double theta2_at_once;
  std::vector<Memory> theta2;  ///< its rates are among those of N
};

/// What a line load that moves steadily does to the surface at a distance alpha, > 0 ahead of it: the elastic kernels and
/// their memories, since the load has come from infinitely far. The kernels of the pressure's even and odd part are equal.
class RollingKernels {
 public:
  /// Both live as long as this.
  RollingKernels(const RollingSheet& sheet, CountedKernels& kernels);

  [[nodiscard]] Tractions::Kernel elastic() const;  ///< normal displacement, I1/pi, of what gives way at once
  [[nodiscard]] Tractions::Kernel normal() const;   ///< normal displacement, that of N
  [[nodiscard]] Tractions::Kernel tangential()
      const;  ///< displacement along the sheet beside what it is far ahead
  /// Its derivative, less theta2 at once times the pressure at the place.
  [[nodiscard]] Tractions::Kernel strain() const;
  /// Bounds on the parts that may cancel in the last two, at most `farthest` from the place.
  [[nodiscard]] double tangential_size(double farthest) const;
  [[nodiscard]] double strain_size() const;
  /// int_0^inf e^(-rate x) I1(alpha + x) dx/pi for a term of N, real and imaginary part as two functionals.
  [[nodiscard]] Tractions::Kernel ahead(std::size_t term) const;
  /// The same with the derivative I1'.
  [[nodiscard]] Tractions::Kernel slope_ahead(std::size_t term) const;

 private:
  /// The sum over the terms of Re amplitude times `memory` of their rate; of a conjugate pair one is evaluated.
  template <class MemoryOf>
  [[nodiscard]] double over_terms(const MemoryOf& memory) const;

  [[nodiscard]] std::vector<double> relaxation_lengths() const;
  template <class MemoryOf>
  [[nodiscard]] Tractions::Kernel of_term(std::size_t term, const MemoryOf& memory) const;

  const RollingSheet& sheet_;
  CountedKernels& kernels_;
  std::vector<internal::Fade> fades_;  ///< of the terms with real rates
};

}  // namespace nipref::fast
