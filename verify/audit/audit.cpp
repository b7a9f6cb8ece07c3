#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/audit/internal/sampling.hpp>
#include <nipref/verify/audit/internal/zeros.hpp>
#include <nipref/verify/catalogue/deviation.hpp>
#include <nipref/verify/catalogue/ulp.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {
namespace {

constexpr std::size_t starts_of_search = 8;
// Shares of the points asked for.
constexpr double share_of_hard = 0.5;  // at most
constexpr double share_of_zeros = 0.1;
constexpr double share_of_dense = 0.15;
constexpr double share_of_search = 0.1;

struct Finding {
  double ulps;
  double allowance_used;
};

class Judge {
 public:
  Judge(const Quantity& quantity, fast::Accuracy accuracy) : quantity_(quantity), accuracy_(accuracy) {}

  [[nodiscard]] Finding operator()(const Point& point) const {
    const double value = fast_value(quantity_, point, accuracy_);
    const Deviation found =
        deviation(value, ref_value(quantity_, point, digits_beyond_double), quantity_.envelope(point));
    return {found.ulps, found.ulps / std::max(quantity_.promise, tolerated_ulps(found.scale))};
  }

 private:
  [[nodiscard]] double tolerated_ulps(double scale) const {
    return accuracy_.rtol() > fast::Accuracy::best_rtol ? accuracy_.rtol() * (scale / ulp_of(scale)) : 0;
  }

  const Quantity& quantity_;
  fast::Accuracy accuracy_;
};

std::vector<Point> candidates(const Quantity& quantity, std::size_t wanted) {
  Random random("audit " + quantity.name);
  const auto share = [wanted](double part) {
    return static_cast<std::size_t>(part * static_cast<double>(wanted));
  };
  std::vector<Point> points = thinned(hard_points(quantity, random), share(share_of_hard));
  const auto append = [&points](std::vector<Point> more) {
    points.insert(points.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  append(zero_points(quantity, share(share_of_zeros), random));
  append(dense_points(quantity, share(share_of_dense), random));
  const std::size_t planned = points.size() + share(share_of_search);
  if (planned < wanted) append(random_points(quantity, wanted - planned, random));
  return points;
}

/// A value that is no number counts as an infinite error (see Deviation), so that this orders all findings.
bool worse(const Finding& a, const Finding& b) { return a.allowance_used > b.allowance_used; }

/// Numbers of the worst few findings, the worst first.
std::vector<std::size_t> worst_few(const std::vector<Finding>& findings) {
  std::vector<std::size_t> order(findings.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t few = std::min(starts_of_search, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(few), order.end(),
                    [&](std::size_t a, std::size_t b) {
                      if (worse(findings[a], findings[b])) return true;
                      return !worse(findings[b], findings[a]) && a < b;
                    });
  order.resize(few);
  return order;
}

struct Climb {
  Point point;
  Finding finding;
};

/// Hill climbing: a step is taken when it finds a worse point.
Climb climb(const Quantity& quantity, const Judge& judge, Climb best, std::size_t steps, std::size_t start) {
  Random random(fmt::format("search {} {}", quantity.name, start));
  for (std::size_t step = 0; step < steps; ++step) {
    stop_if_interrupted();
    Point next = perturbed(quantity, best.point, random);
    const Finding finding = judge(next);
    if (worse(finding, best.finding)) best = {std::move(next), finding};
  }
  return best;
}

double mean_ulps(const std::vector<Finding>& findings) {
  const double sum =
      std::accumulate(findings.begin(), findings.end(), 0.0,
                      [](double total, const Finding& finding) { return total + finding.ulps; });
  return sum / static_cast<double>(findings.size());
}

}  // namespace

std::size_t AuditOptions::points_of(const Quantity& quantity) const {
  if (points > 0) return points;
  return static_cast<std::size_t>(
      std::max(1.0, std::round(density * static_cast<double>(quantity.audit_points))));
}

AuditResult audit(const Quantity& quantity, const AuditOptions& options) {
  const Judge judge(quantity, options.accuracy);
  const std::size_t wanted = options.points_of(quantity);
  const std::vector<Point> points = candidates(quantity, wanted);
  std::vector<Finding> findings(points.size());
  parallel_for(
      points.size(), [&](std::size_t i) { findings[i] = judge(points[i]); }, options.progress);

  const std::vector<std::size_t> starts = worst_few(findings);
  const std::size_t steps =
      static_cast<std::size_t>(share_of_search * static_cast<double>(wanted)) / starts_of_search;
  std::vector<Climb> climbs;
  for (const std::size_t start : starts) climbs.push_back({points[start], findings[start]});
  parallel_for(climbs.size(), [&](std::size_t i) { climbs[i] = climb(quantity, judge, climbs[i], steps, i); },
               {});

  AuditResult result{&quantity, points.size() + steps * climbs.size(), 0, mean_ulps(findings), 0, {}};
  Finding worst{0, -1};
  for (const Finding& finding : findings) result.max_error_ulp = std::max(result.max_error_ulp, finding.ulps);
  for (const Climb& found : climbs) {
    result.max_error_ulp = std::max(result.max_error_ulp, found.finding.ulps);
    if (!worse(found.finding, worst)) continue;
    worst = found.finding;
    result.worst = found.point;
  }
  result.allowance_used = worst.allowance_used;
  return result;
}

}  // namespace nipref::verify
