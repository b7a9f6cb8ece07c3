#pragma once

namespace nipref::verify {

/// Unit in the last place: 2^(e-52) for 2^e <= |scale| < 2^(e+1), and 2^-1074 for zero and subnormal scales:
/// the spacing of the doubles just above |scale|. Same unit as `scale`. Exact. BadInput naming "scale" unless
/// it is finite.
double ulp_of(double scale);

}  // namespace nipref::verify
