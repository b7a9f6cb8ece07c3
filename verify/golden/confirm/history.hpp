#pragma once
#include <nipref/verify/golden/confirm/kernels.hpp>

namespace nipref::verify::confirm {

/// A kernel whose history is taken: its values and the residues of its symbol.
struct Remembered {
  Split (*at)(const mpq_class& x);
  Complex Pole::*residue;
  bool is_odd;
};
inline constexpr Remembered remembered_I1{kernel_I1, &Pole::I1, false},
    remembered_I3{kernel_I3, &Pole::I3, true}, remembered_I4{kernel_I4, &Pole::I4, true},
    remembered_I5{kernel_I5, &Pole::I5, true};

/// int e^(-rate (w - from)) I(w) dw from `from` to `to`, or to infinity without `to`; an odd kernel is taken without
/// its term pi/4 sign w. For |w| < 3 by Gauss's rule on panels with a Chebyshev interpolant of the kernel; beyond, as
/// the sum of the integrals of the terms that belong to the kernel's poles. The coarse rule has fewer points. The
/// rate may be complex.
Complex history(const Remembered& kernel, const mpq_class& from, const std::optional<mpq_class>& to,
                const Complex& rate, bool coarse);

/// The same integral of sign w, in closed form.
LongComplex history_of_sign(const mpq_class& from, const std::optional<mpq_class>& to,
                            const LongComplex& rate);

}  // namespace nipref::verify::confirm
