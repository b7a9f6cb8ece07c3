#pragma once
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// Fourier kernels of the elastic sheet (half thickness b, lengths in units of b) to any accuracy.
///
/// S(x) = sinh 2x + 2x. Arguments are dimensionless exact numbers, |argument| <= 1000; digits 16 to 1000. Every
/// function promises an Enclosure: error <= 10^-digits min(1, |truth|), also near zeros of the kernel. The bound is
/// proven: see transform.hpp for the quadrature, clenshaw.hpp and nodes.hpp for its rounding, residues.hpp for the
/// series at large arguments; closed forms and the series are in interval arithmetic. Arguments and digits outside
/// their domain throw data::BadInput.

/// int_0^inf 2 sinh^2 x cos(alpha x)/(x S) dx; alpha != 0. (thesis 4.9, AI.1)
Enclosure I1(const Exact& alpha, int digits);

/// int_0^inf sin(alpha x)/x dx = (pi/2) sign(alpha), 0 at 0. (thesis 4.9, AI.10)
Enclosure I2(const Exact& alpha, int digits);

/// int_0^inf 2 sin(alpha x)/S dx. (thesis 4.9)
Enclosure I3(const Exact& alpha, int digits);

/// int_0^inf 2 sinh x sin(eta x)/(x S) dx. (thesis 4.9)
Enclosure I4(const Exact& eta, int digits);

/// int_0^inf 2 cosh x sin(eta x)/S dx. (thesis 4.9)
Enclosure I5(const Exact& eta, int digits);

/// int_0^inf 2 cosh x (cosh x cos(alpha x) - cos(eta x))/(x S) dx; alpha != 0. (thesis 4.20)
Enclosure I6(const Exact& alpha, const Exact& eta, int digits);

/// int_0^inf 2 sinh x cos(eta x)/S dx. (thesis 4.20)
Enclosure I7(const Exact& eta, int digits);

/// Numbers of kernel values that were computed: of I1, of I3, and of I6 - I1.
struct KernelValues {
  long normal = 0, coupling = 0, stretch = 0;
  friend KernelValues operator+(const KernelValues& a, const KernelValues& b) {
    return {a.normal + b.normal, a.coupling + b.coupling, a.stretch + b.stretch};
  }
};

/// BadInput naming `name` unless |argument| <= 1000.
void check_argument(const Exact& argument, const char* name);
/// BadInput naming `name` unless |argument| <= 1000, and at 0, where the kernel is infinite.
void check_nonzero_argument(const Exact& argument, const char* name);

/// BadInput unless -1 < poisson <= 1/2.
void check_poisson(const Exact& poisson);

/// Im z_1, the slowest decay rate of a kernel, rounded up.
inline constexpr double slowest_decay = 2.1062;

/// About -ln of the size of I6 and of vs. As |alpha| -> |eta|, their linear growth cancels; the rest decays with both.
double nats_of_difference(const Exact& alpha, const Exact& eta);

}  // namespace nipref::ref
