#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <mutex>
#include <set>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/closest_name.hpp>
#include <nipref/verify/grade/internal/answers.hpp>
#include <nipref/verify/grade/kernel.h>
#include <nipref/verify/grade/plugin.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;
using protocol::Message;
using protocol::Noticed;
using protocol::Request;

/// A new process takes a few milliseconds. So many crashes in a row are not a small region of the domain.
constexpr std::size_t most_deaths = 2000, most_deaths_in_a_row = 400;
/// Each hang takes the time limit at least twice, until its point is found.
constexpr std::size_t most_hangs = 6;

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

HostOrders orders_of(const Plugin& plugin) {
  HostOrders orders{plugin.file, {}, 0, 0, plugin.time_limit};
  if (plugin.function) {
    orders.symbol = plugin.function->symbol;
    orders.arity = static_cast<std::uint32_t>(plugin.function->arity);
    orders.flags = plugin.function->thread_safe ? nipref_kernel_thread_safe : 0;
  }
  return orders;
}

void check(const Plugin& plugin) {
  if (!(plugin.time_limit > 0 && plugin.time_limit <= 1e6))
    throw BadInput("time-limit", plugin.time_limit, "must be more than 0 and at most 1e6 seconds");
  if (plugin.function && (plugin.function->arity == 0 || plugin.function->arity > protocol::most_arguments))
    throw BadInput("arity", fmt::format("{}", plugin.function->arity),
                   fmt::format("must be 1 to {}", protocol::most_arguments));
}

/// The result of `read` for an answer, or the end of the process. An answer that is too short does not come from the
/// host.
template <class Read>
auto taken(Child::Answer answer, const Read& read)
    -> std::variant<std::invoke_result_t<Read, Message&>, Death> {
  if (Death* const death = std::get_if<Death>(&answer)) return std::move(*death);
  try {
    return read(std::get<Message>(answer));
  } catch (const std::length_error&) {
    return Death{FaultKind::protocol, "wrote to a descriptor that is not its own"};
  }
}

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

std::string both_text(double first, double then) { return fmt::format("{} and then {}", first, then); }

}  // namespace

class PluginKernel::Work {
 public:
  Work(Plugin plugin, const std::string& name) : plugin_(std::move(plugin)) {
    const std::vector<KernelInfo> kernels = kernels_of(plugin_);
    const auto found = std::ranges::find(kernels, name, &KernelInfo::name);
    if (found == kernels.end()) refuse_name(kernels, name);
    number_ = static_cast<std::size_t>(found - kernels.begin());
    info_ = *found;
    try_closing();
  }

  [[nodiscard]] const KernelInfo& info() const { return info_; }

  void evaluate(std::span<const Point> points, std::span<double> values) {
    while (!points.empty()) {
      const std::size_t count = std::min(points.size(), protocol::most_points);
      evaluate_batch(points.first(count), values.first(count));
      points = points.subspan(count);
      values = values.subspan(count);
    }
  }

  std::optional<double> seconds(std::span<const Point> points, std::size_t passes) {
    auto child = idle_child();
    if (!child) return std::nullopt;
    const auto answer =
        taken(child->ask(with_points(Message().put(Request::time).put(passes), points, info_.arity)),
              [](Message& message) {
                return std::pair<int, double>{message.take<int>(), message.take<double>()};
              });
    if (std::holds_alternative<Death>(answer)) return std::nullopt;
    const auto& [status, seconds] = std::get<0>(answer);
    if (status != 0) return std::nullopt;
    keep(std::move(child));
    return seconds;
  }

  [[nodiscard]] std::vector<Fault> faults() const {
    const std::scoped_lock lock(mutex_);
    std::vector<Fault> all(faults_.begin(), faults_.end());
    if (not_asked_ > 0)
      all.push_back(
          {FaultKind::given_up,
           {},
           fmt::format("not asked any more after {} processes that ended and {} that hung: {} points have "
                       "no value",
                       deaths_.load(), hangs_.load(), not_asked_.load())});
    return all;
  }

 private:
  using IdleChild = std::unique_ptr<Child>;

