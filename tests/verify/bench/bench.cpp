#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/sheet/internal/peers.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/report_parts.hpp>
#include <nipref/verify/grade/speed.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

#include "support/paths.hpp"
#include "support/test.hpp"

using namespace nipref;

namespace {

std::string ref_I1(const std::string& alpha, int digits) {
  const std::array arguments{ref::Exact::parse(alpha, "alpha")};
  return verify::find_quantity("I1").by_ref(arguments, digits).value_text();
}

std::vector<verify::BenchRow> rows_of(const std::vector<verify::BenchPart>& parts) {
  std::vector<verify::BenchRow> rows;
  for (const verify::BenchPart& part : parts) std::ranges::move(part.rows(), std::back_inserter(rows));
  return rows;
}

std::string bench_text(const verify::BenchReport& report) {
  verify::Json answer = verify::bench_json(report);
  answer.set("_machine", nullptr);
  return verify::text_of("bench.txt", answer);
}

}  // namespace

TEST_CASE("the peers in double compute I1") {
  for (const auto& make : {verify::make_plain_series_I1, verify::make_qawf_I1, verify::make_ooura_I1}) {
    const auto peer = make();
    for (const char* alpha : {"0.25", "0.73", "1"}) {
      CAPTURE(alpha);
      CHECK(peer(std::stod(alpha)) == doctest::Approx(std::stod(ref_I1(alpha, 20))).epsilon(1e-12));
    }
  }
}

TEST_CASE("exp_sinh computes I1 to the digits asked for") {
  for (const int digits : verify::peer_digits()) {
    CAPTURE(digits);
    CHECK(verify::decimal_distance(verify::exp_sinh_I1("0.73", digits), ref_I1("0.73", digits + 10)) <=
          std::pow(10.0, 1 - digits));
  }
  CHECK_THROWS_AS(verify::exp_sinh_I1("0.73", 40), data::BadInput);
}

TEST_CASE("the distance of two decimal texts keeps what a double would lose") {
  CHECK(verify::decimal_distance("0.3333333333333333333333333333331", "0.3333333333333333333333333333330") ==
        doctest::Approx(1e-31));
  CHECK(verify::decimal_distance("1e-3", "0.001") == 0);
}

TEST_CASE("the stopwatch plans by a run that finds what the first built, and asks for what there is") {
  int runs = 0;
  const verify::Contender slow_at_first{[&](std::size_t) {
                                          if (++runs == 1)
                                            std::this_thread::sleep_for(std::chrono::milliseconds(20));
                                        },
                                        1, 1};
  // All runs but the first are far shorter, even on a busy machine.
  verify::time_interleaved({slow_at_first}, 3, 0.05);
  CHECK(runs > 20);
  std::set<std::size_t> counts;
  const verify::Contender contender{[&](std::size_t count) { counts.insert(count); }, 8, 100};
  const auto timings = verify::time_interleaved({contender}, 3, 0.05);
  REQUIRE(timings.size() == 1);
  CHECK(timings[0].count == 100);
  CHECK(timings[0].seconds >= 0);
  CHECK(*counts.begin() == 8);
  CHECK(*counts.rbegin() == 100);
}

TEST_CASE("a ratio is met only by a number") {
  CHECK(verify::BenchRatio{"", 3, 3}.met());
  CHECK_FALSE(verify::BenchRatio{"", 2.9, 3}.met());
  CHECK_FALSE(verify::BenchRatio{"", std::nan(""), 3}.met());
}

TEST_CASE("a promised ratio is formed only of ways that are both as right as it asks") {
  const auto ratios = [](const char* range, std::optional<double> error_of_rule) {
    return verify::promised_ratios(
        {{"I1", range, "fast full", 10, 0.5, 1e-16, 1},
         {"I1", range, "Boost ooura_fourier_cos", 6000, error_of_rule, error_of_rule, {}}});
  };
  REQUIRE(ratios("alpha in [1e-3,1]", 1e-14).size() == 1);
  CHECK(ratios("alpha in [1e-3,1]", 1e-14).front().measured == 600);
  CHECK(ratios("alpha in [1e-3,1]", 28).empty());
  CHECK(ratios("alpha in [1e-3,1]", std::nan("")).empty());
  CHECK(ratios("alpha in [1e-3,1]", {}).empty());
  CHECK(ratios("alpha in [1e-6,20] log-uniform", 28).empty());
}

