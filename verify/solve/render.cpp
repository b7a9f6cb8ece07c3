#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <functional>

#include <nipref/verify/solve/render.hpp>
#include <nipref/verify/support/internal/number_text.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

bool is_proven(const fast::Estimate&) { return false; }
bool is_proven(const ref::Estimate& number) { return number.proven; }
/// A proven error is called a bound, and an estimated one an error.
std::string_view error_word(const auto& number) { return is_proven(number) ? "bound" : "error"; }

// In JSON a number of the reference is text: it may have more digits than a double, and an error below all doubles.
Json value_json(const fast::Estimate& number) { return number.value; }
Json error_json(const fast::Estimate& number) { return number.error; }
Json value_json(const ref::Estimate& number) { return number.value_text(); }
Json error_json(const ref::Estimate& number) { return number.error_text(); }

template <class Number>
Json values_json(const data::SceneResult& what, const std::vector<Number>& numbers,
                 Json (*json)(const Number&)) {
  return what.shape == data::Shape::number ? json(numbers.front()) : json_list(numbers, json);
}

Json counted(auto count) { return count > 0 ? Json(count) : Json(); }

/// Counts that are not known are null.
Json work_json(const fast::Work& work) {
  Json kernels = Json::object();
  for (std::size_t k = 0; k < work.kernel_evaluations.size(); ++k)
    kernels.set(fmt::format("I{}", k + 1), work.kernel_evaluations[k]);
  const bool is_counted = work.kernel_evaluations != fast::Work{}.kernel_evaluations;
  return {{"kernel_evaluations", is_counted ? kernels : Json()},
          {"terms", counted(work.terms)},
          {"unknowns", counted(work.unknowns)},
          {"systems", counted(work.systems)},
          {"line_responses", counted(work.line_responses)}};
}

bool is_empty(const fast::Work& work) { return work.unknowns == 0; }

std::string work_text(const fast::Work& work) {
  if (work.line_responses > 0) return fmt::format("the response of {} lines", work.line_responses);
  if (is_empty(work)) return "closed forms";
  std::string text;
  for (std::size_t k = 0; k < work.kernel_evaluations.size(); ++k) {
    if (work.kernel_evaluations[k] == 0) continue;
    text += fmt::format("{} values of I{}, ", work.kernel_evaluations[k], k + 1);
  }
  if (work.terms > 0) text += fmt::format("{} series terms, ", work.terms);
  if (work.systems > 0) text += fmt::format("{} systems of up to ", work.systems);
  return text + fmt::format("{} unknowns", work.unknowns);
}

template <class Number>
std::string number_text(const typename SceneSolution<Number>::Result& result, bool full) {
  const Number& number = result.numbers.front();
  const std::string text = fmt::format("  {:<23} {:<22} {} {:<8} {}\n", result.what->name, value_text(number),
                                       error_word(number), error_text(number), result.what->unit);
  return full ? text + fmt::format("    {}\n", result.what->meaning) : text;
}

/// What stands before a number of a list, a profile or a field: its place.
std::string place_text(const data::SceneResult& what, const std::vector<double>& positions,
                       const data::FieldPlaces& field, std::size_t i) {
  if (what.shape == data::Shape::list) return "    ";
  if (what.shape == data::Shape::profile)
    return fmt::format("    {} = {:<22} ", what.kind == data::SceneKind::half_space ? "psi" : "Y",
                       positions[i]);
  const std::size_t position = i % field.positions.size(), depth = i / field.positions.size();
  return (position == 0 ? fmt::format("    depth = {}\n", field.depths[depth]) : "") +
         fmt::format("      Y = {:<20} ", field.positions[position]);
}

template <class Number>
std::string result_text(const typename SceneSolution<Number>::Result& result,
                        const SceneSolution<Number>& solution, bool full) {
  if (result.what->shape == data::Shape::number) return number_text<Number>(result, full);
  std::string text =
      fmt::format("  {}: {}, unit {}\n", result.what->name, result.what->meaning, result.what->unit);
  for (std::size_t i = 0; i < result.numbers.size(); ++i) {
    const Number& number = result.numbers[i];
    text += place_text(*result.what, solution.positions, solution.field, i) +
            fmt::format("{:<22} {} {}\n", value_text(number), error_word(number), error_text(number));
  }
  return text;
}

