#include <numeric>

#include <nipref/verify/audit/internal/block.hpp>
#include <nipref/verify/audit/internal/sampling.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {
namespace {

constexpr std::size_t most_starts = 8;
constexpr std::size_t least_steps = 200;  // for each start, unless there is only one

Compared compare(std::vector<Point> points, const Comparator& comparator, const OnProgress& on_progress) {
  std::vector<std::optional<Finding>> findings(points.size());
  // Few enough points to divide the work evenly between threads, and enough for vector instructions.
  const std::size_t batch = std::clamp<std::size_t>(points.size() / 64, 16, 64);
  const auto of_batch = [&](std::size_t i) {
    const std::size_t first = i * batch, count = std::min(batch, points.size() - first);
    comparator(std::span(points).subspan(first, count), std::span(findings).subspan(first, count));
  };
  parallel_for((points.size() + batch - 1) / batch, of_batch, on_progress);
  return compared_of(std::move(points), findings);
}

/// All findings are ordered, since a value that is no number counts as an infinite error (see Deviation).
bool worse(const Finding& a, const Finding& b) { return a.allowance_used > b.allowance_used; }

/// The indices of the worst few findings, the worst first.
std::vector<std::size_t> worst_few(const std::vector<Finding>& findings, std::size_t few) {
  std::vector<std::size_t> order(findings.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  few = std::min(few, order.size());
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
Climb climb(const AuditPlan& plan, const Comparator& comparator, Climb best, std::size_t steps,
            const std::string& seed) {
  Random random(seed);
  for (std::size_t step = 0; step < steps; ++step) {
    stop_if_interrupted();
    Point next = perturbed(plan.quantity(), plan.ranges(), best.point, random);
    const auto finding = comparator(next);
    if (finding && worse(*finding, best.finding)) best = {std::move(next), *finding};
  }
  return best;
}

void include(AuditTally& tally, const Finding& finding, const Point& point) {
  tally.max_error_ulp = std::max(tally.max_error_ulp, finding.ulps);
  tally.max_relative_error = std::max(tally.max_relative_error, finding.relative);
  if (finding.allowance_used <= tally.allowance_used) return;
  tally.allowance_used = finding.allowance_used;
  tally.worst = point;
  tally.worst_ulp = finding.ulps;
}

}  // namespace

Compared compared_of(std::vector<Point> points, const std::vector<std::optional<Finding>>& findings) {
  Compared compared;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!findings[i]) continue;
    compared.points.push_back(std::move(points[i]));
    compared.findings.push_back(*findings[i]);
  }
  compared.left_out = points.size() - compared.points.size();
  return compared;
}

AuditTally tally_of(const Compared& compared) {
  AuditTally tally{.points = compared.points.size(), .left_out = compared.left_out};
  for (std::size_t i = 0; i < compared.points.size(); ++i) {
    tally.errors.add(compared.findings[i].ulps);
    include(tally, compared.findings[i], compared.points[i]);
  }
  return tally;
}

AuditTally audit_block(const AuditPlan& plan, const Comparator& comparator, std::size_t block,
                       const OnProgress& on_progress, Compared* kept) {
  const Compared compared = compare(plan.points(block), comparator, on_progress);
  const std::size_t searched = plan.searched(block);
  std::vector<Climb> climbs;
  for (const std::size_t start :
       worst_few(compared.findings, std::clamp<std::size_t>(searched / least_steps, 1, most_starts)))
    climbs.push_back({compared.points[start], compared.findings[start]});
  const std::size_t steps = climbs.empty() ? 0 : searched / climbs.size();
  parallel_for(climbs.size(), [&](std::size_t i) {
    climbs[i] = climb(plan, comparator, std::move(climbs[i]), steps,
                      fmt::format("{}/search/{}", plan.seed(block), i));
  });
  AuditTally tally = tally_of(compared);
  tally.points += steps * climbs.size();
  for (const Climb& found : climbs) include(tally, found.finding, found.point);
  if (kept != nullptr) {
    std::ranges::copy(compared.points, std::back_inserter(kept->points));
    std::ranges::copy(compared.findings, std::back_inserter(kept->findings));
  }
  return tally;
}

AuditResult result_of(const Quantity& quantity, const AuditOptions& options, const AuditTally& tally,
                      const Compared& kept, const Point& first) {
  if (tally.errors.count() == 0) static_cast<void>(ref_value(quantity, first, digits_beyond_double));
  AuditResult result{tally, &quantity, options.promise_of(quantity)};
  if (!kept.points.empty()) result.spread = error_spread(quantity, kept.points, kept.findings);
  return result;
}

void AuditTally::add(const AuditTally& found, std::uint64_t block) {
  points += found.points;
  left_out += found.left_out;
  max_error_ulp = std::max(max_error_ulp, found.max_error_ulp);
  max_relative_error = std::max(max_relative_error, found.max_relative_error);
  errors.add(found.errors);
  if (found.allowance_used < allowance_used) return;
  if (found.allowance_used == allowance_used && block > worst_block) return;
  allowance_used = found.allowance_used;
  worst_block = block;
  worst = found.worst;
  worst_ulp = found.worst_ulp;
}

}  // namespace nipref::verify
