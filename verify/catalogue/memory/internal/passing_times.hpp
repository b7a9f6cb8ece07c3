#pragma once
#include <nipref/verify/support/random.hpp>

namespace nipref::verify {

/// A neighbour of `value`, at a relative distance log-uniform from 2^-52 to 1.
double nearby(double value, Random& random);

/// T (or t0) for a load that started t ago: near t on either side, near 0 on either side, long passed, far
/// ahead. Never t itself.
double draw_passing_time(double t, Random& random);

}  // namespace nipref::verify
