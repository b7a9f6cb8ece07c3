#pragma once
#include <nipref/fast/sheet/generator/number.hpp>

namespace nipref::fast::generator {

/// The first `count` roots of sinh 2z + 2z = 0 in the first quadrant, ordered by modulus. Each is checked to
/// solve the equation and to lie in its own strip n pi - pi/2 < Im z < n pi, which holds no other (thesis
/// Appendix IV); a failed check throws std::logic_error.
std::vector<Complex> first_roots(int count);

}  // namespace nipref::fast::generator
