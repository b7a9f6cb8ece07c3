#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <nipref/data/bad_input.hpp>
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
constexpr double share_of_round = 0.05;
constexpr double share_of_dense = 0.15;
constexpr double share_of_search = 0.1;

/// Few enough that the threads have equally much to do, many enough that a batch is one.
constexpr std::size_t batch = 64;

/// Compares with the reference.
class Judge {
 public:
  Judge(const Quantity& quantity, const Evaluator& evaluator, const AuditOptions& options, bool may_refuse,
        bool is_fast = false)
      : quantity_(quantity),
        evaluator_(evaluator),
        accuracy_(options.accuracy),
        promise_(options.promise_of(quantity)),
        may_refuse_(may_refuse),
        says_more_(is_fast && quantity.fast_error) {}

  /// Findings at a batch of points; none where the reference refuses a point of the ranges.
  void operator()(std::span<const Point> points, std::span<std::optional<Finding>> findings) const {
    std::vector<std::optional<Reference>> truths;
    std::vector<Point> known;
    for (const Point& point : points) {
      truths.push_back(truth(point));
      if (truths.back()) known.push_back(point);
    }
    std::vector<double> values(known.size());
    evaluator_(known, values);
    for (std::size_t i = 0, next = 0; i < points.size(); ++i) {
      if (truths[i]) findings[i] = finding(values[next++], *truths[i], points[i]);
    }
  }

  [[nodiscard]] std::optional<Finding> operator()(const Point& point) const {
    std::optional<Finding> finding;
    (*this)({&point, 1}, {&finding, 1});
    return finding;
  }

  /// Of a value that is there already.
  [[nodiscard]] std::optional<Finding> operator()(const Point& point, double value) const {
    const auto known = truth(point);
    return known ? std::optional(finding(value, *known, point)) : std::nullopt;
  }

 private:
  [[nodiscard]] std::optional<Reference> truth(const Point& point) const {
    try {
      return ref_value(quantity_, point, digits_beyond_double);
    } catch (const data::BadInput&) {
      if (!may_refuse_) throw;
      return std::nullopt;
    }
  }

  [[nodiscard]] Finding finding(double value, const Reference& truth, const Point& point) const {
    const Deviation found = deviation(value, truth, quantity_.envelope(point));
    return {found.ulps, found.relative, found.ulps == 0 ? 0 : found.ulps / allowed_ulps(found.scale, point)};
  }

  [[nodiscard]] double allowed_ulps(double scale, const Point& point) const {
    const double allowed = std::max(promise_, tolerated_ulps(scale));
    return says_more_ ? std::min(allowed, quantity_.fast_error(point, accuracy_) / ulp_of(scale)) : allowed;
  }

  [[nodiscard]] double tolerated_ulps(double scale) const {
    return accuracy_.rtol() > fast::Accuracy::best_rtol ? accuracy_.rtol() * (scale / ulp_of(scale)) : 0;
  }

  const Quantity& quantity_;
  const Evaluator& evaluator_;
  fast::Accuracy accuracy_;
  double promise_;
  bool may_refuse_;
  bool says_more_;
};

/// The points that the reference knows, with what is found at them.
struct Compared {
  std::vector<Point> points;
  std::vector<Finding> findings;
  std::size_t left_out = 0;
};

/// BadInput, of the first point, if there is none.
Compared compared_of(const Quantity& quantity, std::vector<Point> points,
                     const std::vector<std::optional<Finding>>& findings) {
  if (std::ranges::none_of(findings, [](const auto& finding) { return finding.has_value(); }))
    static_cast<void>(ref_value(quantity, points.front(), digits_beyond_double));
  Compared compared;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!findings[i]) continue;
    compared.points.push_back(std::move(points[i]));
    compared.findings.push_back(*findings[i]);
  }
  compared.left_out = points.size() - compared.points.size();
  return compared;
}

