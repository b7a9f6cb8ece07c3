#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <nipref/fast/nip/internal/shear_search.hpp>
#include <nipref/fast/nip/internal/nip_equations.hpp>

namespace nipref::fast {
namespace {

constexpr int grid_steps = 24;
constexpr double coarse_tolerance = 1e-5;

}  // namespace

ShearSearch::ShearSearch(double half_length, bool is_symmetric, Shear shear)
    : half_length_(half_length),
      reach_(std::min(1.0, half_length)),
      is_symmetric_(is_symmetric),
      shear_(std::move(shear)) {}

double ShearSearch::scale(const Point& point) const {
  return std::min(reach_, std::hypot(half_length_ - std::fabs(point.y), 1 - point.depth));
}

double ShearSearch::last_step(const Point& point) const {
  return std::max(1e-9 * scale(point), 1e-14 * reach_);
}

std::vector<ShearSearch::Point> ShearSearch::maxima() const {
  std::vector<Point> maxima = maxima_on_grid();
  for (Point& maximum : maxima) maximum = climb(maximum);
  return maxima;
}

std::vector<ShearSearch::Point> ShearSearch::maxima_on_grid() const {
  const double deepest = std::min(1.0, 2.5 * half_length_);
  const int first = is_symmetric_ ? 0 : -grid_steps, columns = grid_steps - first + 1;
  const auto point = [&](Eigen::Index i, Eigen::Index j) -> Point {
    const double along = static_cast<double>(first + i) / grid_steps;
    return {half_length_ * std::sin(std::numbers::pi / 2 * along),
            1 - deepest * static_cast<double>(j) / grid_steps};
  };
  const Eigen::MatrixXd shears = Eigen::MatrixXd::NullaryExpr(
      columns, grid_steps + 1,
      [&](Eigen::Index i, Eigen::Index j) { return shear_(point(i, j), coarse_tolerance); });
  std::vector<Point> maxima;
  for (Eigen::Index i = 0; i < shears.rows(); ++i) {
    for (Eigen::Index j = 0; j < shears.cols(); ++j) {
      const Eigen::Index left = std::max<Eigen::Index>(i - 1, 0), above = std::max<Eigen::Index>(j - 1, 0);
      const auto around = shears.block(left, above, std::min(i + 2, shears.rows()) - left,
                                       std::min(j + 2, shears.cols()) - above);
      if (shears(i, j) == around.maxCoeff()) maxima.push_back(point(i, j));
    }
  }
  return maxima;
}

ShearSearch::Point ShearSearch::climb(Point best) const {
  double step = reach_ / grid_steps, tolerance = coarse_tolerance, largest = 0;
  // A step changes the shear by about (step/scale)^2. A tolerance of this part of the change shows its sign.
  const auto resolve = [&] {
    constexpr double telling = 1e-4;
    tolerance = std::clamp(telling * std::pow(step / scale(best), 2), quadrature_tolerance, coarse_tolerance);
    largest = shear_(best, tolerance);
  };
  const auto moves_to = [&](const Point& point) {
    const double here = shear_(point, tolerance);
    if (!(here > largest)) return false;
    largest = here;
    best = point;
    return true;
  };
  resolve();
  while (step > last_step(best)) {
    const auto [y, depth] = best;
    const double back = is_symmetric_ ? std::fabs(y - step) : y - step;
    const bool moved = moves_to({y + step, depth}) || moves_to({back, depth}) ||
                       moves_to({y, std::min(1.0, depth + step)}) || moves_to({y, std::fabs(depth - step)});
    if (moved) continue;
    step /= 2;
    resolve();
  }
  return best;
}

// A paraboloid falls by f_y or f_d at a distance in one direction, and by f_y + f_d +- 2 c (f_y f_d)^(1/2) at both
// distances. What of it is above a level reaches 1/(1 - c^2)^(1/2) times as far in a direction as it does on this
// direction's axis.
ShearSearch::Point ShearSearch::flat_part(const Point& maximum, double slack) const {
  const double highest = shear_(maximum, quadrature_tolerance);
  const auto fall = [&](double y, double depth) {
    const Point there{maximum.y + y, maximum.depth + depth};
    const bool is_sought = there.depth >= 0 && there.depth <= 1 && !(is_symmetric_ && there.y < 0);
    return is_sought ? highest - shear_(there, quadrature_tolerance)
                     : std::numeric_limits<double>::infinity();
  };
  const Point farthest{2 * half_length_, 1};
  const auto on_axis = [&](double y, double depth, double most) {
    double far = last_step(maximum);
    while (far < most && !(std::min(fall(far * y, far * depth), fall(-far * y, -far * depth)) > slack))
      far *= 1.5;
    return std::min(far, most);
  };
  const double y = on_axis(1, 0, farthest.y), depth = on_axis(0, 1, farthest.depth);
  double c = 0;
  for (const double to_y : {y, -y}) {
    for (const double to_depth : {depth, -depth}) {
      const double along = fall(to_y, 0), across = fall(0, to_depth), both = fall(to_y, to_depth);
      if (std::isinf(both)) continue;
      const double product = along * across;
      if (product > 0)
        c = std::max(c, std::fabs(both - along - across) / (2 * std::sqrt(product)));
      else if (!(both > slack))
        c = 1;
    }
  }
  const double longer = 1 / std::sqrt(std::max(1 - c * c, 0.0));
  return {std::min(longer * y, farthest.y), std::min(longer * depth, farthest.depth)};
}

}  // namespace nipref::fast
