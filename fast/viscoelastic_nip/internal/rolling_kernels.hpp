#pragma once
#include <complex>
#include <variant>
#include <vector>

#include <nipref/fast/memory/internal/fading.hpp>
#include <nipref/fast/nip/internal/tractions.hpp>
#include <nipref/fast/number/internal/sized.hpp>
#include <nipref/fast/viscoelastic_nip/internal/rolling_compliance.hpp>

namespace nipref::fast {

/// The compliances of a rolling sheet, over N at once and by half-thicknesses of travel instead of time.
struct RollingSheet {
  RollingCompliance normal;  ///< N
  double theta2_at_once;
  std::vector<Memory> theta2;  ///< its rates are among those of N
};

/// What a line load that moves steadily does to the surface at a distance alpha, > 0 ahead of it: the elastic kernels and
/// their memories, since the load has come from infinitely far. The kernels of the pressure's even and odd part are equal.
class RollingKernels {
 public:
  /// `sheet` lives as long as this.
  explicit RollingKernels(const RollingSheet& sheet);

  /// Each with the size of the parts that may cancel in it as the next functional: the normal displacement that N gives; the
  /// displacement along the sheet beside what it is far ahead, and its derivative less theta2 at once times the pressure at
  /// the place.
  [[nodiscard]] Tractions::Kernel normal() const;
  [[nodiscard]] Tractions::Kernel along() const;
  /// At alpha >= 0: int_0^inf e^(-rate x) I1(alpha + x) dx/pi for each term of N, real and imaginary part as two functionals,
  /// 0 for the second of a conjugate pair. The whole has the same with the derivative I1' after them, and I1/pi at the end.
  [[nodiscard]] Tractions::Kernel ahead(bool whole) const;

 private:
  using Fades = std::vector<std::variant<internal::Fade, internal::OscillatingFade>>;
  /// Of each term.
  [[nodiscard]] Fades fades(internal::Kernel kernel) const;
  /// Adds amplitude times `memory` for all terms; of a conjugate pair one is evaluated.
  ///
  /// Behind the load a term leaves a trace, a multiple of e^(rate alpha). If the rate is complex, the traces of the whole
  /// contact cancel. The phase of each is rounded with alpha and with the product rate alpha: the trace is off by
  /// 2 u |rate alpha| of itself. A number of size s counts as off by 32 u s (see Solution), so that |rate alpha|/16 times the
  /// trace is added to the size. size_of_trace(part, |amplitude| e^(Re rate alpha), rate) bounds the trace: of the memory of
  /// I1 it is the part itself; of I3, which is within pi/2 of its limits, 2 pi/|rate| for each unit of amplitude.
  template <class Sum, class MemoryOf, class SizeOfTrace>
  void add_terms(Sum& sum, double alpha, const Fades& fades, const MemoryOf& memory,
                 const SizeOfTrace& size_of_trace) const;

  using Sized = internal::Sized<double>;
  /// pi times these kernels at alpha, where the load's point `at` is.
  ///
  /// Far from the load the displacement is the slowest residue term of I1, of the root z, and of its memories. It is off by
  /// 2 u |z alpha| of its amplitude, since alpha is rounded. Where the displacement has an extreme, neither its size nor its
  /// change with the place tells so: |z alpha|/8 times the amplitude is added to the size.
  [[nodiscard]] Sized normal_at(double alpha, const internal::SurfacePoint& at) const;
  [[nodiscard]] Sized tangential_at(double alpha, const internal::SurfacePoint& at) const;
  [[nodiscard]] Sized strain_at(double alpha, const internal::SurfacePoint& at) const;
  [[nodiscard]] std::vector<std::complex<double>> rates() const;

  /// Of ahead(): the number of functionals, and the kernel, a row for each.
  [[nodiscard]] Eigen::Index functionals_ahead(bool whole) const;
  [[nodiscard]] Eigen::MatrixXd ahead_at(std::span<const double> alpha, bool whole) const;
  /// Of ahead(false): the factor of its logarithm; the rest; and the rest at 0 <= alpha <= width from its values at Chebyshev
  /// points of [0, length] that are kept. The length is a little more than the width: the contacts of a search for a length differ
  /// by less.
  [[nodiscard]] Eigen::MatrixXd factor_of_logarithm(const Eigen::ArrayXd& alpha) const;
  [[nodiscard]] Eigen::MatrixXd rest_at(const Eigen::ArrayXd& alpha) const;
  [[nodiscard]] Eigen::MatrixXd interpolated_rest(const Eigen::ArrayXd& alpha, double width) const;
  struct KeptRest {
    double length;
    Eigen::MatrixXd values;
  };

  const RollingSheet& sheet_;
  Fades fades_;               ///< of I1
  double slowest_amplitude_;  ///< of the slowest residue term and its memories, at alpha = 0, at most
  mutable KeptRest kept_rest_{};
  mutable Fades fades_along_;  ///< of I3, once along() is asked for
};

}  // namespace nipref::fast
