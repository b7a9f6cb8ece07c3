#include <nipref/verify/audit/error_spread.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {
namespace {

/// The first argument that is a number and differs between the points.
std::size_t varied_argument(const Quantity& quantity, std::span<const Finding> findings) {
  for (std::size_t i = 0; i < quantity.arguments.size(); ++i) {
    if (quantity.arguments[i].kind == ArgumentKind::choice) continue;
    const auto differs = [&](const Finding& one) { return one.point[i] != findings.front().point[i]; };
    if (std::ranges::any_of(findings, differs)) return i;
  }
  return 0;
}

std::optional<int> exponent_of(double argument) {
  if (argument == 0) return std::nullopt;
  return static_cast<int>(std::floor(std::log10(std::fabs(argument))));
}

std::vector<Decade> decades_of(std::size_t along, std::span<const Finding> findings) {
  std::map<std::optional<int>, std::vector<double>> errors;  // those without an exponent come first
  std::map<std::optional<int>, std::size_t> above;
  for (const Finding& finding : findings) {
    const auto exponent = exponent_of(finding.point[along]);
    errors[exponent].push_back(finding.ulps);
    if (finding.allowance_used > 1) ++above[exponent];
  }
  std::vector<Decade> decades;
  for (auto& [exponent, sorted] : errors) {
    std::ranges::sort(sorted);
    decades.push_back(
        {exponent, sorted.size(), above[exponent], sorted.back(), sorted[(sorted.size() - 1) / 2]});
  }
  return decades;
}

constexpr std::size_t parts_of_axis = 100;
constexpr std::size_t dots_of_part = 3;

/// Appends the largest error of a part of the axis, and others at equal distances in the list.
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

std::vector<ErrorDot> dots_of(const Quantity& quantity, std::size_t along,
                              std::span<const Finding> findings) {
  const ArgumentKind kind = quantity.arguments[along].kind;
  const auto place = [&](const ErrorDot& dot) { return spans_decades(kind) ? std::log10(dot.at) : dot.at; };
  std::vector<ErrorDot> all;
  for (const Finding& finding : findings)
    if (std::isfinite(finding.ulps))
      all.push_back({place_on_axis(kind, finding.point[along]), finding.ulps, false});
  if (all.empty()) return {};
  const auto [first, last] = std::ranges::minmax_element(all, {}, place);
  const double least = place(*first), width = (place(*last) - least) / parts_of_axis;
  std::vector<std::vector<ErrorDot>> parts(parts_of_axis);
  for (const ErrorDot& dot : all) {
    const double part = width > 0 ? std::floor((place(dot) - least) / width) : 0;
    parts[std::min(static_cast<std::size_t>(part), parts_of_axis - 1)].push_back(dot);
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

std::optional<WrongRegion> wrong_region(std::span<const Finding> findings) {
  std::optional<WrongRegion> region;
  for (const auto& [point, ulps, relative, allowance_used] : findings) {
    if (allowance_used <= 1) continue;
    if (!region) region = {point, point, 0, 0};
    for (std::size_t j = 0; j < point.size(); ++j) {
      region->lower[j] = std::min(region->lower[j], point[j]);
      region->upper[j] = std::max(region->upper[j], point[j]);
    }
    ++region->above;
  }
  if (region)
    region->points = static_cast<std::size_t>(std::ranges::count_if(
        findings, [&](const Point& point) { return is_inside(*region, point); }, &Finding::point));
  return region;
}

}  // namespace

bool spans_decades(ArgumentKind kind) {
  return kind != ArgumentKind::poisson && kind != ArgumentKind::degrees && kind != ArgumentKind::depth;
}

double place_on_axis(ArgumentKind kind, double value) {
  return spans_decades(kind) ? std::clamp(std::fabs(value), 1e-12, 1e12) : value;
}

ErrorSpread error_spread(const Quantity& quantity, std::span<const Finding> findings) {
  const std::size_t along = varied_argument(quantity, findings);
  return {along, decades_of(along, findings), wrong_region(findings), dots_of(quantity, along, findings)};
}

}  // namespace nipref::verify