Compared compare(const Quantity& quantity, std::vector<Point> points, const Judge& judge,
                 const AuditOptions& options) {
  std::vector<std::optional<Finding>> findings(points.size());
  const auto of_batch = [&](std::size_t i) {
    const std::size_t first = i * batch, count = std::min(batch, points.size() - first);
    judge(std::span(points).subspan(first, count), std::span(findings).subspan(first, count));
  };
  const auto progress = [&](std::size_t done) { options.progress(done * batch); };
  parallel_for((points.size() + batch - 1) / batch, of_batch,
               options.progress ? std::function<void(std::size_t)>(progress) : nullptr);
  return compared_of(quantity, std::move(points), findings);
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
Climb climb(const Quantity& quantity, const AuditOptions& options, const Judge& judge, Climb best,
            std::size_t steps, std::size_t start) {
  Random random(fmt::format("search {}{} {}", quantity.drawn_for(), options.seed, start));
  for (std::size_t step = 0; step < steps; ++step) {
    stop_if_interrupted();
    Point next = perturbed(quantity, options.ranges, best.point, random);
    const auto finding = judge(next);
    if (finding && worse(*finding, best.finding)) best = {std::move(next), *finding};
  }
  return best;
}

/// From the worst few; their ends.
std::vector<Climb> climbs_from(const Compared& compared, const Quantity& quantity, const Judge& judge,
                               const AuditOptions& options, std::size_t steps) {
  std::vector<Climb> climbs;
  for (const std::size_t start : worst_few(compared.findings))
    climbs.push_back({compared.points[start], compared.findings[start]});
  parallel_for(
      climbs.size(),
      [&](std::size_t i) { climbs[i] = climb(quantity, options, judge, std::move(climbs[i]), steps, i); },
      {});
  return climbs;
}

AuditResult result_of(const Quantity& quantity, const Compared& compared, const AuditOptions& options,
                      const std::vector<Climb>& climbs, std::size_t steps) {
  AuditResult result{.quantity = &quantity,
                     .points = compared.points.size() + steps * climbs.size(),
                     .left_out = compared.left_out,
                     .promise = options.promise_of(quantity),
                     .max_error_ulp = 0,
                     .max_relative_error = 0,
                     .allowance_used = -1,
                     .worst = {},
                     .spread = error_spread(quantity, compared.points, compared.findings)};
  const auto include = [&](const Finding& finding, const Point& point) {
    result.max_error_ulp = std::max(result.max_error_ulp, finding.ulps);
    result.max_relative_error = std::max(result.max_relative_error, finding.relative);
    if (finding.allowance_used <= result.allowance_used) return;
    result.allowance_used = finding.allowance_used;
    result.worst = point;
    result.worst_ulp = finding.ulps;
  };
  for (const Climb& found : climbs) include(found.finding, found.point);
  for (std::size_t i = 0; i < compared.points.size(); ++i) include(compared.findings[i], compared.points[i]);
  return result;
}

}  // namespace

Evaluator fast_evaluator(const Quantity& quantity, fast::Accuracy accuracy) {
  return [&quantity, accuracy](std::span<const Point> points, std::span<double> values) {
    std::ranges::transform(points, values.begin(),
                           [&](const Point& point) { return fast_value(quantity, point, accuracy); });
  };
}

std::size_t AuditOptions::points_of(const Quantity& quantity) const {
  if (points > 0) return points;
  return static_cast<std::size_t>(
      std::max(1.0, std::round(density * static_cast<double>(quantity.audit_points))));
}

std::vector<Point> audit_points(const Quantity& quantity, const AuditOptions& options) {
  const std::size_t wanted = options.points_of(quantity);
  const Ranges& ranges = options.ranges;
  Random random("audit " + quantity.drawn_for() + options.seed);
  const auto share = [wanted](double part) {
    return static_cast<std::size_t>(part * static_cast<double>(wanted));
  };
  std::vector<Point> points = thinned(hard_points(quantity, ranges, random), share(share_of_hard));
  const auto append = [&points](std::vector<Point> more) {
    points.insert(points.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  append(zero_points(quantity, ranges, share(share_of_zeros), random));
  append(thinned(round_points(quantity, ranges, random), share(share_of_round)));
  append(dense_points(quantity, ranges, share(share_of_dense), random));
  const std::size_t planned = points.size() + (options.search ? share(share_of_search) : 0);
  if (planned < wanted) append(random_points(quantity, ranges, wanted - planned, random));
  append(options.more_points);
  return points;
}

namespace {

AuditResult audit_of(const Quantity& quantity, const Evaluator& evaluator, const AuditOptions& options,
                     bool is_fast) {
  const Judge judge(quantity, evaluator, options, !options.ranges.empty(), is_fast);
  const Compared compared = compare(quantity, audit_points(quantity, options), judge, options);
  const std::size_t steps =
      static_cast<std::size_t>(share_of_search * static_cast<double>(options.points_of(quantity))) /
      starts_of_search;
  return result_of(quantity, compared, options, climbs_from(compared, quantity, judge, options, steps),
                   steps);
}

}  // namespace

AuditResult audit(const Quantity& quantity, const Evaluator& evaluator, const AuditOptions& options) {
  return audit_of(quantity, evaluator, options, false);
}

AuditResult audit_values(const Quantity& quantity, std::span<const Point> points,
                         std::span<const double> values, const AuditOptions& options) {
  const Evaluator none;
  const Judge judge(quantity, none, options, true);
  std::vector<std::optional<Finding>> findings(points.size());
  parallel_for(
      points.size(), [&](std::size_t i) { findings[i] = judge(points[i], values[i]); }, options.progress);
  return result_of(quantity, compared_of(quantity, {points.begin(), points.end()}, findings), options, {}, 0);
}

AuditResult audit(const Quantity& quantity, const AuditOptions& options) {
  return audit_of(quantity, fast_evaluator(quantity, options.accuracy), options, true);
}

}  // namespace nipref::verify
