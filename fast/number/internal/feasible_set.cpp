#include <algorithm>
#include <cmath>

#include <nipref/fast/number/internal/feasible_set.hpp>

namespace nipref::fast {
namespace {

using Parts = std::vector<FeasibleSet::Part>;

constexpr double infinity = std::numeric_limits<double>::infinity();

Parts where_affine(double constant, double slope) {
  if (slope == 0) return constant >= 0 ? Parts{{-infinity, infinity}} : Parts{};
  const double root = -constant / slope;
  return slope > 0 ? Parts{{root, infinity}} : Parts{{-infinity, root}};
}

/// To avoid cancellation, the quadratic formula gives the root of larger magnitude, and the product of both the other.
Parts where_not_negative(const Quadratic& f) {
  const double discriminant = f.linear * f.linear - 4 * f.square * f.constant;
  if (f.square == 0) return where_affine(f.constant, f.linear);
  if (discriminant <= 0) return f.square > 0 ? Parts{{-infinity, infinity}} : Parts{};
  const double q = -(f.linear + std::copysign(std::sqrt(discriminant), f.linear)) / 2;
  const auto [low, high] = std::minmax({q / f.square, f.constant / q});
  return f.square > 0 ? Parts{{-infinity, low}, {high, infinity}} : Parts{{low, high}};
}

}  // namespace

void FeasibleSet::require_not_negative(const Quadratic& function) {
  Parts both;
  for (const Part& a : parts_) {
    for (const Part& b : where_not_negative(function)) {
      const Part common{std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
      if (common.lower <= common.upper) both.push_back(common);
    }
  }
  parts_ = std::move(both);
}

}  // namespace nipref::fast
