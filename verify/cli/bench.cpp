#include <tuple>

#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/bench/internal/groups.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/report_parts.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/grade/speed.hpp>
#include <nipref/verify/support/internal/process.hpp>

namespace nipref::verify {
namespace {

/// The words of this call, for the same call of an older program.
std::vector<std::string> words_of_bench(const CommandLine& line) {
  std::vector<std::string> words = line.words;
  if (const auto isa = line.option("isa")) words.insert(words.end(), {"--isa", *isa});
  return words;
}

using Key = std::tuple<std::string, std::string, std::string>;  ///< quantity, range, method

constexpr int rounds = 3;

struct Measured {
  std::vector<double> nanoseconds;  ///< one for each round
  std::optional<double> ulp;
};

using Program = std::map<Key, Measured>;

/// Runs one round of a program. BadInput naming "against" if it does not answer as nipref does.
void add_round(const std::string& program, const std::vector<std::string>& words, Program& rows) try {
  std::vector<std::string> call{program, "bench", "--json", "--quiet"};
  call.insert(call.end(), words.begin(), words.end());
  for (const Json& row : Json::parse(output_of(call).text).at("rows").items()) {
    const auto text = [&](const char* key) { return row.at(key).as_text(); };
    Measured& measured = rows[{text("quantity"), text("range"), text("method")}];
    measured.nanoseconds.push_back(*row.at("times").at("nanoseconds").as_number());
    measured.ulp = row.at("max_error_ulp").as_number();
  }
} catch (const JsonMisfit&) {
  throw data::BadInput("against", program,
                       "must be a nipref whose bench takes the same words and answers with --json");
}

/// Runs `bench` of an older program and of this one alternately, a few rounds, with the same words. The answer has, for
/// each method of both, the ratio of the new time to the old one, with the least and the largest of the rounds.
VerbAnswer bench_against(const std::string& old_program, const CommandLine& line) {
  const auto most_slowdown = max_slowdown_option(line);
  const std::vector<std::string> words = words_of_bench(line);
  const std::string own = std::filesystem::read_symlink("/proc/self/exe").string();
  Progress progress(standard_error(line.has("quiet")));
  Program before, now;
  progress.begin("bench against", 2 * rounds);
  for (int round = 0; round < rounds; ++round) {
    // The order alternates, so that a change of the machine's speed affects both alike.
    for (const bool is_old : {round % 2 == 0, round % 2 != 0}) {
      progress.next(is_old ? "the older program" : "this program");
      add_round(is_old ? old_program : own, words, is_old ? before : now);
    }
  }
  std::vector<Json> rows;
  bool is_quick = true;
  for (const auto& [key, measured] : now) {
    const auto old = before.find(key);
    if (old == before.end()) continue;
    const auto& [quantity, range, method] = key;
    const Speed speed(measured.nanoseconds, old->second.nanoseconds, 0);
    is_quick = is_quick && !(most_slowdown && speed.slower_by(*most_slowdown));
    rows.push_back({{"quantity", quantity},
                    {"range", range},
                    {"method", method},
                    {"old_max_error_ulp", old->second.ulp},
                    {"max_error_ulp", measured.ulp},
                    {"times",
                     {{"old_nanoseconds", speed.other_nanoseconds},
                      {"nanoseconds", speed.nanoseconds},
                      {"ratio", speed.ratio},
                      {"least_ratio", speed.lower_ratio},
                      {"largest_ratio", speed.upper_ratio}}}});
  }
  return {"bench_against", {{"rows", rows}}, is_quick};
}

}  // namespace

VerbAnswer bench_verb(const CommandLine& line) {
  const Selection selected = line.words.empty() ? bench_everything() : selection(line.words, bench_groups());
  static_cast<void>(max_slowdown_option(line));
  if (const auto older = line.option("against")) return bench_against(*older, line);
  std::vector<std::unique_ptr<PluginKernel>> kernels;
  std::vector<OtherKernel> others;
  if (const auto file = line.option("with")) {
    for (const KernelInfo& info : kernels_of({*file}))
      others.push_back({info.name + " of " + std::filesystem::path(*file).filename().string(),
                        kernels.emplace_back(open_kernel({*file}, info.name)).get()});
  }
  Progress progress(line.has("quiet"));
  const BenchReport report = bench_all(selected, progress, others);
  Json answer = bench_json(report);
  answer.set("_machine", version_json());
  return {"bench", answer, all_met(report, line.has("strict"))};
}

std::vector<std::string_view> bench_groups() {
  std::vector<std::string_view> names;
  std::ranges::transform(bench_group_table, std::back_inserter(names), &BenchGroup::name);
  return names;
}

Selection bench_everything() {
  Selection all = selection({}, bench_groups());
  std::erase_if(all.quantities, &Quantity::is_costly);
  return all;
}

BenchReport bench_all(const Selection& selected, Progress& progress, const std::vector<OtherKernel>& others) {
  std::vector<BenchPart> parts;
  for (const Quantity* const quantity : selected.quantities)
    for (const auto& of_kind : {double_bench(*quantity, others), digits_bench(*quantity)})
      parts.insert(parts.end(), of_kind.begin(), of_kind.end());
  for (const BenchGroup& group : bench_group_table) {
    if (!selected.has(group.name)) continue;
    for (const BenchPart& part : group.parts())
      parts.push_back({fmt::format("{} {}", group.name, part.name), part.rows});
  }
  BenchReport report;
  progress.each("bench", parts, &BenchPart::name, [&](const BenchPart& part) {
    std::ranges::move(part.rows(), std::back_inserter(report.rows));
  });
  report.ratios = promised_ratios(report.rows);
  mark_pareto_optimal(report.rows);
  return report;
}

}  // namespace nipref::verify
