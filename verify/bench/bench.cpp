#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/bench/internal/groups.hpp>
#include <nipref/verify/support/internal/toml_table.hpp>

namespace nipref::verify {

std::vector<BenchRatio> promised_ratios(const std::vector<BenchRow>& rows) {
  const TomlTable& file = statements_file("speed.toml");
  std::vector<BenchRatio> formed;
  for (const TomlTable& promise :
       file.list("promise", {"what", "quantity", "range", "quick"},
                 {"of", "slow_range", "slow", "factor", "wanted", "tolerance", "instruction_set"})) {
    const std::string set = promise.text_or("instruction_set", ""), slow = promise.text_or("slow", "");
    if (!set.empty() && set != fast::instruction_set()) continue;
    const bool of_errors = promise.text_or("of", "times") == "errors";
    const auto size = [&](const std::string& range, const std::string& method) -> std::optional<double> {
      const auto row = std::ranges::find_if(rows, [&](const BenchRow& one) {
        return one.quantity == promise.text("quantity") && one.arguments == range && one.method == method;
      });
      if (row == rows.end()) return {};
      const auto& error = row->max_relative_error;
      const double tolerance = promise.number_or("tolerance", 0);
      if (tolerance > 0 && !(error && *error <= tolerance)) return {};
      return of_errors ? error : row->nanoseconds;
    };
    const std::string& range = promise.text("range");
    const auto numerator = slow.empty() ? 1.0 : size(promise.text_or("slow_range", range), slow);
    const auto denominator = size(range, promise.text("quick"));
    if (numerator && denominator)
      formed.push_back({promise.text("what"), promise.number_or("factor", 1) * *numerator / *denominator,
                        promise.number("wanted"), of_errors});
  }
  return formed;
}

bool all_met(const BenchReport& report, bool strict) {
  return std::ranges::all_of(report.ratios, [strict](const BenchRatio& ratio) {
    return ratio.met() || !(strict || ratio.of_errors);
  });
}

void mark_pareto_optimal(std::vector<BenchRow>& rows) {
  const auto is_beaten = [](const BenchRow& row, const BenchRow& by) {
    if (by.quantity != row.quantity || by.arguments != row.arguments || !by.max_relative_error) return false;
    const double error = *by.max_relative_error, own = *row.max_relative_error;
    return by.nanoseconds <= row.nanoseconds && error <= own &&
           (by.nanoseconds < row.nanoseconds || error < own);
  };
  for (BenchRow& row : rows) {
    row.pareto_optimal = row.max_relative_error &&
                         std::ranges::none_of(rows, [&](const BenchRow& by) { return is_beaten(row, by); });
  }
}

std::vector<BenchRow> timed_rows(const std::string& quantity, const std::string& arguments,
                                 const std::vector<TimedWay>& ways, const TimedRounds& rounds) {
  const auto timings = time_interleaved(mapped(ways, &TimedWay::contender), rounds.count, rounds.seconds);
  const double nanoseconds = 1e9 / rounds.values_in_evaluation;
  std::vector<BenchRow> rows;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const Timing& timing = timings[i];
    const WayError error = ways[i].error ? ways[i].error() : WayError{};
    rows.push_back({quantity, arguments, ways[i].name, nanoseconds * timing.seconds, error.ulps,
                    error.relative, timing.seconds / timings[rounds.over].seconds,
                    nanoseconds * timing.quartile_1, nanoseconds * timing.quartile_3});
    rows.back().mean_error_ulp = error.mean_ulps;
    rows.back().percentile_99_9_ulp = error.percentile_999_ulps;
  }
  return rows;
}

std::vector<std::span<const BenchRow>> ways_to_same_values(const std::vector<BenchRow>& rows) {
  std::vector<std::span<const BenchRow>> all;
  for (std::size_t first = 0, last = 0; first < rows.size(); first = last) {
    while (last < rows.size() && rows[last].quantity == rows[first].quantity &&
           rows[last].arguments == rows[first].arguments)
      ++last;
    all.push_back(std::span(rows).subspan(first, last - first));
  }
  return all;
}

namespace {

/// The relative differences between the quartiles and the median.
std::string quartiles_text(const BenchRow& row) {
  const auto percent = [&](double quartile) { return 100 * (quartile / row.nanoseconds - 1); };
  return fmt::format("{:+.0f}..{:+.0f}%", percent(row.quartile_1), percent(row.quartile_3));
}

Json row_json(const BenchRow& row) {
  return {{"quantity", row.quantity},
          {"range", row.arguments},
          {"method", row.method},
          {"max_error_ulp", row.max_error_ulp},
          {"max_relative_error", row.max_relative_error},
          {"mean_error_ulp", row.mean_error_ulp},
          {"percentile_99_9_ulp", row.percentile_99_9_ulp},
          {"times",
           {{"nanoseconds", row.nanoseconds},
            {"quartiles", std::vector<Json>{row.quartile_1, row.quartile_3}},
            {"ratio", row.ratio},
            {"pareto_optimal", row.pareto_optimal}}},
          {"_quartiles", quartiles_text(row)}};
}

}  // namespace

Json ratio_json(const BenchRatio& ratio) {
  return {{"what", ratio.what}, {"ratio", ratio.measured}, {"wanted", ratio.target}, {"met", ratio.met()}};
}

Json bench_json(const BenchReport& report) {
  const auto ratios = [&](bool of_errors) {
    const auto is_such = [=](const BenchRatio& ratio) { return ratio.of_errors == of_errors; };
    return json_list(report.ratios | std::views::filter(is_such), ratio_json);
  };
  const auto ways_json = [](std::span<const BenchRow> ways) {
    return Json{{"quantity", ways.front().quantity},
                {"range", ways.front().arguments},
                {"ways", json_list(ways, row_json)}};
  };
  return {{"rows", json_list(report.rows, row_json)},
          {"error_ratios", ratios(true)},
          {"times", {{"ratios", ratios(false)}}},
          {"_ratios", json_list(report.ratios, ratio_json)},
          {"_missed", !std::ranges::all_of(report.ratios, &BenchRatio::met)},
          {"_ways", json_list(ways_to_same_values(report.rows), ways_json)}};
}

}  // namespace nipref::verify
