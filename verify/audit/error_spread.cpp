#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <nipref/verify/audit/error_spread.hpp>

namespace nipref::verify {
namespace {

/// The first that is a number and is not the same at all points.
std::size_t varied_argument(const Quantity& quantity, std::span<const Point> points) {
  for (std::size_t i = 0; i < quantity.arguments.size(); ++i) {
    if (quantity.arguments[i].kind == ArgumentKind::choice) continue;
    const auto differs = [&](const Point& point) { return point[i] != points.front()[i]; };
    if (std::ranges::any_of(points, differs)) return i;
  }
  return 0;
}

/// Of sorted errors.
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
  std::map<std::optional<int>, std::vector<double>> errors;  // no exponent comes first
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

bool is_inside(const WrongRegion& region, const Point& point) {
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (point[i] < region.lower[i] || point[i] > region.upper[i]) return false;
  }
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

ErrorSpread error_spread(const Quantity& quantity, std::span<const Point> points,
                         std::span<const Finding> findings) {
  std::vector<double> errors;
  errors.reserve(findings.size());
  for (const Finding& finding : findings) errors.push_back(finding.ulps);
  std::ranges::sort(errors);
  const double sum = std::accumulate(errors.begin(), errors.end(), 0.0);
  const std::size_t along = varied_argument(quantity, points);
  return {sum / static_cast<double>(errors.size()),
          percentile(errors, 0.5),
          percentile(errors, 0.9),
          percentile(errors, 0.99),
          percentile(errors, 0.999),
          along,
          decades_of(along, points, findings),
          wrong_region(points, findings)};
}

}  // namespace nipref::verify
