#pragma once
#include <span>

namespace nipref::fast::internal {

/// I1(alpha) + ln|alpha| and I6(alpha, 0) + ln|alpha|, which are analytic for |Im alpha| < 2, including alpha = 0. The
/// error is two units in the last place of 1 + ln max(1, |alpha|). The spans have the same size.
void regular_I1(std::span<const double> alpha, std::span<double> value);
void regular_I6(std::span<const double> alpha, std::span<double> value);
/// The same functions with given ln|alpha|, whose error adds to that of the results.
void regular_I1(std::span<const double> alpha, std::span<const double> logarithm, std::span<double> value);
void regular_I6(std::span<const double> alpha, std::span<const double> logarithm, std::span<double> value);

}  // namespace nipref::fast::internal
