#include <fmt/format.h>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/interruption.hpp>
#include <nipref/verify/cli/machine.hpp>
#include <nipref/verify/cli/options.hpp>
#include <nipref/verify/cli/output_file.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/grade/baseline.hpp>
#include <nipref/verify/grade/grade.hpp>
#include <nipref/verify/grade/junit.hpp>
#include <nipref/verify/grade/measured_points.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

/// A grade and all that is said of it besides.
struct Graded {
  Grade grade;
  double seconds;
  std::vector<std::string> remarks;
  std::optional<BaselineComparison> against_baseline = {};

  [[nodiscard]] bool kept(bool strict) const {
    if (!grade.found.kept()) return false;
    if (!against_baseline || against_baseline->comparison == Comparison::not_worse) return true;
    return against_baseline->comparison == Comparison::not_comparable && !strict;
  }
};

std::optional<double> promise_option(const CommandLine& line) {
  const auto text = line.option("promise");
  if (!text) return std::nullopt;
  const double promise = parse_real("promise", *text);
  if (promise <= 0)
    throw BadInput("promise", *text, "must be a number > 0, units in the last place of the scale");
  return promise;
}

void refuse_what_needs_a_baseline(const CommandLine& line) {
  if (line.option("baseline")) return;
  for (const char* const name : {"update-baseline", "accept", "strict"})
    refuse_option(line, name, "must be given with --baseline");
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

Graded graded_file(const CommandLine& line) {
  if (line.words.empty()) throw BadInput("file", "(missing)", "must be a CSV, or - for standard input");
  if (line.words.size() > 2)
    throw BadInput("argument", line.words[2], "unexpected: grade takes a file and a quantity");
  const auto quantity = line.words.size() > 1 ? std::optional(line.words[1]) : std::nullopt;
  AuditOptions options;
  options.promise = promise_option(line);
  const std::string& file = line.words.front();
  const MeasuredPoints measured = read_measured_points(file, quantity, line.option("column"));
  std::optional<AuditResult> found;
  const double seconds = seconds_of(
      [&] { found = audit_values(*measured.quantity, measured.points, measured.values, options); });
  return {grade_of(file == "-" ? "standard input" : file, "its points", *found), seconds,
          remarks_on(measured)};
}

BaselineKey key_of(const Graded& graded) {
  const Grade& grade = graded.grade;
  return {
      grade.what, grade.found.quantity->name,          grade.where, "", grade.found.points, sampler_version,
      compiler(), std::string(fast::instruction_set())};
}

/// Compares with the baseline, and changes it if that is asked for. False if it may not be.
bool settle_baseline(const CommandLine& line, Graded& graded) {
  const auto path = line.option("baseline");
  if (!path) return true;
  Baseline baseline = Baseline::read(*path);
  graded.against_baseline = compare_with(baseline, key_of(graded), graded.grade.found.max_error_ulp);
  if (!line.has("update-baseline")) return true;
  const bool updated =
      update(baseline, key_of(graded), graded.grade.found.max_error_ulp, line.option("accept"));
  if (!updated) {
    graded.remarks.emplace_back("the baseline was left as it is: raising it needs --accept \"reason\"");
    return false;
  }
  write_output_file(*path, baseline.text());
  graded.against_baseline->comparison = Comparison::not_worse;
  return true;
}

const char* words_of(Comparison comparison) {
  switch (comparison) {
    case Comparison::not_worse:
      return "not worse";
    case Comparison::worse:
      return "WORSE";
    default:
      return "not comparable";
  }
}

std::string text_of(const Graded& graded) {
  std::string text = grade_text(graded.grade);
  if (graded.against_baseline)
    text += fmt::format("  baseline: {}: {}\n", words_of(graded.against_baseline->comparison),
                        graded.against_baseline->words);
  for (const std::string& remark : graded.remarks) text += "  " + remark + "\n";
  return text;
}

Json baseline_json(const Graded& graded) {
  if (!graded.against_baseline) return {};
  return {{"comparison", words_of(graded.against_baseline->comparison)},
          {"words", graded.against_baseline->words}};
}

Json json_of(const Graded& graded) {
  Json row = grade_json(graded.grade);
  row.append({{"baseline", baseline_json(graded)},
              {"remarks", json_list(graded.remarks, [](const std::string& remark) { return Json(remark); })},
              {"times", {{"seconds", graded.seconds}}}});
  return row;
}

JUnitCase junit_case(const Graded& graded, bool strict) {
  const Grade& grade = graded.grade;
  JUnitCase result{fmt::format("{} as {}, {}", grade.what, grade.found.quantity->name, grade.where),
                   graded.seconds, JUnitCase::Outcome::passed, "", text_of(graded)};
  if (!graded.kept(strict)) {
    result.outcome = JUnitCase::Outcome::failed;
    result.message = fmt::format("largest error found {:.4g} ulp, promised {:g}", grade.found.max_error_ulp,
                                 grade.found.promise);
    if (grade.found.kept()) result.message = "baseline: " + graded.against_baseline->words;
  } else if (graded.against_baseline && graded.against_baseline->comparison == Comparison::not_comparable) {
    result.outcome = JUnitCase::Outcome::skipped;
    result.message = "not comparable: " + graded.against_baseline->words;
  }
  return result;
}

}  // namespace

int grade_verb(const CommandLine& line, std::ostream& out) {
  refuse_what_needs_a_baseline(line);
  Graded graded = graded_file(line);
  const bool settled = settle_baseline(line, graded);
  const bool strict = line.has("strict");
  if (const auto junit = line.option("junit"))
    write_output_file(*junit, junit_text("nipref grade", {junit_case(graded, strict)}));
  if (line.json) {
    out << answer_text("grade", {{"rows", std::vector<Json>{json_of(graded)}}}, line.no_times);
  } else {
    out << text_of(graded);
  }
  return graded.kept(strict) && settled ? 0 : 1;
}

}  // namespace nipref::verify
