#include <numeric>

#include <nipref/verify/audit/internal/sampling.hpp>

namespace nipref::verify {
namespace {

constexpr double smallest_position = 1e-300;
constexpr double largest_position = 700;
constexpr double middle_from = 1e-3;
constexpr double middle_to = 50;
constexpr double share_beyond_middle = 0.01;

bool is_position(ArgumentKind kind) {
  return kind == ArgumentKind::position || kind == ArgumentKind::nonzero_position;
}

double with_random_sign(double magnitude, Random& random) {
  return random.chance(0.5) ? magnitude : -magnitude;
}

double draw_position(Random& random) {
  if (random.chance(share_beyond_middle))
    return with_random_sign(random.log_uniform(middle_to, largest_position), random);
  const double magnitude = random.chance(0.5) ? random.log_uniform(smallest_position, largest_position)
                                              : random.log_uniform(middle_from, middle_to);
  return with_random_sign(magnitude, random);
}

/// The value at `fraction`, in [0, 1), of the interval over which numbers of this kind are spread.
double spread(ArgumentKind kind, double fraction) {
  const double from = kind_of_number(kind).from, to = kind_of_number(kind).to;
  if (from <= 0 || to <= 0) return to + (from - to) * (1 - fraction);
  const double value = std::exp(std::log(from) + fraction * (std::log(to) - std::log(from)));
  return kind == ArgumentKind::index ? std::floor(value) : value;
}

/// A second position that is related to the first.
double related_position(double first, Random& random) {
  const std::size_t way = random.index(8);
  if (way == 0) return first;
  if (way == 1) return -first;
  if (way == 2) return first * (1 + std::ldexp(random.uniform(-1, 1), -static_cast<int>(random.index(52))));
  if (way == 3) return 0;
  if (way > 4) return draw_position(random);
  const bool is_far = std::fabs(first) > 1e-3;
  return with_random_sign(is_far ? random.log_uniform(smallest_position, 1e-6) : random.uniform(1, middle_to),
                          random);
}

double neighbour(double value, int steps) {
  const double direction =
      steps > 0 ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
  for (int step = 0; step < std::abs(steps); ++step) value = std::nextafter(value, direction);
  return value;
}

double into_domain(ArgumentKind kind, double value) {
  if (kind == ArgumentKind::nonzero_position && value == 0) return smallest_position;
  const KindOfNumber& of = kind_of_number(kind);
  return std::clamp(kind == ArgumentKind::index ? std::round(value) : value, of.least, of.most);
}

bool has_range(const Ranges& ranges, std::size_t argument) { return !ranges.empty() && ranges[argument]; }

/// Draws the arguments that have a range again, from their range.
void into_ranges(const Ranges& ranges, Point& point, Random& random) {
  for (std::size_t i = 0; i < ranges.size(); ++i)
    if (ranges[i]) point[i] = ranges[i]->fixed() ? ranges[i]->lower : ranges[i]->at(random.uniform());
}

/// 0 to count - 1 in a random order.
std::vector<std::size_t> shuffled(std::size_t count, Random& random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.index(i)]);
  return order;
}

/// Moves one point into each of the part's cells of each range. The cells of different ranges are combined at random
/// (Latin hypercube).
void spread_over_ranges(const Ranges& ranges, std::vector<Point>& points, Random& random, std::size_t cells,
                        Part part) {
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!ranges[i] || ranges[i]->fixed()) continue;
    const std::vector<std::size_t> order = shuffled(points.size(), random);
    for (std::size_t j = 0; j < points.size(); ++j) {
      const double fraction = (static_cast<double>(part.index + order[j] * part.of) + random.uniform()) /
                              static_cast<double>(cells);
      points[j][i] = ranges[i]->at(fraction);
    }
  }
}

/// Sets every other position to the value of the position number `changed`.
void tie_positions(const Quantity& quantity, Point& point, std::size_t changed) {
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (i != changed && is_position(quantity.arguments[i].kind))
      point[i] = into_domain(quantity.arguments[i].kind, point[changed]);
  }
}

Point draw_point_of_domain(const Quantity& quantity, Random& random) {
  if (quantity.draw) return quantity.draw(random);
  Point point;
  std::optional<double> earlier_position;
  for (const Argument& argument : quantity.arguments) {
    const bool related = earlier_position && is_position(argument.kind);
    const double value = related ? related_position(*earlier_position, random) : draw(argument.kind, random);
    point.push_back(into_domain(argument.kind, value));
    if (is_position(argument.kind)) earlier_position = point.back();
  }
  return point;
}

}  // namespace

