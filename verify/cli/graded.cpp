#include <cctype>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/cli/graded.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/golden/golden.hpp>
#include <nipref/verify/golden/make.hpp>
#include <nipref/verify/support/internal/template.hpp>

namespace nipref::verify {
namespace {

Json baseline_json(const Graded& graded) {
  if (!graded.against_baseline) return {};
  return {{"comparison", graded.against_baseline->verdict}, {"words", graded.against_baseline->words}};
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
  if (!graded.is_kernel) return {{"seconds", graded.seconds}};
  return {{"seconds", graded.seconds},
          {"to_fast", speed_json(graded.to_fast, "fast")},
          {"to_older", older_json(graded.to_older)}};
}

/// Whether the fault is an error in JUnit's sense, because it ends the process. Other faults are failures.
bool is_error(const Fault& fault) {
  using enum FaultKind;
  return fault.kind == crash || fault.kind == exit || fault.kind == hang || fault.kind == protocol ||
         fault.kind == given_up;
}

std::string promised_by(const Graded& graded) {
  return graded.promised.empty() ? fmt::format("{:g} ulp", graded.grade.found.promise) : graded.promised;
}

std::string why_not_kept(const Graded& graded) {
  const Grade& grade = graded.grade;
  if (!graded.faults.empty()) {
    const Fault& first = graded.faults.front();
    return fmt::format("{}{}: {}", name_of(first.kind),
                       first.point ? " at" + point_text(*grade.found.quantity, *first.point) : "",
                       first.words);
  }
  if (!grade.found.kept())
    return fmt::format("largest error found {:.4g} ulp, promised {}", grade.found.max_error_ulp,
                       promised_by(graded));
  if (graded.to_older && !graded.to_older->kept()) return "slower than " + graded.to_older->older;
  return fmt::format("baseline: {}: {}", graded.against_baseline->verdict, graded.against_baseline->words);
}

/// The value beside the truth, with a bar behind the digits that agree.
Json own_json(const Graded& graded) {
  if (!graded.own) return {};
  const double value = std::strtod(graded.grade.worst_value.c_str(), nullptr);
  std::string own = fmt::format("{:.16e}", *graded.own);
  const std::string truth = fmt::format("{:.16e}", value);
  const std::size_t exponent = std::min(own.find('e'), own.size());
  std::size_t same = 0;
  if (own.substr(exponent) == truth.substr(std::min(truth.find('e'), truth.size())))
    same = static_cast<std::size_t>(std::ranges::mismatch(own, truth).in1 - own.begin());
  const auto digits =
      std::count_if(own.begin(), own.begin() + static_cast<std::ptrdiff_t>(std::min(same, exponent)),
                    [](unsigned char letter) { return std::isdigit(letter) != 0; });
  if (same < own.size()) own.insert(same, "|");
  return {{"value", *graded.own},
          {"agreeing_digits", digits},
          {"error", std::fabs(*graded.own - value)},
          {"_marked", own}};
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

/// A test case of JUnit, where times are decimals without exponents, and a message is one line.
Json case_json(const Graded& graded) {
  const Grade& grade = graded.grade;
  const bool errs = std::ranges::any_of(graded.faults, is_error);
  const Json why = graded.kept() ? Json() : Json(why_not_kept(graded));
  return {{"name", fmt::format("{} as {}, {}", grade.what, grade.found.quantity->name, grade.where)},
          {"seconds", graded.seconds},
          {"failure", errs ? Json() : why},
          {"error", errs ? why : Json()},
          {"details", graded_text(graded)}};
}

}  // namespace

bool Graded::kept() const {
  return grade.found.kept() && faults.empty() && (!to_older || to_older->kept()) &&
         (!against_baseline || against_baseline->kept());
}

std::string take_promise(const CommandLine& line, AuditOptions& options) {
  const auto text = line.option("promise");
  if (!text) return "";
  const auto in_unit = [&](std::string_view unit) { return text->ends_with(unit); };
  const bool has_unit = in_unit("ulp") || in_unit("rel") || in_unit("abs");
  const double amount = parse_real("promise", text->substr(0, text->size() - (has_unit ? 3 : 0)));
  const bool is_relative = in_unit("rel") || (!has_unit && amount < 0.5);
  if (!(amount > 0) || (is_relative && (amount >= 1 || amount < fast::Accuracy::best_rtol)))
    throw data::BadInput(
        "promise", *text,
        "must be a number > 0: units in the last place as 4 or 4ulp, a part of the scale as 1e-6 or "
        "0.1rel, at least 4.44e-16, or in the quantity's unit as 1e-9abs");
  options.promise = 0;
  if (is_relative) {
    options.accuracy = fast::Accuracy(amount);
    return fmt::format("{:g} of the scale", amount);
  }
  (in_unit("abs") ? options.absolute : *options.promise) = amount;
  return fmt::format("{:g}{}", amount, in_unit("abs") ? " at all sizes" : " ulp");
}

std::string graded_text(const Graded& graded) { return text_of("grade.txt", graded_json(graded)); }

Json graded_json(const Graded& graded) {
  Json row = grade_json(graded.grade);
  row.append({{"promise", promised_by(graded)},
              {"own", own_json(graded)},
              {"baseline", baseline_json(graded)},
              {"faults", faults_json(*graded.grade.found.quantity, graded.faults)},
              {"remarks", json_list(graded.remarks)},
              {"times", times_json(graded)},
              {"_kernel", graded.is_kernel},
              {"_faulty", !graded.faults.empty()}});
  return row;
}

std::string junit_text(const std::vector<Graded>& all) {
  const std::vector<Json> cases = mapped(all, case_json);
  const auto count = [&](const char* outcome) {
    return std::ranges::count_if(cases, [&](const Json& one) { return !one.at(outcome).is_null(); });
  };
  double seconds = 0;
  for (const Graded& graded : all) seconds += graded.seconds;
  return text_of("junit.xml",
                 {{"tests", all.size()},
                  {"failures", count("failure")},
                  {"errors", count("error")},
                  {"seconds", seconds},
                  {"cases", cases}},
                 escaped_for_html);
}

void keep_worst(const std::string& path, const Graded& graded) {
  const AuditResult& found = graded.grade.found;
  const Quantity& quantity = *found.quantity;
  GoldenFile file = kept_file(path, quantity);
  if (std::ranges::find(file.rows, found.worst, &GoldenRow::arguments) != file.rows.end()) return;
  GoldenRow row = golden_row(quantity, found.worst, ref_value(quantity, found.worst, kept_digits));
  row.origin = "worst:" + graded.grade.what;
  // The row is kept even if no second method confirms its value, because it is the point that matters here.
  static_cast<void>(confirm_row(quantity, row));
  file.rows.push_back(std::move(row));
  replace_output_file(path, golden_text(file));
}

}  // namespace nipref::verify
