#pragma once
#include <complex>

namespace nipref::fast {

/// The n-th root z_n of sinh 2z + 2z = 0 in the first quadrant, ordered by modulus, dimensionless;
/// (n - 1/2) pi < Im z_n < n pi. Thesis Appendix IV. n: 1 <= n <= 1000000, otherwise BadInput.
/// |error| <= 2 units in the last place of |z_n|. A call takes about 0.4 us.
std::complex<double> sheet_root(int n);

}  // namespace nipref::fast
