#pragma once
#include <optional>

#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// The condition number of the quantity at the point, dimensionless: the sum of |x df/dx| / |f| over its numerical
/// arguments x. An error of one unit in the last place of each argument changes the value by about so many units in
/// the last place. It follows from difference quotients of the reference with relative steps of 2^-20, to a relative
/// accuracy of about 1e-10 where the quantity is smooth. Nothing if the value is 0 or the reference refuses a
/// neighbouring point.
std::optional<double> condition_number(const Quantity& quantity, const Point& point);

}  // namespace nipref::verify
