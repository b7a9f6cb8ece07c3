#include <nipref/verify/audit/internal/sampling.hpp>
#include <nipref/verify/audit/internal/stored.hpp>
#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/internal/parallel.hpp>
#include <nipref/verify/support/sha256.hpp>

namespace nipref::verify {
namespace {

// Shares of the points asked for.
constexpr double share_of_hard = 0.5;  // at most
constexpr double share_of_zeros = 0.1;
constexpr double share_of_round = 0.05;
constexpr double share_of_dense = 0.15;
constexpr double share_of_search = 0.1;

/// The block of a quantity whose own number of points is less than a usual block: its points are slow, and a process
/// that is killed loses one block.
constexpr std::size_t slow_block = 64;

constexpr std::size_t most_starts = 8;
constexpr std::size_t least_steps = 200;  // for each start, unless there is only one

std::size_t share(double part, std::size_t points) {
  return static_cast<std::size_t>(part * static_cast<double>(points));
}

/// All findings are ordered, since a value that is no number counts as an infinite error (see Deviation).
bool is_worse(const Finding& a, const Finding& b) { return a.allowance_used > b.allowance_used; }

void include(AuditTally& tally, const Finding& finding) {
  tally.max_error_ulp = std::max(tally.max_error_ulp, finding.ulps);
  tally.max_relative_error = std::max(tally.max_relative_error, finding.relative);
  if (finding.allowance_used <= tally.allowance_used) return;
  tally.allowance_used = finding.allowance_used;
  tally.worst = finding.point;
  tally.worst_ulp = finding.ulps;
}

/// The tally of findings at `points` points. Points without a finding are left out.
AuditTally tally_of(const std::vector<Finding>& findings, std::size_t points) {
  AuditTally tally{.points = findings.size(), .left_out = points - findings.size()};
  for (const Finding& finding : findings) {
    tally.errors.add(finding.ulps);
    include(tally, finding);
  }
  return tally;
}

/// The findings at the points, compared in batches on all cores.
std::vector<Finding> compared(const Comparator& comparator, std::span<const Point> points,
                              const OnProgress& on_progress) {
  // Few enough points to divide the work evenly between threads, and enough for vector instructions.
  const std::size_t batch = std::clamp<std::size_t>(points.size() / 64, 16, 64);
  const auto of_batch = [&](std::size_t i) {
    return comparator(points.subspan(i * batch, std::min(batch, points.size() - i * batch)));
  };
  std::vector<Finding> findings;
  for (auto& found : parallel_mapped((points.size() + batch - 1) / batch, of_batch, on_progress))
    std::ranges::move(found, std::back_inserter(findings));
  return findings;
}

/// The worst findings, from which a local search of so many points starts.
std::vector<Finding> starts_of_search(std::vector<Finding> findings, std::size_t points) {
  const std::size_t most = std::clamp<std::size_t>(points / least_steps, 1, most_starts);
  std::ranges::stable_sort(findings, is_worse);
  findings.resize(std::min(findings.size(), most));
  return findings;
}

AuditResult result_of(const Quantity& quantity, const AuditOptions& options, const AuditTally& tally,
                      const std::vector<Finding>& kept) {
  return {tally, &quantity, options.promise_of(quantity),
          kept.empty() ? ErrorSpread() : error_spread(quantity, kept)};
}

}  // namespace

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

QuantityWork::QuantityWork(const Quantity& quantity, AuditOptions options, bool keeps_points,
                           Evaluator evaluator)
    : quantity_(quantity),
      options_(std::move(options)),
      comparator_(quantity, std::move(evaluator), options_),
      keeps_points_(keeps_points),
      blocks_(options_.points_of(quantity), quantity.audit_points < points_of_block
                                                ? std::min(slow_block, options_.block)
                                                : options_.block),
      dense_(share(share_of_dense, blocks_.items)) {}

const std::vector<Point>& QuantityWork::listed() const {
  if (listed_) return *listed_;
  const std::size_t wanted = blocks_.items;
  const Ranges& ranges = options_.ranges;
  Random random(fmt::format("{}/{}/listed", options_.seed, quantity_.drawn_for()));
  listed_ = thinned(hard_points(quantity_, ranges, random), share(share_of_hard, wanted));
  std::ranges::move(zero_points(quantity_, ranges, share(share_of_zeros, wanted), random),
                    std::back_inserter(*listed_));
  std::ranges::move(thinned(round_points(quantity_, ranges, random), share(share_of_round, wanted)),
                    std::back_inserter(*listed_));
  return *listed_;
}

std::size_t QuantityWork::searched(std::size_t block) const {
  return options_.search ? share(share_of_search, blocks_.size(block)) : 0;
}

std::string QuantityWork::seed(std::size_t block) const {
  return fmt::format("{}/{}/block/{}", options_.seed, quantity_.drawn_for(), block);
}

std::vector<Point> QuantityWork::points(std::size_t block) const {
  const Part part{block, blocks_.count};
  Random random(seed(block));
  std::vector<Point> points = part.taken(listed());
  const auto append = [&](std::vector<Point> more) { std::ranges::move(more, std::back_inserter(points)); };
  append(dense_points(quantity_, options_.ranges, dense_, random, part));
  const std::size_t planned = points.size() + searched(block);
  if (planned < blocks_.size(block))
    append(random_points(quantity_, options_.ranges, blocks_.size(block) - planned, random));
  append(part.taken(options_.more_points));
  return points;
}

std::string QuantityWork::inputs() const {
  std::string text = fmt::format("{} {} {} {} {} {}\n", sampler_version, blocks_.items, blocks_.count, dense_,
                                 options_.search, options_.seed);
  for (const auto* const list : {&listed(), &options_.more_points}) {
    for (const Point& point : *list) {
      for (const double number : point) text += fmt::format("{:a} ", number);
      text += '\n';
    }
  }
  return sha256(text);
}

Finding QuantityWork::climbed(Finding best, std::size_t steps, const std::string& seed) const {
  Random random(seed);
  for (std::size_t step = 0; step < steps; ++step) {
    stop_if_interrupted();
    const Point next = perturbed(quantity_, options_.ranges, best.point, random);
    for (const Finding& found : comparator_({&next, 1}))
      if (is_worse(found, best)) best = found;
  }
  return best;
}

Json QuantityWork::do_block(std::size_t block, const OnProgress& on_progress) {
  const std::vector<Point> points = this->points(block);
  std::vector<Finding> findings = compared(comparator_, points, on_progress);
  AuditTally tally = tally_of(findings, points.size());
  const std::vector<Finding> starts = starts_of_search(findings, searched(block));
  const std::size_t steps = starts.empty() ? 0 : searched(block) / starts.size();
  const auto climb = [&](std::size_t i) {
    return climbed(starts[i], steps, fmt::format("{}/search/{}", seed(block), i));
  };
  for (const Finding& found : parallel_mapped(starts.size(), climb)) include(tally, found);
  tally.points += steps * starts.size();
  if (keeps_points_) std::ranges::move(findings, std::back_inserter(kept_));
  sum_.add(tally, block);
  return stored(tally);
}

void QuantityWork::add(std::size_t block, const Json& found) {
  const auto tally = restored<AuditTally>(found);
  if (tally.worst.size() != quantity_.arguments.size() && tally.errors.count() > 0) throw JsonMisfit("worst");
  sum_.add(tally, block);
}

AuditResult QuantityWork::result() const {
  if (sum_.errors.count() == 0)
    static_cast<void>(ref_value(quantity_, points(0).front(), digits_beyond_double));
  return result_of(quantity_, options_, sum_, kept_);
}

AuditResult audit_values(const Quantity& quantity, std::span<const Point> points,
                         std::span<const double> values, const AuditOptions& options) {
  const Comparator comparator(
      quantity, [](auto, auto) {}, options);
  const auto compared = parallel_mapped(
      points.size(), [&](std::size_t i) { return comparator(points[i], values[i]); }, options.progress);
  std::vector<Finding> findings;
  for (const auto& found : compared)
    if (found) findings.push_back(*found);
  if (findings.empty()) static_cast<void>(ref_value(quantity, points.front(), digits_beyond_double));
  return result_of(quantity, options, tally_of(findings, points.size()), findings);
}

}  // namespace nipref::verify
