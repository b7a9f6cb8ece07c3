#pragma once
#include <optional>

#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// The condition number of the quantity at the point: sum |x df/dx| / |f| over its arguments x that are numbers,
/// dimensionless. So many units in the last place a value may be off for one of each argument. By differences of the
/// reference over 2^-20 of an argument, good to about 1e-10 of itself where the quantity is smooth. None where the
/// value is 0 or the reference refuses a neighbour.
std::optional<double> condition_number(const Quantity& quantity, const Point& point);

}  // namespace nipref::verify
