#pragma once
#include <string>

#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// Decimal text of a value good to `digits` digits, three more than that (and as many more as the value has
/// before the point).
std::string decimal_text(const Float& value, int digits);

/// `error` and what rounding the value to decimal_text() adds to it, two significant digits, rounded up:
/// "1.2e-53".
std::string error_text(const Float& value, const Float& error, int digits);

/// x - value, formed exactly and rounded once.
double error_of(double x, const Float& value);

}  // namespace nipref::ref
