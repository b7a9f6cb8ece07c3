#include <cmath>
#include <limits>

#include <nipref/verify/catalogue/memory/internal/passing_times.hpp>

namespace nipref::verify {

double nearby(double value, Random& random) {
  const double size = std::ldexp(random.uniform(0.5, 1), -static_cast<int>(random.index(52)));
  const double near = value * (1 + (random.chance(0.5) ? size : -size));
  return near == value ? std::nextafter(value, std::numeric_limits<double>::infinity()) : near;
}

double draw_passing_time(double t, Random& random) {
  switch (random.index(6)) {
    case 0:
    case 1:
      return nearby(t, random);
    case 2:
      return t * random.log_uniform(1e-16, 1e-3) * (random.chance(0.5) ? 1 : -1);
    case 3:
      return -random.log_uniform(1e-9, 50);
    case 4:
      return t * random.uniform();
    default:
      return random.log_uniform(1e-9, 50);
  }
}

}  // namespace nipref::verify
