#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/cli/bench.hpp>
#include <nipref/verify/cli/programs.hpp>
#include <nipref/verify/support/internal/number_text.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

using Key = std::tuple<std::string, std::string, std::string>;  ///< quantity, range, method

constexpr int rounds = 3;

struct Measured {
  std::vector<double> nanoseconds;  ///< a round each
  std::optional<double> ulp;
};

using Program = std::map<Key, Measured>;

/// One round of a program. False if it does not answer as `bench` does.
bool add_round(const std::string& program, const std::vector<std::string>& words, Program& rows) {
  std::vector<std::string> call{program, "bench", "--json", "--quiet"};
  call.insert(call.end(), words.begin(), words.end());
  const nlohmann::json answer = nlohmann::json::parse(output_of(call).text, nullptr, false);
  if (!answer.is_object() || !answer.contains("rows")) return false;
  for (const auto& row : answer["rows"]) {
    Measured& measured = rows[{row.at("quantity"), row.at("range"), row.at("method")}];
    measured.nanoseconds.push_back(row.at("times").at("nanoseconds"));
    const auto& ulp = row.at("max_error_ulp");
    if (ulp.is_number()) measured.ulp = ulp.get<double>();
  }
  return true;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

AgainstRow row_of(const Key& key, const Measured& before, const Measured& now) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(before.nanoseconds.size(), now.nanoseconds.size()); ++i)
    ratios.push_back(now.nanoseconds[i] / before.nanoseconds[i]);
  return {std::get<0>(key),
          std::get<1>(key),
          std::get<2>(key),
          median(before.nanoseconds),
          median(now.nanoseconds),
          median(ratios),
          std::ranges::min(ratios),
          std::ranges::max(ratios),
          before.ulp,
          now.ulp};
}

}  // namespace

std::vector<AgainstRow> bench_against(const std::string& old_program, const std::vector<std::string>& words,
                                      Progress& progress) {
  const std::string own = std::filesystem::read_symlink("/proc/self/exe").string();
  Program before, now;
  progress.begin("bench against", 2 * rounds);
  for (int round = 0; round < rounds; ++round) {
    // In turns, so that a change of the machine's speed meets both alike.
    for (const bool is_old : {round % 2 == 0, round % 2 != 0}) {
      progress.next(is_old ? "the older program" : "this program");
      if (!add_round(is_old ? old_program : own, words, is_old ? before : now))
        throw data::BadInput("against", is_old ? old_program : own,
                             "must be a nipref whose bench takes the same words and answers with --json");
    }
  }
  std::vector<AgainstRow> rows;
  for (const auto& [key, measured] : now) {
    if (const auto old = before.find(key); old != before.end())
      rows.push_back(row_of(key, old->second, measured));
  }
  return rows;
}

std::string against_text(const std::vector<AgainstRow>& rows) {
  TextTable table({"method", ">old ns", ">new ns", ">ratio", ">of rounds", ">old ulp", ">new ulp"});
  for (const AgainstRow& row : rows) {
    table.add({row.method, fmt::format("{:.4g}", row.old_nanoseconds),
               fmt::format("{:.4g}", row.new_nanoseconds), fmt::format("{:.3g}", row.ratio),
               fmt::format("{:.2f}..{:.2f}", row.least_ratio, row.largest_ratio), or_dash(row.old_ulp, 3),
               or_dash(row.new_ulp, 3)});
    table.add_below(row.quantity + " " + row.range);
  }
  return table.text();
}

Json against_json(const std::vector<AgainstRow>& rows) {
  return json_list(rows, [](const AgainstRow& row) {
    return Json{{"quantity", row.quantity},
                {"range", row.range},
                {"method", row.method},
                {"old_max_error_ulp", row.old_ulp},
                {"max_error_ulp", row.new_ulp},
                {"times",
                 {{"old_nanoseconds", row.old_nanoseconds},
                  {"nanoseconds", row.new_nanoseconds},
                  {"ratio", row.ratio},
                  {"least_ratio", row.least_ratio},
                  {"largest_ratio", row.largest_ratio}}}};
  });
}

}  // namespace nipref::verify
