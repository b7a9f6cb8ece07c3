#pragma once
#include <string>

#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// The value as decimal text with three significant digits more than `digits`, and as many more as it has before the
/// point.
std::string decimal_text(const Float& value, int digits);

/// The sum of `error` and of the error by which decimal_text() rounds the value, as text of two significant digits,
/// rounded up: "1.2e-53".
std::string error_text(const Float& value, const Float& error, int digits);

/// x - value, formed exactly and rounded once.
double error_of(double x, const Float& value);

}  // namespace nipref::ref