double draw(ArgumentKind kind, Random& random) {
  if (is_position(kind)) return draw_position(random);
  return spread(kind, random.uniform());
}

Point draw_point(const Quantity& quantity, const Ranges& ranges, Random& random) {
  Point point = draw_point_of_domain(quantity, random);
  into_ranges(ranges, point, random);
  return point;
}

std::vector<Point> thinned(std::vector<Point> points, std::size_t limit) {
  if (points.size() <= limit) return points;
  std::vector<Point> kept;
  for (std::size_t i = 0; i < limit; ++i) kept.push_back(std::move(points[i * points.size() / limit]));
  return kept;
}

std::vector<Point> Part::taken(const std::vector<Point>& points) const {
  std::vector<Point> some;
  for (std::size_t i = index; i < points.size(); i += of) some.push_back(points[i]);
  return some;
}

std::vector<Point> hard_points(const Quantity& quantity, const Ranges& ranges, Random& random) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < quantity.arguments.size(); ++i) {
    const Argument& argument = quantity.arguments[i];
    std::vector<double> values = argument.hard_values;
    if (has_range(ranges, i)) {
      std::erase_if(values, [&](double value) { return !ranges[i]->contains(value); });
      values.insert(values.begin(), {ranges[i]->lower, ranges[i]->upper});
    }
    for (const double value : values) {
      Point point = draw_point(quantity, ranges, random);
      point[i] = value;
      points.push_back(point);
      if (!is_position(argument.kind)) continue;
      tie_positions(quantity, point, i);
      if (point != points.back() && contains(ranges, point)) points.push_back(point);
    }
  }
  return points;
}

std::vector<Point> round_points(const Quantity& quantity, const Ranges& ranges, Random& random) {
  constexpr int quarters = 200;
  std::vector<Point> points;
  for (std::size_t i = 0; i < quantity.arguments.size(); ++i) {
    if (!is_position(quantity.arguments[i].kind)) continue;
    for (int k = -quarters; k <= quarters; ++k) {
      Point point = draw_point(quantity, ranges, random);
      point[i] = k / 4.0;
      if (k != 0 && contains(ranges, point)) points.push_back(std::move(point));
    }
  }
  return points;
}

std::vector<Point> dense_points(const Quantity& quantity, const Ranges& ranges, std::size_t count,
                                Random& random, Part part) {
  if (quantity.draw && ranges.empty()) return random_points(quantity, ranges, part.size(count), random);
  std::vector<Point> points;
  points.reserve(part.size(count));
  const ArgumentKind kind = quantity.arguments.front().kind;
  for (std::size_t cell = part.index; cell < count; cell += part.of) {
    Point point = draw_point(quantity, ranges, random);
    if (!quantity.draw && !has_range(ranges, 0)) {
      const double value =
          spread(kind, (static_cast<double>(cell) + random.uniform()) / static_cast<double>(count));
      point.front() = is_position(kind) ? with_random_sign(value, random) : value;
    }
    points.push_back(std::move(point));
  }
  spread_over_ranges(ranges, points, random, count, part);
  return points;
}

Point kept_off(const Quantity& quantity, const Ranges& ranges, Point point) {
  if (!quantity.keep_off) return point;
  Point moved = point;
  quantity.keep_off(moved);
  return contains(ranges, moved) ? moved : point;
}

std::vector<Point> random_points(const Quantity& quantity, const Ranges& ranges, std::size_t count,
                                 Random& random) {
  std::vector<Point> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(kept_off(quantity, ranges, draw_point(quantity, ranges, random)));
  return points;
}

Point perturbed(const Quantity& quantity, const Ranges& ranges, const Point& point, Random& random) {
  Point moved = point;
  const std::size_t i = random.index(point.size());
  const ArgumentKind kind = quantity.arguments[i].kind;
  double value = point[i];
  if (kind == ArgumentKind::index) {
    value += random.uniform(-20, 20);
  } else if (kind == ArgumentKind::choice) {
    value = std::fmod(value + 1, static_cast<double>(quantity.arguments[i].choices.size()));
  } else if (value != 0 && random.chance(0.3)) {
    value = neighbour(value, static_cast<int>(random.index(9)) - 4);
  } else {
    value *= 1 + std::ldexp(random.uniform(-1, 1), -static_cast<int>(2 + random.index(48)));
  }
  moved[i] = into_domain(kind, value);
  if (has_range(ranges, i)) moved[i] = std::clamp(moved[i], ranges[i]->lower, ranges[i]->upper);
  return kept_off(quantity, ranges, std::move(moved));
}

}  // namespace nipref::verify
