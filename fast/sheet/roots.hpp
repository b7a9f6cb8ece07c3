#pragma once
#include <complex>

namespace nipref::fast {

/// n-th root z_n, in the first quadrant and ordered by modulus, of sinh 2z + 2z = 0, dimensionless; (n - 1/2)
/// pi < Im z_n < n pi. Thesis Appendix IV. n: 1 <= n <= 1000000, otherwise BadInput. |error| <= 2 units in
/// the last place of |z_n|. About 0.4 us.
std::complex<double> sheet_root(int n);

}  // namespace nipref::fast