TEST_CASE("the bench of a kernel compares scalar and batch with ref") {
  const auto rows = rows_of(verify::double_bench(verify::find_quantity("I7")));
  REQUIRE(rows.size() == 2);
  for (const verify::BenchRow& row : rows) {
    CHECK(row.quantity == "I7");
    CHECK(row.nanoseconds > 0);
    CHECK(row.max_error_ulp.value() > 0);
    CHECK(row.max_error_ulp.value() <= 2);
  }
  CHECK(verify::promised_ratios(rows).empty());
}

TEST_CASE("a quantity that costs a solution is timed at a few points, and only where it is named") {
  const verify::Quantity& theta1 = verify::find_quantity("material.theta1");
  REQUIRE(theta1.is_costly);
  const auto rows = rows_of(verify::double_bench(theta1));
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].arguments == "as in the audit, 12 points");
  CHECK(rows[0].nanoseconds > 0);
  CHECK(rows[0].max_error_ulp.value() <= theta1.promise);
  const auto everything = verify::bench_everything().quantities;
  CHECK(std::ranges::none_of(everything, [](const verify::Quantity* each) { return each->is_costly; }));
  CHECK(std::ranges::find(everything, &verify::find_quantity("I1")) != everything.end());
}

TEST_CASE("somebody's kernel is timed beside fast, with its errors, and only for its own quantity") {
  const auto kernel = verify::open_kernel({plugin_file("kernels")}, "all_sound");
  const std::vector<verify::OtherKernel> others{{"mine", kernel.get()}};
  const auto rows = rows_of(verify::double_bench(verify::find_quantity("I3"), others));
  const auto mine = std::ranges::find(rows, "mine", &verify::BenchRow::method);
  REQUIRE(mine != rows.end());
  CHECK(mine->nanoseconds > 0);
  CHECK(mine->max_error_ulp.value() == rows.front().max_error_ulp.value());
  const auto other_rows = rows_of(verify::double_bench(verify::find_quantity("I4"), others));
  CHECK(std::ranges::find(other_rows, "mine", &verify::BenchRow::method) == other_rows.end());
}

TEST_CASE("however slow a method is, its errors are found at the same points") {
  using namespace std::chrono_literals;
  std::set<double> seen;
  verify::Quantity quantity = verify::find_quantity("I7");
  quantity.peers = {{"slow", [&] {
                       return [&](double alpha) {
                         std::this_thread::sleep_for(100us);
                         seen.insert(alpha);
                         return alpha;
                       };
                     }}};
  rows_of(verify::double_bench(quantity));
  CHECK(seen.size() >= 6 * 400);  // in each of the six ranges
}

TEST_CASE("a way is marked if none beats it, and ways to other values do not matter") {
  const auto row = [](const char* method, double time, std::optional<double> error,
                      const char* arguments = "all") {
    return verify::BenchRow{"I1", arguments, method, time, error, error, {}};
  };
  std::vector<verify::BenchRow> rows{row("exact", 10, 1e-16),         row("coarse", 2, 1e-6),
                                     row("slow and coarse", 5, 1e-6), row("slower", 11, 1e-16),
                                     row("unknown", 1, {}),           row("other", 99, 1, "few")};
  verify::mark_pareto_optimal(rows);
  std::string marked;
  for (const auto& one : rows) marked += one.pareto_optimal ? one.method + " " : "";
  CHECK(marked == "exact coarse other ");
}

TEST_CASE("a missed ratio of times fails a run only where it is strict, one of errors always") {
  const verify::BenchRatio kept{"time", 2, 1}, slow{"time", 1, 2}, coarse{"error", 1, 2, true};
  for (const bool strict : {false, true}) {
    CHECK(verify::all_met({{}, {kept}}, strict));
    CHECK(verify::all_met({{}, {kept, slow}}, strict) == !strict);
    CHECK_FALSE(verify::all_met({{}, {kept, coarse}}, strict));
  }
  CHECK(!contains(bench_text({{}, {kept}}), "--strict"));
  CHECK(contains(bench_text({{}, {kept, slow}}), "with --strict only"));
}

TEST_CASE("a speed is slower only if it is so in every round") {
  const auto speed = [](double second_round) {
    return verify::Speed({11.5, second_round, 13}, {10, 10, 10}, 0);
  };
  CHECK(speed(12).slower_by(0.1));
  CHECK_FALSE(speed(12).slower_by(0.15));
  CHECK_FALSE(speed(9).slower_by(0.1));
}
