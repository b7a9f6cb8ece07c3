#pragma once
#include <memory>

#include <nipref/fast/elastic_nip/internal/half_contact.hpp>
#include <nipref/fast/nip/internal/counted_kernels.hpp>

namespace nipref::fast {

/// Frictionless contact of half length A (half-thicknesses): pressure sqrt(1 - t^2) sum_{k < terms} c_k
/// U_2k(t), t = y/A, from (1/pi) int I1(y - s) P(s) ds = D - y^2 at terms + 1 points. The logarithm of I1
/// acts on the expansion in closed form, the analytic rest by Gauss-Chebyshev. Converges like (2/A + sqrt(1 +
/// 4/A^2))^(-2 terms): good for A up to about 10. A > 0 and finite, terms >= 1. (thesis 2.2, 5.3; continuous
/// form)
std::unique_ptr<HalfContact> spectral_contact(double half_length, int terms, CountedKernels& kernels);

}  // namespace nipref::fast
