#pragma once
#include <cstddef>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/catalogue/ranges.hpp>
#include <nipref/verify/support/random.hpp>

namespace nipref::verify {

/// Points at and beside the sign changes of fast's value along its position arguments, found on a grid over
/// [1e-3, 700] that is finer than the kernels' half period (2.8) and bisected down to adjacent doubles; other
/// arguments are random, all in their ranges. At most `limit` points, thinned evenly.
std::vector<Point> zero_points(const Quantity& quantity, const Ranges& ranges, std::size_t limit,
                               Random& random);

}  // namespace nipref::verify
