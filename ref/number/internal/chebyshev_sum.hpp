#pragma once
#include <span>
#include <vector>

#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// sum_n c_n T_n(x), |x| <= 1, by Clenshaw's recurrence b_n = c_n + 2 x b_{n+1} - b_{n+2}. The rounding error of b_n is
/// at most 4 units of |c_n| + 2 |b_{n+1}| + |b_{n+2}| and has the effect of the same change of c_n; |b_n| is at most
/// the sum of all (k + 1) |c_k|.
Float chebyshev_sum(std::span<const Float> coefficients, const Float& x);

/// T_0 .. T_{values.size() - 1} at x.
void chebyshev_values(const Float& x, std::vector<Float>& values);

/// Chebyshev's points of 0 .. 1, rising: sin^2((2i + 1) pi/(4 count)).
std::vector<Float> chebyshev_points(int count);

}  // namespace nipref::ref
