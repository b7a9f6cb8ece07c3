#pragma once
#include <complex>
#include <variant>
#include <vector>

#include <nipref/fast/memory/internal/fading.hpp>
#include <nipref/fast/nip/internal/tractions.hpp>
#include <nipref/fast/number/internal/sized.hpp>
#include <nipref/fast/viscoelastic_nip/internal/rolling_compliance.hpp>

namespace nipref::fast {

/// The compliances of a rolling sheet over the instantaneous N, as functions of the travel in half-thicknesses.
struct RollingSheet {
  RollingCompliance normal;  ///< N
  double theta2_at_once;
  std::vector<Memory> theta2;  ///< its rates are among those of N
};

/// The response of the surface to a line load that has always moved steadily, at the distance alpha from it, > 0 ahead
/// of it: the elastic kernels and their memories. The even and the odd part of the pressure have equal kernels.
class RollingKernels {
 public:
  /// `sheet` must outlive this.
  explicit RollingKernels(const RollingSheet& sheet);

  /// normal(): the normal displacement. along(): the displacement along the sheet relative to that far ahead, and its
  /// derivative without its local part, which is minus the instantaneous theta2 times the pressure. Each functional is
  /// followed by the size of the parts that may cancel in it.
  [[nodiscard]] Tractions::Kernel normal() const;
  [[nodiscard]] Tractions::Kernel along() const;
  /// At alpha >= 0: int_0^inf e^(-rate x) I1(alpha + x) dx/pi for each term of N, real and imaginary part as two
  /// functionals, 0 for the second term of a conjugate pair. If `whole`, the same with I1' and then I1/pi follow.
  [[nodiscard]] Tractions::Kernel ahead(bool whole) const;

 private:
  using Fades = std::vector<std::variant<internal::Fade, internal::OscillatingFade>>;
  /// The memory of the kernel for each term of N.
  [[nodiscard]] Fades fades(internal::Kernel kernel) const;
  /// Adds amplitude times `memory` for all terms; of a conjugate pair one is evaluated.
  ///
  /// Behind the load a term leaves a trace, a multiple of e^(rate alpha). If the rate is complex, the traces of the
  /// whole contact cancel. Rounding of alpha and of rate alpha changes the phase of a trace, so that its relative error
  /// is 2 u |rate alpha|. A number of size s counts with the error 32 u s (see Solution); therefore |rate alpha|/16
  /// times the trace is added to the size. size_of_trace(part, |amplitude| e^(Re rate alpha), rate) bounds the trace:
  /// for I1 it is the part itself; for I3 it is 2 pi/|rate| per unit of amplitude, an upper bound of pi/2 for the step
  /// from one limit to the other, pi/2 for that of the rest, and pi/2 for the change of the rest on both sides.
  template <class Sum, class MemoryOf, class SizeOfTrace>
  void add_terms(Sum& sum, double alpha, const Fades& fades, const MemoryOf& memory,
                 const SizeOfTrace& size_of_trace) const;

  using Sized = internal::Sized<double>;
  /// pi times these kernels at alpha; `at` is the same point of the surface.
  ///
  /// Far from the load the displacement is the slowest residue term of I1, with the root z, and its memories. Since
  /// alpha has one rounding and the place three (SolvedNip::reach), its error is 4 u |z alpha| of its amplitude. At an
  /// extremum of the displacement neither its size nor its change with the place shows this error, so that |z alpha|/8
  /// times the amplitude is added to the size.
  [[nodiscard]] Sized normal_at(double alpha, const internal::SurfacePoint& at) const;
  [[nodiscard]] Sized tangential_at(double alpha, const internal::SurfacePoint& at) const;
  [[nodiscard]] Sized strain_at(double alpha, const internal::SurfacePoint& at) const;
  [[nodiscard]] std::vector<std::complex<double>> rates() const;

  /// The number of functionals of ahead(), and its kernel, a row for each functional.
  [[nodiscard]] Eigen::Index functionals_ahead(bool whole) const;
  [[nodiscard]] Eigen::MatrixXd ahead_at(std::span<const double> alpha, bool whole) const;
  /// The parts of ahead(false): the factor of its logarithm; the rest; and the rest at 0 <= alpha <= width,
  /// interpolated from cached values at Chebyshev points of [0, length]. The length is a little more than the width, so
  /// that it suffices for the other contacts of a search.
  [[nodiscard]] Eigen::MatrixXd factor_of_logarithm(const Eigen::ArrayXd& alpha) const;
  [[nodiscard]] Eigen::MatrixXd rest_at(const Eigen::ArrayXd& alpha) const;
  [[nodiscard]] Eigen::MatrixXd interpolated_rest(const Eigen::ArrayXd& alpha, double width) const;
  struct KeptRest {
    double length;
    Eigen::MatrixXd values;
  };

  const RollingSheet& sheet_;
  Fades fades_;               ///< memories of I1
  double slowest_amplitude_;  ///< bound of the slowest residue term and its memories at alpha = 0
  // Kept from call to call without a lock: only one thread at a time may use an object or the kernels made by it. Each
  // contact has its own.
  mutable KeptRest kept_rest_{};  ///< of the last width, by ahead(false); replaced when a width does not fit
  mutable Fades fades_along_;     ///< memories of I3; filled by the first along(), then unchanged
};

}  // namespace nipref::fast
