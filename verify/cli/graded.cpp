#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/cli/graded.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/golden/golden.hpp>
#include <nipref/verify/golden/make.hpp>

namespace nipref::verify {
namespace {

const char* words_of(Comparison comparison) {
  return comparison == Comparison::not_worse ? "not worse"
         : comparison == Comparison::worse   ? "WORSE"
                                             : "not comparable";
}

Json baseline_json(const Graded& graded) {
  if (!graded.against_baseline) return {};
  return {{"comparison", words_of(graded.against_baseline->comparison)},
          {"words", graded.against_baseline->words}};
}

Json speed_json(const std::optional<Speed>& speed, const std::string& other) {
  if (!speed) return {};
  return {{"nanoseconds", speed->nanoseconds}, {"other_nanoseconds", speed->other_nanoseconds},
          {"lower_ratio", speed->lower_ratio}, {"ratio", speed->ratio},
          {"upper_ratio", speed->upper_ratio}, {"_other", other}};
}

Json older_json(const std::optional<Slowdown>& older) {
  if (!older) return {};
  return {{"file", older->older},
          {"allowed_slowdown", older->allowed},
          {"passed", older->kept()},
          {"speed", speed_json(older->speed, older->older)}};
}

Json times_json(const Graded& graded) {
  Json times{{"seconds", graded.seconds}};
  if (const auto& behaviour = graded.behaviour)
    times.append(
        {{"to_fast", speed_json(behaviour->to_fast, "fast")}, {"to_older", older_json(behaviour->to_older)}});
  return times;
}

/// What ends a process is an error of the test's subject, not a value that is wrong.
bool is_error(const Fault& fault) {
  using enum FaultKind;
  return fault.kind == crash || fault.kind == exit || fault.kind == hang || fault.kind == protocol ||
         fault.kind == given_up;
}

std::string why_not_kept(const Graded& graded) {
  const Grade& grade = graded.grade;
  if (graded.behaviour && !graded.behaviour->faults.empty()) {
    const Fault& first = graded.behaviour->faults.front();
    return fmt::format("{}{}: {}", name_of(first.kind),
                       first.point ? " at" + point_text(*grade.found.quantity, *first.point) : "",
                       first.words);
  }
  if (!grade.found.kept())
    return fmt::format("largest error found {:.4g} ulp, promised {:g}", grade.found.max_error_ulp,
                       grade.found.promise);
  if (graded.behaviour && !graded.behaviour->kept())
    return "slower than " + graded.behaviour->to_older->older;
  return fmt::format("baseline: {}: {}", words_of(graded.against_baseline->comparison),
                     graded.against_baseline->words);
}

constexpr int kept_digits = 50;

GoldenFile kept_file(const std::string& path, const Quantity& quantity) {
  std::error_code none;
  if (!std::filesystem::exists(path, none))
    return {{{{"quantity", quantity.name}, {"unit", quantity.unit}, {"digits", std::to_string(kept_digits)}}},
            {}};
  GoldenFile file = read_golden(path);
  if (file.entry("quantity") != quantity.name)
    throw data::BadInput("keep-worst", path, "must be a file of " + quantity.name + ", or none yet");
  return file;
}

}  // namespace

bool Graded::kept() const {
  if (!grade.found.kept() || (behaviour && !behaviour->kept())) return false;
  return !against_baseline || against_baseline->comparison == Comparison::not_worse;
}

std::string graded_text(const Graded& graded) { return text_of("grade.txt", graded_json(graded)); }

Json graded_json(const Graded& graded) {
  Json row = grade_json(graded.grade);
  const std::vector<Fault> none;
  row.append({{"baseline", baseline_json(graded)},
              {"faults",
               faults_json(*graded.grade.found.quantity, graded.behaviour ? graded.behaviour->faults : none)},
              {"remarks", json_list(graded.remarks)},
              {"times", times_json(graded)},
              {"_behaviour", graded.behaviour.has_value()},
              {"_faulty", graded.behaviour && !graded.behaviour->faults.empty()}});
  return row;
}

JUnitCase junit_case(const Graded& graded) {
  const Grade& grade = graded.grade;
  JUnitCase result{fmt::format("{} as {}, {}", grade.what, grade.found.quantity->name, grade.where),
                   graded.seconds, JUnitCase::Outcome::passed, "", graded_text(graded)};
  if (!graded.kept()) {
    const bool error = graded.behaviour && std::ranges::any_of(graded.behaviour->faults, is_error);
    result.outcome = error ? JUnitCase::Outcome::error : JUnitCase::Outcome::failed;
    result.message = why_not_kept(graded);
  }
  return result;
}

void keep_worst(const std::string& path, const Graded& graded) {
  const AuditResult& found = graded.grade.found;
  const Quantity& quantity = *found.quantity;
  GoldenFile file = kept_file(path, quantity);
  if (std::ranges::find(file.rows, found.worst, &GoldenRow::arguments) != file.rows.end()) return;
  GoldenRow row = golden_row(quantity, found.worst, ref_value(quantity, found.worst, kept_digits));
  row.origin = "worst:" + graded.grade.what;
  // What no second method confirms is kept too, without one: the point is what matters here.
  static_cast<void>(confirm_row(quantity, row));
  file.rows.push_back(std::move(row));
  replace_output_file(path, golden_text(quantity, file));
}

}  // namespace nipref::verify
