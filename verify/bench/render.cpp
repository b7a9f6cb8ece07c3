#include <fmt/format.h>

#include <algorithm>
#include <span>

#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/support/internal/number_text.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

/// The deviations of the quartiles from the median.
std::string quartiles_text(const BenchRow& row) {
  const auto percent = [&](double quartile) { return 100 * (quartile / row.nanoseconds - 1); };
  return fmt::format("{:+.0f}..{:+.0f}%", percent(row.quartile_1), percent(row.quartile_3));
}

/// The table of one quantity and range.
std::string group_text(std::span<const BenchRow> rows) {
  TextTable table({" method", ">ns/value", ">quartiles", ">ratio", ">max ulp", ">max rel"});
  for (const BenchRow& row : rows) {
    table.add({(row.pareto_optimal ? "*" : " ") + row.method, fmt::format("{:.3g}", row.nanoseconds),
               quartiles_text(row), or_dash(row.ratio, 3), or_dash(row.max_error_ulp, 3),
               or_dash(row.max_relative_error, 2)});
  }
  return fmt::format("\n{} {}\n", rows.front().quantity, rows.front().arguments) + table.text();
}

}  // namespace

std::string bench_text(const std::vector<BenchRow>& rows) {
  std::string text;
  for (std::size_t first = 0, last = 0; first < rows.size(); first = last) {
    while (last < rows.size() && rows[last].quantity == rows[first].quantity &&
           rows[last].arguments == rows[first].arguments)
      ++last;
    text += group_text(std::span(rows).subspan(first, last - first));
  }
  return text;
}

std::string ratios_text(const std::vector<BenchRatio>& ratios) {
  std::string text;
  for (const BenchRatio& ratio : ratios) {
    text += fmt::format("{}  {:>8.1f} times, asked for {:>5g}: {}\n",
                        verdict(ratio.met(), ratio.met() ? "met   " : "MISSED"), ratio.measured, ratio.target,
                        ratio.what);
  }
  if (!std::ranges::all_of(ratios, &BenchRatio::met))
    text += "A missed ratio of times fails the run with --strict only: times depend on the machine.\n";
  return text;
}

Json ratio_json(const BenchRatio& ratio) {
  return {{"what", ratio.what}, {"ratio", ratio.measured}, {"wanted", ratio.target}, {"met", ratio.met()}};
}

Json bench_json(const BenchReport& report) {
  const auto ratios = [&](bool of_errors) {
    std::vector<Json> these;
    for (const BenchRatio& ratio : report.ratios) {
      if (ratio.of_errors == of_errors) these.push_back(ratio_json(ratio));
    }
    return these;
  };
  const auto row_json = [](const BenchRow& row) {
    return Json{{"quantity", row.quantity},
                {"range", row.arguments},
                {"method", row.method},
                {"max_error_ulp", row.max_error_ulp},
                {"max_relative_error", row.max_relative_error},
                {"times",
                 {{"nanoseconds", row.nanoseconds},
                  {"quartiles", std::vector<Json>{row.quartile_1, row.quartile_3}},
                  {"ratio", row.ratio},
                  {"pareto_optimal", row.pareto_optimal}}}};
  };
  return {{"rows", json_list(report.rows, row_json)},
          {"error_ratios", ratios(true)},
          {"times", {{"ratios", ratios(false)}}}};
}

}  // namespace nipref::verify
