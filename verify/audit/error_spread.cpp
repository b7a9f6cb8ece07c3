#include <nipref/verify/audit/error_spread.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {
namespace {

/// The first argument that is a number and differs between the points.
std::size_t varied_argument(const Quantity& quantity, std::span<const Point> points) {
  for (std::size_t i = 0; i < quantity.arguments.size(); ++i) {
    if (quantity.arguments[i].kind == ArgumentKind::choice) continue;
    const auto differs = [&](const Point& point) { return point[i] != points.front()[i]; };
    if (std::ranges::any_of(points, differs)) return i;
  }
  return 0;
}

/// A percentile of sorted errors.
double percentile(std::span<const double> sorted, double share) {
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::clamp(rank, std::size_t{1}, sorted.size()) - 1];
}

std::optional<int> exponent_of(double argument) {
  if (argument == 0) return std::nullopt;
  return static_cast<int>(std::floor(std::log10(std::fabs(argument))));
}

std::vector<Decade> decades_of(std::size_t along, std::span<const Point> points,
                               std::span<const Finding> findings) {
  std::map<std::optional<int>, std::vector<double>> errors;  // those without an exponent come first
  std::map<std::optional<int>, std::size_t> above;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto exponent = exponent_of(points[i][along]);
    errors[exponent].push_back(findings[i].ulps);
    if (findings[i].allowance_used > 1) ++above[exponent];
  }
  std::vector<Decade> decades;
  for (auto& [exponent, of_decade] : errors) {
    std::ranges::sort(of_decade);
    decades.push_back(
        {exponent, of_decade.size(), above[exponent], of_decade.back(), percentile(of_decade, 0.5)});
  }
  return decades;
}

constexpr std::size_t parts_of_axis = 100;
constexpr std::size_t dots_of_part = 3;

struct PlacedError {
  double place;  ///< on the axis
  ErrorDot dot;
};

std::vector<PlacedError> placed_errors(ArgumentKind kind, std::size_t along, std::span<const Point> points,
                                       std::span<const Finding> findings) {
  std::vector<PlacedError> placed;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(findings[i].ulps)) continue;
    const double at = place_on_axis(kind, points[i][along]);
    placed.push_back({spans_decades(kind) ? std::log10(at) : at, {at, findings[i].ulps, false}});
  }
  return placed;
}

/// The largest error, and others at equal distances in their order.
void append_dots(std::vector<ErrorDot>& dots, std::vector<ErrorDot> part) {
  const auto largest = std::ranges::max_element(part, {}, &ErrorDot::ulps);
  largest->largest = true;
  std::vector<ErrorDot> kept{*largest};
  const std::size_t step = std::max<std::size_t>(1, part.size() / (dots_of_part - 1));
  for (std::size_t i = 0; i < part.size() && kept.size() < dots_of_part; i += step)
    if (!part[i].largest) kept.push_back(part[i]);
  std::ranges::sort(kept, {}, &ErrorDot::at);
  std::ranges::copy(kept, std::back_inserter(dots));
}

std::vector<ErrorDot> dots_of(const Quantity& quantity, std::size_t along, std::span<const Point> points,
                              std::span<const Finding> findings) {
  const auto placed = placed_errors(quantity.arguments[along].kind, along, points, findings);
  if (placed.empty()) return {};
  const auto [least, most] = std::ranges::minmax_element(placed, {}, &PlacedError::place);
  const double width = (most->place - least->place) / parts_of_axis;
  std::vector<std::vector<ErrorDot>> parts(parts_of_axis);
  for (const PlacedError& one : placed) {
    const double part = width > 0 ? std::floor((one.place - least->place) / width) : 0;
    parts[std::min(static_cast<std::size_t>(part), parts_of_axis - 1)].push_back(one.dot);
  }
  std::vector<ErrorDot> dots;
  for (auto& part : parts)
    if (!part.empty()) append_dots(dots, std::move(part));
  return dots;
}

bool is_inside(const WrongRegion& region, const Point& point) {
  for (std::size_t i = 0; i < point.size(); ++i)
    if (point[i] < region.lower[i] || point[i] > region.upper[i]) return false;
  return true;
}

std::optional<WrongRegion> wrong_region(std::span<const Point> points, std::span<const Finding> findings) {
  std::optional<WrongRegion> region;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (findings[i].allowance_used <= 1) continue;
    if (!region) region = {points[i], points[i], 0, 0};
    for (std::size_t j = 0; j < points[i].size(); ++j) {
      region->lower[j] = std::min(region->lower[j], points[i][j]);
      region->upper[j] = std::max(region->upper[j], points[i][j]);
    }
    ++region->above;
  }
  if (region) {
    region->points = static_cast<std::size_t>(
        std::ranges::count_if(points, [&](const Point& point) { return is_inside(*region, point); }));
  }
  return region;
}

}  // namespace

bool spans_decades(ArgumentKind kind) {
  return kind != ArgumentKind::poisson && kind != ArgumentKind::degrees && kind != ArgumentKind::depth;
}

double place_on_axis(ArgumentKind kind, double value) {
  return spans_decades(kind) ? std::clamp(std::fabs(value), 1e-12, 1e12) : value;
}

ErrorSpread error_spread(const Quantity& quantity, std::span<const Point> points,
                         std::span<const Finding> findings) {
  const std::size_t along = varied_argument(quantity, points);
  return {along, decades_of(along, points, findings), wrong_region(points, findings),
          dots_of(quantity, along, points, findings)};
}

}  // namespace nipref::verify
