#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/verify/cli/graded.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/grade/measured_points.hpp>
#include <nipref/verify/support/internal/progress.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

void refuse_what_needs_kernels(const CommandLine& line) {
  for (const char* const name :
       {"points", "seed", "quantity", "time-limit", "against", "max-slowdown", "thread-safe"})
    refuse_option(line, name, "has an effect on shared objects only: must be left out");
  if (!line.assignments.empty())
    throw BadInput(line.assignments.front().first, line.assignments.front().second,
                   "unexpected: ranges are for shared objects, a CSV has its points");
}

std::vector<std::string> remarks_on(const MeasuredPoints& measured) {
  std::vector<std::string> remarks;
  if (measured.contradicting_rows > 0)
    remarks.push_back(
        fmt::format("{} rows have a decimal argument that is another number than the hexadecimal one, "
                    "which was taken: digits were lost",
                    measured.contradicting_rows));
  if (measured.short_rows > 0)
    remarks.push_back(
        fmt::format("{} rows have a decimal argument of 15 digits or less: it may have lost digits, and "
                    "the value is compared at what is left",
                    measured.short_rows));
  return remarks;
}

BaselineKey key_of(const Graded& graded) {
  const Grade& grade = graded.grade;
  return {grade.what,         grade.found.quantity->name,
          grade.where,        graded.seed,
          grade.found.points, sampler_version,
          compiler(),         std::string(fast::instruction_set())};
}

/// The baseline, read before anything is graded. Where it is to be written there may be none yet.
std::optional<Baseline> baseline_of(const CommandLine& line) {
  const auto path = line.option("baseline");
  if (!path) return std::nullopt;
  std::error_code unknown;
  if (!std::filesystem::exists(*path, unknown) && !unknown) {
    if (line.has("update-baseline")) return Baseline{};
    throw BadInput("baseline", *path, "must be a file that exists: --update-baseline makes one");
  }
  return Baseline::read(*path);
}

/// Compares with the baseline, which is changed before if that is asked for. False if it may not be.
bool settle_baseline(const CommandLine& line, Baseline& baseline, Graded& graded) {
  const BaselineKey key = key_of(graded);
  const double error = graded.grade.found.max_error_ulp;
  const bool settled = !line.has("update-baseline") || update(baseline, key, error, line.option("accept"));
  if (!settled)
    graded.remarks.emplace_back("the baseline was left as it is: raising it needs --accept \"reason\"");
  graded.against_baseline = compare_with(baseline, key, error);
  return settled;
}

}  // namespace

std::vector<Graded> graded_file(const CommandLine& line) {
  refuse_what_needs_kernels(line);
  if (line.words.size() > 2)
    throw BadInput("argument", line.words[2], "unexpected: grade takes a file and a quantity");
  const auto quantity = line.words.size() > 1 ? std::optional(line.words[1]) : std::nullopt;
  AuditOptions options;
  const std::string promised = take_promise(line, options);
  const std::string& file = line.words.front();
  const std::string what = file == "-" ? "standard input" : std::filesystem::path(file).filename().string();
  const auto columns = read_measured_points(file, quantity, line.option("column"));
  Progress progress(line.has("quiet"));
  options.progress = [&](double part) { progress.at(part); };
  std::vector<Graded> all;
  const auto name = [](const MeasuredPoints& column) { return column.quantity->name; };
  progress.each("grade", columns, name, [&](const MeasuredPoints& column) {
    const auto [found, seconds] =
        timed([&] { return audit_values(*column.quantity, column.points, column.values, options); });
    const auto worst = std::ranges::find(column.points, found.worst) - column.points.begin();
    all.push_back({.grade = grade_of(what, "its points", found),
                   .seconds = seconds,
                   .promised = promised,
                   .own = column.values[static_cast<std::size_t>(worst)],
                   .remarks = remarks_on(column)});
  });
  return all;
}

int grade_verb(const CommandLine& line, std::ostream& out) {
  std::optional<Baseline> baseline = baseline_of(line);
  std::vector<Graded> all = names_plugin(line) ? graded_kernels(line) : graded_file(line);
  bool kept = true, to_be_written = false;
  for (Graded& graded : all) {
    const bool settled = !baseline || settle_baseline(line, *baseline, graded);
    kept = kept && settled && graded.kept();
    to_be_written |= settled && line.has("update-baseline");
  }
  if (to_be_written) replace_output_file(*line.option("baseline"), baseline->text());
  if (const auto path = line.option("keep-worst")) {
    for (const Graded& graded : all) keep_worst(*path, graded);
  }
  if (const auto junit = line.option("junit")) {
    write_output_file(*junit, junit_text(all));
  }
  const auto text = [&] {
    std::string of_all;
    for (const Graded& graded : all)
      of_all +=
          folded(graded_text(graded)) + (line.has("ctest") ? text_of("ctest.txt", graded_json(graded)) : "");
    return of_all;
  };
  return write_answer(line, out, "grade", kept, {{"rows", json_list(all, graded_json)}}, text);
}

}  // namespace nipref::verify
