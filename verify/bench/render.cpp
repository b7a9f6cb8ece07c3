#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include <nipref/verify/bench/render.hpp>

namespace nipref::verify {
namespace {

/// A dash where nothing was measured.
std::string measured(double value, int digits) {
  return std::isnan(value) ? "-" : fmt::format("{:.{}g}", value, digits);
}

}  // namespace

std::string bench_text(const std::vector<BenchRow>& rows) {
  std::string text = fmt::format("{:11}{:30}{:28}{:>11}{:>12}{:>11}{:>10}\n", "quantity", "arguments",
                                 "method", "ns/value", "time ratio", "max ulp", "max rel");
  const BenchRow* previous = nullptr;
  for (const BenchRow& row : rows) {
    const bool same =
        previous != nullptr && previous->quantity == row.quantity && previous->arguments == row.arguments;
    text += fmt::format("{:11}{:30}{:28}{:>11.4g}{:>12.3g}{:>11}{:>10}\n", same ? "" : row.quantity,
                        same ? "" : row.arguments, row.method, row.nanoseconds, row.ratio,
                        measured(row.max_error_ulp, 3), measured(row.max_relative_error, 2));
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
  return text;
}

nlohmann::ordered_json bench_json(const BenchReport& report) {
  nlohmann::ordered_json json{{"rows", nlohmann::ordered_json::array()},
                              {"ratios", nlohmann::ordered_json::array()}};
  for (const BenchRow& row : report.rows) {
    json["rows"].push_back({{"quantity", row.quantity},
                            {"arguments", row.arguments},
                            {"method", row.method},
                            {"ns", row.nanoseconds},
                            {"max_error_ulp", row.max_error_ulp},
                            {"max_relative_error", row.max_relative_error}});
  }
  for (const BenchRatio& ratio : report.ratios) {
    json["ratios"].push_back({{"what", ratio.what}, {"measured", ratio.measured}, {"target", ratio.target}});
  }
  return json;
}

}  // namespace nipref::verify
