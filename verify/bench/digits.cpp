#include <nipref/ref/number/caches.hpp>
#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/bench/internal/groups.hpp>
#include <nipref/verify/catalogue/sheet/internal/peers.hpp>

namespace nipref::verify {
namespace {

const std::array<std::string, 3> alphas{"0.01", "0.73", "5"};
constexpr int extra_digits = 10;

struct DigitsMethod {
  std::string name;
  std::function<std::string(std::size_t i)> evaluate;  ///< decimal text of the value at alphas[i]
  std::function<void(std::size_t i)> run;              ///< the timed call: ref without the conversion to text
};

ref::Estimate ref_at(const Quantity& quantity, std::size_t i, int digits) {
  static const std::array exact{ref::Exact::parse(alphas[0], "alpha"), ref::Exact::parse(alphas[1], "alpha"),
                                ref::Exact::parse(alphas[2], "alpha")};
  return quantity.by_ref(std::span(exact).subspan(i, 1), digits);
}

WayError largest_error(const Quantity& quantity, const DigitsMethod& method, int digits) {
  double ulps = 0, relative = 0;
  for (std::size_t i = 0; i < alphas.size(); ++i) {
    const ref::Estimate truth = ref_at(quantity, i, digits + extra_digits);
    const double value = std::fabs(truth.to_double());
    const std::array point{ref::Exact::parse(alphas[i], "alpha").approximate()};
    const double error = decimal_distance(method.evaluate(i), truth.value_text());
    const double scale = std::max(value, quantity.envelope(point));
    ulps = std::max(ulps, error / scale * std::pow(10.0, digits));
    relative = std::max(relative, error / value);
  }
  return {ulps, relative};
}

/// The rows for one number of digits. The last row is the first call of ref, which computes the quadrature nodes.
std::vector<BenchRow> bench_at(const Quantity& quantity, int digits) {
  std::vector<DigitsMethod> methods{{fmt::format("ref {} digits", digits),
                                     [&](std::size_t i) { return ref_at(quantity, i, digits).value_text(); },
                                     [&](std::size_t i) { ref_at(quantity, i, digits); }}};
  for (const MultiprecisionPeer& peer : quantity.multiprecision_peers) {
    const auto evaluate = [&peer, digits](std::size_t i) { return peer.evaluate(alphas[i], digits); };
    methods.push_back({fmt::format("{} {} digits", peer.method, digits), evaluate, evaluate});
  }
  ref::clear_caches();
  const double first_call = seconds_of([&] { methods.front().run(1); });
  std::vector<TimedWay> ways;
  // An evaluation is a pass over all arguments, so that all arguments have the same weight.
  for (const DigitsMethod& method : methods)
    ways.push_back({method.name, repeated([&](std::size_t) {
                      for (std::size_t i = 0; i < alphas.size(); ++i) method.run(i);
                      return 0;
                    }),
                    [&] { return largest_error(quantity, method, digits); }});
  auto rows = timed_rows(quantity.name, "alpha in {0.01, 0.73, 5}", ways,
                         {.count = 5, .seconds = 0.01, .values_in_evaluation = alphas.size()});
  BenchRow first = rows.front();
  first.arguments = "alpha = " + alphas[1] + ", first call";
  first.nanoseconds = first_call * 1e9;
  first.ratio = first.nanoseconds / rows.front().nanoseconds;
  rows.push_back(first);
  return rows;
}

}  // namespace

std::vector<BenchPart> digits_bench(const Quantity& quantity) {
  if (quantity.multiprecision_peers.empty()) return {};
  return {{quantity.name + " digits", [&] {
             std::vector<BenchRow> rows, first_calls;
             for (const int digits : peer_digits()) {
               std::vector<BenchRow> found = bench_at(quantity, digits);
               first_calls.push_back(found.back());
               found.pop_back();
               std::ranges::move(found, std::back_inserter(rows));
             }
             std::ranges::move(first_calls, std::back_inserter(rows));
             return rows;
           }}};
}

}  // namespace nipref::verify
