#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include <nipref/verify/bench/render.hpp>
#include <nipref/verify/support/internal/or_dash.hpp>

namespace nipref::verify {
std::string bench_text(const std::vector<BenchRow>& rows) {
  std::string text = fmt::format("{:22}{:30}{:28}{:>11}{:>20}{:>12}{:>11}{:>10}\n", "quantity", "arguments",
                                 "method", "ns/value", "quartiles", "time ratio", "max ulp", "max rel");
  const BenchRow* previous = nullptr;
  for (const BenchRow& row : rows) {
    const bool same =
        previous != nullptr && previous->quantity == row.quantity && previous->arguments == row.arguments;
    text += fmt::format("{:22}{:30}{:28}{:>11.4g}{:>20}{:>12}{:>11}{:>10}{}\n", same ? "" : row.quantity,
                        same ? "" : row.arguments, row.method, row.nanoseconds,
                        fmt::format("{:.4g}..{:.4g}", row.quartile_1, row.quartile_3), or_dash(row.ratio, 3),
                        or_dash(row.max_error_ulp, 3), or_dash(row.max_relative_error, 2),
                        row.pareto_optimal ? " *" : "");
    previous = &row;
  }
  return text;
}

std::string ratios_text(const std::vector<BenchRatio>& ratios) {
  std::string text;
  for (const BenchRatio& ratio : ratios) {
    text += fmt::format("{:46} {:>8.1f} times, asked for {:>5g}: {}\n", ratio.what, ratio.measured,
                        ratio.target, ratio.met() ? "met" : "MISSED");
  }
  if (!std::ranges::all_of(ratios, &BenchRatio::met))
    text += "A missed ratio of times fails the run with --strict only: times depend on the machine.\n";
  return text;
}

Json bench_json(const BenchReport& report) {
  const auto ratios = [&](bool of_errors) {
    std::vector<BenchRatio> these;
    std::ranges::copy_if(report.ratios, std::back_inserter(these),
                         [=](const BenchRatio& ratio) { return ratio.of_errors == of_errors; });
    return json_list(these, [](const BenchRatio& ratio) {
      return Json{
          {"what", ratio.what}, {"ratio", ratio.measured}, {"wanted", ratio.target}, {"met", ratio.met()}};
    });
  };
  return {{"rows", json_list(report.rows,
                             [](const BenchRow& row) {
                               return Json{
                                   {"quantity", row.quantity},
                                   {"range", row.arguments},
                                   {"method", row.method},
                                   {"max_error_ulp", row.max_error_ulp},
                                   {"max_relative_error", row.max_relative_error},
                                   {"times",
                                    {{"nanoseconds", row.nanoseconds},
                                     {"quartiles", json_list(std::array{row.quartile_1, row.quartile_3},
                                                             [](double time) { return Json(time); })},
                                     {"ratio", row.ratio},
                                     {"pareto_optimal", row.pareto_optimal}}}};
                             })},
          {"error_ratios", ratios(true)},
          {"times", {{"ratios", ratios(false)}}}};
}

}  // namespace nipref::verify
