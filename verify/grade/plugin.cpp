#include <atomic>
#include <bit>
#include <cstring>
#include <mutex>

#include <nipref/data/closest_name.hpp>
#include <nipref/verify/grade/internal/child.hpp>
#include <nipref/verify/grade/kernel.h>
#include <nipref/verify/grade/plugin.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;
using protocol::Exchange;
using protocol::Request;

/// Limits for crashes. A new process takes milliseconds. So many in a row are not due to a small region of the domain.
constexpr std::size_t most_deaths = 2000, most_deaths_in_a_row = 400;
/// The limit for hangs. Each takes the time limit at least twice, until its point is found.
constexpr std::size_t most_hangs = 6;

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// The faults in the order of the bits of protocol::Noticed.
constexpr std::pair<FaultKind, const char*> symptoms[] = {
    {FaultKind::overrun, "touches memory before or behind its output"},
    {FaultKind::overrun, "touches memory before or behind its arguments"},
    {FaultKind::arguments, "writes to its arguments"},
    {FaultKind::environment, "leaves another rounding mode"},
    {FaultKind::environment, "leaves small results flushed to zero (FTZ, as -ffast-math has it)"},
    {FaultKind::environment, "leaves small arguments taken for zero (DAZ, as -ffast-math has it)"},
    {FaultKind::environment, "leaves floating-point exceptions unmasked"},
    {FaultKind::environment, "leaves another precision of the x87 unit"},
    {FaultKind::output, "writes to standard output"}};

/// One fault for each kind among the bits of `noticed`.
std::vector<Fault> faults_of(std::uint32_t noticed) {
  std::vector<Fault> faults;
  for (const auto& [kind, words] : symptoms) {
    const bool is_noticed = (noticed & 1U) != 0;
    noticed >>= 1;
    if (!is_noticed) continue;
    if (faults.empty() || faults.back().kind != kind)
      faults.push_back({kind, {}, words});
    else
      faults.back().words += std::string(" and ") + words;
  }
  return faults;
}

void check(const Plugin& plugin) {
  if (!(plugin.time_limit > 0 && plugin.time_limit <= 1e6))
    throw BadInput("time-limit", plugin.time_limit, "must be more than 0 and at most 1e6 seconds");
  if (plugin.function && (plugin.function->arity == 0 || plugin.function->arity > protocol::most_arguments))
    refuse("arity", fmt::format("{}", plugin.function->arity), "must be 1 to {}", protocol::most_arguments);
}

std::string text_of(std::span<const char> text) { return {text.data(), strnlen(text.data(), text.size())}; }

/// Has the child load the plugin. BadInput that names the file if this fails.
std::vector<KernelInfo> loaded(const Plugin& plugin, Child& child) {
  const auto refuse = [&](const std::string& why) { throw BadInput("plugin", plugin.file.string(), why); };
  if (const auto end = child.ask(Request::load))
    refuse(fmt::format("must be loaded without harm: {}, {}", name_of(end->kind), end->words));
  const Exchange& exchange = child.exchange();
  if (exchange.status != 0) refuse(text_of(exchange.failure));
  std::vector<KernelInfo> kernels;
  for (std::size_t i = 0; i < std::min(exchange.kernels, protocol::most_kernels); ++i) {
    const auto& listed = exchange.kernel_list[i];
    kernels.push_back({text_of(listed.name), text_of(listed.quantity), listed.arity,
                       (listed.flags & nipref_kernel_thread_safe) != 0});
    if (listed.arity == 0 || listed.arity > protocol::most_arguments) kernels.clear();
  }
  if (kernels.empty()) refuse("must not write to memory that is not its own");
  return kernels;
}

/// Writes the points, each of `arity` arguments, into the request.
void put(std::span<const Point> points, std::size_t arity, Exchange& exchange) {
  exchange.points = points.size();
  for (std::size_t j = 0; j < arity; ++j)
    std::ranges::transform(points, exchange.arguments[j].begin(),
                           [j](const Point& point) { return point[j]; });
}

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

class KernelInProcesses : public PluginKernel {
 public:
  KernelInProcesses(Plugin plugin, const std::string& name) : plugin_(std::move(plugin)) {
    const std::vector<KernelInfo> kernels = kernels_of(plugin_);
    const auto found = std::ranges::find(kernels, name, &KernelInfo::name);
    if (found == kernels.end()) refuse_name(kernels, name);
    number_ = static_cast<std::size_t>(found - kernels.begin());
    info_ = *found;
    try_closing();
  }

  [[nodiscard]] const KernelInfo& info() const override { return info_; }

  void evaluate(std::span<const Point> points, std::span<double> values) override {
    while (!points.empty()) {
      const std::size_t count = std::min(points.size(), protocol::most_points);
      evaluate_batch(points.first(count), values.first(count));
      points = points.subspan(count);
      values = values.subspan(count);
    }
  }

  std::optional<double> seconds(std::span<const Point> points, std::size_t passes) override {
    IdleChild child = idle_child();
    if (!child) return std::nullopt;
    Exchange& exchange = child->exchange();
    put(points, info_.arity, exchange);
    exchange.passes = passes;
    if (child->ask(Request::time) || exchange.status != 0) return std::nullopt;
    const double seconds = exchange.seconds;
    keep(std::move(child));
    return seconds;
  }

  [[nodiscard]] std::vector<Fault> faults() const override {
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
    const auto names = mapped<std::string_view>(kernels, &KernelInfo::name);
    refuse("kernel", name, "{}must be one of those that {} has: {}", data::did_you_mean(name, names),
           plugin_.file.string(), fmt::join(names, ", "));
  }