  [[noreturn]] void refuse_name(const std::vector<KernelInfo>& kernels, const std::string& name) const {
    std::vector<std::string_view> names;
    for (const KernelInfo& kernel : kernels) names.push_back(kernel.name);
    throw BadInput("kernel", name,
                   fmt::format("{}must be one of those that {} has: {}", data::did_you_mean(name, names),
                               plugin_.file.string(), fmt::join(names, ", ")));
  }

  void record(FaultKind kind, std::optional<Point> point, std::string words) {
    const std::scoped_lock lock(mutex_);
    faults_.insert({kind, std::move(point), std::move(words)});
  }

  void record(const std::vector<Trouble>& troubles, const std::optional<Point>& point,
              const std::string& where = "") {
    for (const Trouble& trouble : troubles) record(trouble.kind, point, trouble.words + where);
  }

  [[nodiscard]] bool given_up() const {
    return unopened_ || deaths_ >= most_deaths || deaths_in_a_row_ >= most_deaths_in_a_row ||
           hangs_ >= most_hangs;
  }

  Trouble count(Death death) {
    ++(death.kind == FaultKind::hang ? hangs_ : deaths_);
    ++deaths_in_a_row_;
    return {death.kind, std::move(death.words)};
  }

  /// A process that has loaded the plugin and opened the kernel; null if this fails.
  IdleChild new_child() {
    auto child = std::make_unique<Child>(orders_of(plugin_));
    const Greeting greeting = greeting_of(plugin_, *child);
    if (number_ >= greeting.kernels.size() || greeting.kernels[number_] != info_)
      throw BadInput("plugin", plugin_.file.string(),
                     "must list the same kernels each time that it is loaded");
    record(troubles_of(greeting.noticed), {}, ", by being loaded");
    return opened(*child) ? std::move(child) : nullptr;
  }

  bool opened(Child& child) {
    auto answer = taken(child.ask(Message().put(Request::open).put(number_)), [](Message& message) {
      return std::pair<Noticed, int>{message.take<Noticed>(), message.take<int>()};
    });
    if (Death* const death = std::get_if<Death>(&answer)) return open_failed(count(std::move(*death)));
    const auto& [noticed, status] = std::get<0>(answer);
    record(troubles_of(noticed), {}, ", in open");
    if (status != 0) return open_failed({FaultKind::refused, fmt::format("returns {}", status)});
    return true;
  }

  bool open_failed(const Trouble& trouble) {
    record({trouble}, {}, ", in open");
    unopened_ = true;
    return false;
  }

  /// Opens and closes the kernel before it is used.
  void try_closing() {
    IdleChild child = new_child();
    if (!child) return;
    auto answer = taken(child->ask(Message().put(Request::close)),
                        [](Message& message) { return message.take<Noticed>(); });
    if (Death* const death = std::get_if<Death>(&answer)) {
      record({count(std::move(*death))}, {}, ", in close");
      return;
    }
    record(troubles_of(std::get<Noticed>(answer)), {}, ", in close");
    if (opened(*child)) keep(std::move(child));
  }

  IdleChild idle_child() {
    {
      const std::scoped_lock lock(mutex_);
      if (!idle_.empty()) {
        IdleChild child = std::move(idle_.back());
        idle_.pop_back();
        return child;
      }
    }
    return given_up() ? nullptr : new_child();
  }

  void keep(IdleChild child) {
    const std::scoped_lock lock(mutex_);
    idle_.push_back(std::move(child));
  }

  Outcome call(std::span<const Point> points) {
    IdleChild child = idle_child();
    if (!child) return {};
    auto answer = taken(child->ask(with_points(Message().put(Request::evaluate), points, info_.arity)),
                        [&](Message& message) { return read_outcome(message, points.size()); });
    if (Death* const death = std::get_if<Death>(&answer)) return {.troubles = {count(std::move(*death))}};
    keep(std::move(child));
    deaths_in_a_row_ = 0;
    return std::get<Outcome>(std::move(answer));
  }

