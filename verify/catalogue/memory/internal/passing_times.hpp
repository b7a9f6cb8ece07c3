#pragma once
#include <nipref/verify/support/random.hpp>

namespace nipref::verify {

/// A neighbour of `value`, at a relative distance log-uniform from 2^-52 to 1.
double nearby(double value, Random& random);

/// Draws T, or t0, the time at which a load that started a time t ago passes a point: just before or after t, just before or
/// after 0, long before, or long after. It is never t itself.
double draw_passing_time(double t, Random& random);

}  // namespace nipref::verify