  /// Records the faults with the point, if there is one.
  void record(const std::vector<Fault>& faults, const std::optional<Point>& point,
              const std::string& where = "") {
    const std::scoped_lock lock(mutex_);
    for (const Fault& fault : faults) faults_.insert({fault.kind, point, fault.words + where});
  }

  [[nodiscard]] bool given_up() const {
    return unopened_ || deaths_ >= most_deaths || deaths_in_a_row_ >= most_deaths_in_a_row ||
           hangs_ >= most_hangs;
  }

  /// Sends a request and returns the faults in its answer.
  std::vector<Fault> asked(Child& child, Request request) {
    if (auto end = child.ask(request)) {
      ++(end->kind == FaultKind::hang ? hangs_ : deaths_);
      ++deaths_in_a_row_;
      return {std::move(*end)};
    }
    std::vector<Fault> faults = faults_of(child.exchange().noticed);
    if (const int status = child.exchange().status; status != 0)
      faults.push_back({FaultKind::refused, {}, fmt::format("returns {}", status)});
    return faults;
  }

  /// A process that has loaded the plugin and opened the kernel; null if this fails.
  IdleChild new_child() {
    auto child = std::make_unique<Child>(plugin_);
    const std::vector<KernelInfo> kernels = loaded(plugin_, *child);
    if (number_ >= kernels.size() || kernels[number_] != info_)
      throw BadInput("plugin", plugin_.file.string(),
                     "must list the same kernels each time that it is loaded");
    record(faults_of(child->exchange().noticed), {}, ", by being loaded");
    return opened(*child) ? std::move(child) : nullptr;
  }

  bool opened(Child& child) {
    child.exchange().kernel = number_;
    record(asked(child, Request::open), {}, ", in open");
    unopened_ = child.has_ended() || child.exchange().status != 0;
    return !unopened_;
  }

  /// Opens and closes the kernel before it is used.
  void try_closing() {
    IdleChild child = new_child();
    if (!child) return;
    record(asked(*child, Request::close), {}, ", in close");
    if (!child->has_ended() && opened(*child)) keep(std::move(child));
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

  /// Evaluates the points and returns the faults. Stores the values, if `values` is not empty, for a batch without
  /// faults and for a single point.
  std::vector<Fault> call(std::span<const Point> points, std::span<double> values) {
    IdleChild child = idle_child();
    if (!child) return {};
    Exchange& exchange = child->exchange();
    put(points, info_.arity, exchange);
    std::vector<Fault> faults = asked(*child, Request::evaluate);
    if (child->has_ended()) return faults;
    if (exchange.status == 0 && !values.empty() && (faults.empty() || points.size() == 1))
      take(exchange, points, values);
    keep(std::move(child));
    deaths_in_a_row_ = 0;
    return faults;
  }

  void evaluate_batch(std::span<const Point> points, std::span<double> values) {
    std::ranges::fill(values, no_value);
    if (given_up()) {
      not_asked_ += points.size();
      return;
    }
    const std::vector<Fault> faults = call(points, values);
    if (points.size() == 1) return record(faults, points.front());
    if (!faults.empty() && !one_by_one(points, values)) narrow(points, faults);
  }

  /// Evaluates the points of a batch with faults one at a time. Returns whether it has found a fault or given up.
  bool one_by_one(std::span<const Point> points, std::span<double> values) {
    bool found = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (given_up()) {
        not_asked_ += points.size() - i;
        return true;
      }
      const std::vector<Fault> faults = call(points.subspan(i, 1), values.subspan(i, 1));
      found = found || !faults.empty();
      record(faults, points[i]);
    }
    return found;
  }

  /// Finds the smallest part of a batch that has faults which no single point has.
  void narrow(std::span<const Point> points, const std::vector<Fault>& faults) {
    for (const auto half : {points.first(points.size() / 2), points.subspan(points.size() / 2)}) {
      if (points.size() == 1 || given_up()) break;
      if (const auto of_half = call(half, {}); !of_half.empty()) return narrow(half, of_half);
    }
    record(faults, points.front(),
           fmt::format(", in a batch of {} points, of which this is the first", points.size()));
  }

  /// Stores the values and records their faults.
  void take(const Exchange& exchange, std::span<const Point> points, std::span<double> values) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      values[i] = exchange.values[i];
      assess(points[i], exchange.values[i], exchange.permuted[i], exchange.threaded[i]);
    }
  }

  void assess(const Point& point, double value, double permuted, double threaded) {
    const auto note = [&](FaultKind kind, const std::string& words) { record({{kind, {}, words}}, point); };
    if (bits(value) == protocol::unwritten_bits) return note(FaultKind::unwritten, "no value is written");
    if (!std::isfinite(value)) note(FaultKind::not_finite, fmt::format("the value is {}", value));
    if (bits(permuted) != bits(value))
      note(FaultKind::order, fmt::format("in another order of points: {} and then {}", value, permuted));
    if (bits(threaded) != bits(value))
      note(FaultKind::threads, fmt::format("from several threads: {} and then {}", value, threaded));
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

}  // namespace

std::vector<KernelInfo> kernels_of(const Plugin& plugin) {
  check(plugin);
  Child child(plugin);
  return loaded(plugin, child);
}

std::unique_ptr<PluginKernel> open_kernel(Plugin plugin, const std::string& name) {
  return std::make_unique<KernelInProcesses>(std::move(plugin), name);
}

}  // namespace nipref::verify