  void evaluate_batch(std::span<const Point> points, std::span<double> values) {
    std::ranges::fill(values, no_value);
    if (given_up()) {
      not_asked_ += points.size();
      return;
    }
    const Outcome outcome = call(points);
    if (outcome.troubles.empty() || points.size() == 1) {
      record(outcome.troubles, points.front());
      take(outcome, points, values);
    } else {
      one_by_one(points, values);
    }
  }

  /// Evaluates the points of a batch with faults one at a time.
  void one_by_one(std::span<const Point> points, std::span<double> values) {
    bool found = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (given_up()) {
        not_asked_ += points.size() - i;
        return;
      }
      const Outcome outcome = call(points.subspan(i, 1));
      found = found || !outcome.troubles.empty();
      record(outcome.troubles, points[i]);
      take(outcome, points.subspan(i, 1), values.subspan(i, 1));
    }
    if (!found) narrow(points);
  }

  /// Finds the smallest part of a batch that has the faults, if no single point has them.
  void narrow(std::span<const Point> points) {
    std::vector<Trouble> troubles;
    for (bool smaller = true; smaller;) {
      smaller = false;
      for (const auto half : {points.first(points.size() / 2), points.subspan(points.size() / 2)}) {
        if (half.empty() || given_up()) continue;
        Outcome outcome = call(half);
        if (outcome.troubles.empty()) continue;
        troubles = std::move(outcome.troubles);
        points = half;
        smaller = points.size() > 1;
        break;
      }
    }
    if (troubles.empty()) troubles = call(points).troubles;
    record(troubles, points.front(),
           fmt::format(", in a batch of {} points, of which this is the first", points.size()));
  }

  /// Stores the values and records their faults.
  void take(const Outcome& outcome, std::span<const Point> points, std::span<double> values) {
    if (!outcome.has_values) return;
    for (std::size_t i = 0; i < points.size(); ++i) {
      values[i] = outcome.values[i];
      assess(points[i], outcome.values[i], outcome.permuted[i], outcome.threaded[i]);
    }
  }

  void assess(const Point& point, double value, double permuted, double threaded) {
    if (bits(value) == protocol::unwritten_bits)
      return record(FaultKind::unwritten, point, "no value is written");
    if (!std::isfinite(value)) record(FaultKind::not_finite, point, fmt::format("the value is {}", value));
    if (bits(permuted) != bits(value))
      record(FaultKind::order, point, "in another order of points: " + both_text(value, permuted));
    if (bits(threaded) != bits(value))
      record(FaultKind::threads, point, "from several threads: " + both_text(value, threaded));
  }

  /// The words do not distinguish faults at the same point, as they may contain changing values.
  struct Before {
    bool operator()(const Fault& a, const Fault& b) const {
      if (a.kind != b.kind) return a.kind < b.kind;
      return a.point != b.point ? a.point < b.point : !a.point && a.words < b.words;
    }
  };

  Plugin plugin_;
  std::size_t number_ = 0;
  KernelInfo info_;
  std::atomic<std::size_t> deaths_ = 0, deaths_in_a_row_ = 0, hangs_ = 0, not_asked_ = 0;
  std::atomic<bool> unopened_ = false;
  mutable std::mutex mutex_;
  std::vector<IdleChild> idle_;
  std::set<Fault, Before> faults_;
};

std::vector<KernelInfo> kernels_of(const Plugin& plugin) {
  check(plugin);
  Child child(orders_of(plugin));
  return greeting_of(plugin, child).kernels;
}

PluginKernel::PluginKernel(Plugin plugin, const std::string& name)
    : work_(std::make_unique<Work>(std::move(plugin), name)) {}

PluginKernel::~PluginKernel() = default;

const KernelInfo& PluginKernel::info() const { return work_->info(); }

void PluginKernel::evaluate(std::span<const Point> points, std::span<double> values) {
  work_->evaluate(points, values);
}

Evaluator PluginKernel::evaluator() {
  return [this](std::span<const Point> points, std::span<double> values) { evaluate(points, values); };
}

std::optional<double> PluginKernel::seconds(std::span<const Point> points, std::size_t passes) {
  return work_->seconds(points, passes);
}

std::vector<Fault> PluginKernel::faults() const { return work_->faults(); }

}  // namespace nipref::verify
