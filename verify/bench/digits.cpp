#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <nipref/ref/number/caches.hpp>
#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/bench/internal/timed_row.hpp>
#include <nipref/verify/catalogue/sheet/internal/peers_multiprecision.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {
namespace {

const std::array<std::string, 3> alphas{"0.01", "0.73", "5"};
constexpr auto arguments_text = "alpha in {0.01, 0.73, 5}";
constexpr int extra_digits = 10;

struct DigitsMethod {
  std::string name;
  std::function<void(std::size_t)> run;                     ///< evaluates at alphas[i]; this is timed
  std::function<std::string(const std::string&)> evaluate;  ///< decimal text for a decimal argument
};

ref::Estimate ref_at(const Quantity& quantity, const std::string& alpha, int digits) {
  const std::array arguments{ref::Exact::parse(alpha, "alpha")};
  return quantity.by_ref(arguments, digits);
}

DigitsMethod ref_method(const Quantity& quantity, int digits) {
  std::vector<ref::Exact> exact;
  for (const std::string& alpha : alphas) exact.push_back(ref::Exact::parse(alpha, "alpha"));
  return {
      fmt::format("ref {} digits", digits),
      [&quantity, digits, exact](std::size_t i) { quantity.by_ref(std::span(exact).subspan(i, 1), digits); },
      [&quantity, digits](const std::string& alpha) { return ref_at(quantity, alpha, digits).value_text(); }};
}

DigitsMethod peer_method(const MultiprecisionPeer& peer, int digits) {
  const auto evaluate = [&peer, digits](const std::string& alpha) { return peer.evaluate(alpha, digits); };
  return {fmt::format("{} {} digits", peer.method, digits),
          [evaluate](std::size_t i) { evaluate(alphas[i]); }, evaluate};
}

/// The unit that is timed is a pass over all arguments, so that each counts alike.
Contender contender_of(const DigitsMethod& method) {
  constexpr std::size_t most = 1000;
  return {[&method](std::size_t passes) {
            for (std::size_t pass = 0; pass < passes; ++pass) {
              for (std::size_t i = 0; i < alphas.size(); ++i) method.run(i);
            }
          },
          1, most};
}

void compare(const Quantity& quantity, const DigitsMethod& method, int digits, BenchRow& row) {
  double ulps = 0, relative = 0;
  for (const std::string& alpha : alphas) {
    const ref::Estimate truth = ref_at(quantity, alpha, digits + extra_digits);
    const double value = std::fabs(truth.to_double());
    const std::array point{ref::Exact::parse(alpha, "alpha").approximate()};
    const double error = decimal_distance(method.evaluate(alpha), truth.value_text());
    const double scale = std::max(value, quantity.envelope(point));
    ulps = std::max(ulps, error / scale * std::pow(10.0, digits));
    relative = std::max(relative, error / value);
  }
  row.max_error_ulp = ulps;
  row.max_relative_error = relative;
}

/// The steady rows at one number of digits, and ref's first call, which builds its nodes.
struct Rows {
  std::vector<BenchRow> steady;
  BenchRow first_call;
};

BenchRow first_call_row(const BenchRow& steady, double seconds) {
  BenchRow row = steady;
  row.arguments = "alpha = " + alphas[1] + ", first call";
  row.nanoseconds = seconds * 1e9;
  row.ratio = row.nanoseconds / steady.nanoseconds;
  return row;
}

Rows bench_at(const Quantity& quantity, int digits) {
  std::vector<DigitsMethod> methods{ref_method(quantity, digits)};
  for (const MultiprecisionPeer& peer : quantity.multiprecision_peers) {
    methods.push_back(peer_method(peer, digits));
  }
  ref::clear_caches();
  const double first_call = seconds_of([&] { methods.front().run(1); });
  std::vector<Contender> contenders;
  for (const DigitsMethod& method : methods) contenders.push_back(contender_of(method));
  const std::vector<Timing> timings = time_interleaved(contenders, 5, 0.01);

  std::vector<BenchRow> rows;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    rows.push_back(timed_row(quantity.name, arguments_text, methods[i].name, timings[i], timings.front(),
                             std::tuple_size_v<decltype(alphas)>));
    compare(quantity, methods[i], digits, rows.back());
  }
  return {rows, first_call_row(rows.front(), first_call)};
}

}  // namespace

std::vector<BenchRow> bench_digits(const Quantity& quantity, const BenchProgress& progress) {
  std::vector<BenchRow> rows;
  std::vector<BenchRow> first_calls;
  if (quantity.multiprecision_peers.empty()) return rows;
  for (const int digits : peer_digits()) {
    if (interrupted()) break;
    if (progress) progress(fmt::format("{} digits", digits));
    Rows found = bench_at(quantity, digits);
    std::ranges::move(found.steady, std::back_inserter(rows));
    first_calls.push_back(std::move(found.first_call));
  }
  std::ranges::move(first_calls, std::back_inserter(rows));
  return rows;
}

}  // namespace nipref::verify