/// The contact to which the errors are the distance.
template <class Number>
std::string_view truth_of(const SceneSolution<Number>& solution) {
  const bool is_of_ref = std::is_same_v<Number, ref::Estimate>;
  return solution.is_discrete && is_of_ref ? "discrete system" : "continuous contact";
}

Json field_json(const data::FieldPlaces& field) {
  if (field.positions.empty()) return {};
  return {{"positions", json_list(field.positions, std::identity())},
          {"depths", json_list(field.depths, std::identity())}};
}

/// Whether the accuracy is met, and to which contact the errors of line loads are the distance.
template <class Number>
std::string accuracy_text(const SceneSolution<Number>& solution) {
  const std::optional<bool> met = solution.met();
  std::string text = met ? met_text(solution.accuracy, *met) : "no accuracy is asked of line loads";
  if (met == false) text += fmt::format(" by {}: the best there is", fmt::join(solution.missed(), ", "));
  text += "\n";
  if (solution.is_discrete) text += fmt::format("errors are the distance to the {}\n", truth_of(solution));
  return text;
}

}  // namespace

std::string warnings_text(const std::vector<BeyondTheory>& warnings) {
  std::string text;
  for (const auto& [quantity, value, limit] : warnings)
    text += fmt::format("{}: {} is {:.2g}, above {:g}: linear theory is off by a part of about that size\n",
                        bad("warning"), quantity, value, limit);
  return text;
}

Json warnings_json(const std::vector<BeyondTheory>& warnings) {
  return json_list(warnings, [](const BeyondTheory& one) -> Json {
    return {{"quantity", one.quantity}, {"value", one.value}, {"limit", one.limit}};
  });
}

std::string value_text(const fast::Estimate& number) { return fmt::format("{:.15g}", number.value); }
std::string error_text(const fast::Estimate& number) { return upward_text(number.error); }
std::string value_text(const ref::Estimate& number) { return number.value_text(); }
std::string error_text(const ref::Estimate& number) { return number.error_text(); }

template <class Number>
std::string solution_text(const SceneSolution<Number>& solution, bool full) {
  std::string text = solution.title + "\n";
  text += accuracy_text(solution);
  text += warnings_text(solution.warnings);
  for (const auto& result : solution.results) text += result_text<Number>(result, solution, full);
  text += fmt::format("work: {}\n", work_text(solution.work));
  if (!is_empty(solution.error_work))
    text += fmt::format("for the error estimates: {}\n", work_text(solution.error_work));
  return folded(text + fmt::format("{:.2g} s\n", solution.seconds));
}

template <class Number>
Json solution_json(const SceneSolution<Number>& solution) {
  Json results = Json::object();
  for (const auto& result : solution.results) {
    results.set(result.what->name,
                {{"value", values_json<Number>(*result.what, result.numbers, value_json)},
                 {"error", values_json<Number>(*result.what, result.numbers, error_json)},
                 {"proven", std::ranges::all_of(result.numbers, [](const auto& x) { return is_proven(x); })},
                 {"met", result.met()},
                 {"unit", result.what->unit}});
  }
  const auto& positions = solution.positions;
  return {{"title", solution.title},
          {"path", std::is_same_v<Number, ref::Estimate> ? "ref" : "fast"},
          {"distance_to", truth_of(solution)},
          {"results", results},
          {"warnings", warnings_json(solution.warnings)},
          {"positions", positions.empty() ? Json() : json_list(positions, std::identity())},
          {"field", field_json(solution.field)},
          {"work", work_json(solution.work)},
          {"error_work", is_empty(solution.error_work) ? Json() : work_json(solution.error_work)},
          {"times", {{"seconds", solution.seconds}}}};
}

template std::string solution_text(const SceneSolution<fast::Estimate>&, bool);
template std::string solution_text(const SceneSolution<ref::Estimate>&, bool);
template Json solution_json(const SceneSolution<fast::Estimate>&);
template Json solution_json(const SceneSolution<ref::Estimate>&);

}  // namespace nipref::verify
