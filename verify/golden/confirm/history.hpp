#pragma once
#include <optional>

#include <nipref/verify/golden/confirm/kernels.hpp>

namespace nipref::verify::confirm {

/// More digits, for parts that cancel.
using Long = Number<700>;
using LongComplex = ComplexNumber<700>;

enum class Remembered { I1, I3, I4, I5 };

/// int e^(-rate (w - from)) I(w) dw from `from` to `to` (none: infinity), for an odd kernel of what it is beside
/// pi/4 sign w: by Gauss's rule over panels, the kernel interpolated between Chebyshev points, for |w| < 3; beyond,
/// of the waves of the kernel's poles one by one. Coarse: with Gauss's rule of fewer points.
/// The rate may be complex.
Complex history(Remembered kernel, const mpq_class& from, const std::optional<mpq_class>& to,
                const Complex& rate, bool coarse);

/// The same of sign w, in closed form.
LongComplex history_of_sign(const mpq_class& from, const std::optional<mpq_class>& to,
                            const LongComplex& rate);

}  // namespace nipref::verify::confirm
