#include <cmath>

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

/// fast as a function of one argument; the others are those of a base point.
class Line {
 public:
  Line(const Quantity& quantity, Point base, std::size_t argument)
      : quantity_(quantity), base_(std::move(base)), argument_(argument) {}

  [[nodiscard]] Point at(double x) const {
    Point point = base_;
    point[argument_] = x;
    return point;
  }
  [[nodiscard]] bool is_negative(double x) const { return std::signbit(fast_value(quantity_, at(x), {})); }
  [[nodiscard]] bool is_zero(double x) const { return fast_value(quantity_, at(x), {}) == 0; }

 private:
  const Quantity& quantity_;
  Point base_;
  std::size_t argument_;
};

/// The last double on lower's side of the sign change in (lower, upper).
double bisect(const Line& line, double lower, double upper) {
  const bool sign = line.is_negative(lower);
  for (double middle = lower + (upper - lower) / 2; middle > lower && middle < upper;
       middle = lower + (upper - lower) / 2) {
    (line.is_negative(middle) == sign ? lower : upper) = middle;
  }
  return lower;
}

void add_neighbourhood(const Line& line, double x, std::vector<Point>& points) {
  for (int i = 0; i < neighbours_on_each_side; ++i) x = std::nextafter(x, 0.0);
  for (int i = 0; i <= 2 * neighbours_on_each_side; ++i) {
    points.push_back(line.at(x));
    x = std::nextafter(x, 1e9);
  }
}

void add_zeros(const Line& line, std::vector<Point>& points) {
  static const std::vector<double> nodes = grid();
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (line.is_zero(nodes[i])) continue;  // the value underflows, and has no sign
    if (line.is_negative(nodes[i - 1]) == line.is_negative(nodes[i])) continue;
    add_neighbourhood(line, bisect(line, nodes[i - 1], nodes[i]), points);
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
      add_zeros(Line(quantity, draw_point(quantity, ranges, random), i), points);
  }
  for (Point& point : points) point = kept_off(quantity, ranges, std::move(point));
  std::erase_if(points, [&](const Point& point) { return !contains(ranges, point); });
  return thinned(std::move(points), limit);
}

}  // namespace nipref::verify
