#include <nipref/verify/audit/internal/sampling.hpp>

namespace nipref::verify {
namespace {

constexpr int neighbours_on_each_side = 3;
constexpr int lines_with_random_arguments = 6;

/// A grid that is logarithmic up to 1, then linear.
std::vector<double> grid() {
  std::vector<double> nodes;
  for (double x = 1e-3; x < 1; x *= 1.05) nodes.push_back(x);
  for (double x = 1; x <= 700; x += 0.25) nodes.push_back(x);
  return nodes;
}

/// Adds the points about the zeros of fast along one argument. The other arguments are those of `point`.
void add_zeros(const Quantity& quantity, Point point, std::size_t argument, std::vector<Point>& points) {
  static const std::vector<double> nodes = grid();
  const auto value_at = [&](double x) {
    point[argument] = x;
    return fast_value(quantity, point, {});
  };
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    double lower = nodes[i - 1], upper = nodes[i];
    const bool sign = std::signbit(value_at(lower));
    const double above = value_at(upper);
    // A value that underflows has no sign.
    if (above == 0 || std::signbit(above) == sign) continue;
    for (double middle = lower + (upper - lower) / 2; middle > lower && middle < upper;
         middle = lower + (upper - lower) / 2)
      (std::signbit(value_at(middle)) == sign ? lower : upper) = middle;
    double& x = point[argument] = lower;
    for (int k = 0; k < neighbours_on_each_side; ++k) x = std::nextafter(x, 0.0);
    for (int k = 0; k <= 2 * neighbours_on_each_side; ++k, x = std::nextafter(x, 1e9))
      points.push_back(point);
  }
}

}  // namespace

std::vector<Point> zero_points(const Quantity& quantity, const Ranges& ranges, std::size_t limit,
                               Random& random) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < quantity.arguments.size(); ++i) {
    const ArgumentKind kind = quantity.arguments[i].kind;
    if (kind != ArgumentKind::position && kind != ArgumentKind::nonzero_position) continue;
    const int lines = quantity.arguments.size() == 1 ? 1 : lines_with_random_arguments;
    for (int line = 0; line < lines; ++line)
      add_zeros(quantity, draw_point(quantity, ranges, random), i, points);
  }
  for (Point& point : points) point = kept_off(quantity, ranges, std::move(point));
  std::erase_if(points, [&](const Point& point) { return !contains(ranges, point); });
  return thinned(std::move(points), limit);
}

}  // namespace nipref::verify
