#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/internal/number_text.hpp>

namespace nipref::verify {
namespace {

bool is_proven(const fast::Estimate&) { return false; }
bool is_proven(const ref::Estimate& number) { return number.proven; }

// In JSON a number of the reference is text: it may have more digits than a double, and an error below all doubles.
Json value_json(const fast::Estimate& number) { return number.value; }
Json error_json(const fast::Estimate& number) { return number.error; }
Json value_json(const ref::Estimate& number) { return number.value_text(); }
Json error_json(const ref::Estimate& number) { return number.error_text(); }

/// One, a list, or of a field a list for each depth.
template <class Number>
Json values_json(const data::SceneResult& what, const std::vector<Number>& numbers,
                 const data::FieldPlaces& field, Json (*json)(const Number&)) {
  if (what.shape == data::Shape::number) return json(numbers.front());
  if (what.shape != data::Shape::field) return json_list(numbers, json);
  const std::size_t across = field.positions.size();
  std::vector<Json> depths;
  for (std::size_t first = 0; first < numbers.size(); first += across)
    depths.push_back(json_list(std::span(numbers).subspan(first, across), json));
  return depths;
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

/// What stands before a number of a list, a profile or a field: its place. The first of each depth also has the depth.
template <class Number>
Json place_json(const SceneSolution<Number>& solution, const data::SceneResult& what, std::size_t i) {
  const auto [position, depth] = solution.place(what, i);
  std::string text;
  if (depth) {
    text = fmt::format("  Y = {:<20} ", *position);
  } else if (position) {
    text = fmt::format("{} = {:<22} ", what.is_along_line() ? "Y" : "psi", *position);
  }
  const bool is_first = depth && i % solution.field.positions.size() == 0;
  return {{"place", text}, {"next_depth", is_first ? Json(fmt::format("{}", *depth)) : Json()}};
}

/// The numbers of a result as the text shows them, each with its place.
template <class Number>
std::vector<Json> shown_numbers(const SceneSolution<Number>& solution,
                                const typename SceneSolution<Number>::Result& result) {
  return mapped(std::views::iota(std::size_t{0}, result.numbers.size()), [&](std::size_t i) {
    const Number& number = result.numbers[i];
    Json shown{{"value", value_text(number)},
               {"error", error_text(number)},
               {"error_word", is_proven(number) ? "bound" : "error"}};
    shown.append(place_json(solution, *result.what, i));
    return shown;
  });
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

}  // namespace

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
Json solution_json(const SceneSolution<Number>& solution, bool full) {
  Json results = Json::object();
  for (const auto& result : solution.results) {
    const data::SceneResult& what = *result.what;
    const std::vector<Json> shown = shown_numbers(solution, result);
    results.set(what.name,
                {{"value", values_json<Number>(what, result.numbers, solution.field, value_json)},
                 {"error", values_json<Number>(what, result.numbers, solution.field, error_json)},
                 {"proven", std::ranges::all_of(result.numbers, [](const auto& x) { return is_proven(x); })},
                 {"met", result.met()},
                 {"unit", what.unit},
                 {"_meaning", what.meaning},
                 {"_measured_against", data::text(what.scale)},
                 {"_one", what.shape == data::Shape::number ? shown.front() : Json()},
                 {"_numbers", shown}});
  }
  const auto& positions = solution.positions;
  const std::optional<bool> met = solution.met();
  return {{"title", solution.title},
          {"path", std::is_same_v<Number, ref::Estimate> ? "ref" : "fast"},
          {"distance_to", truth_of(solution)},
          {"results", results},
          {"warnings", warnings_json(solution.warnings)},
          {"positions", positions.empty() ? Json() : json_list(positions, std::identity())},
          {"field", field_json(solution.field)},
          {"work", work_json(solution.work)},
          {"error_work", is_empty(solution.error_work) ? Json() : work_json(solution.error_work)},
          {"times", {{"seconds", solution.seconds}}},
          {"_full", full},
          {"_accuracy", met ? Json(fmt::format("{:g}", solution.accuracy)) : Json()},
          {"_met", met},
          {"_missed", json_list(solution.missed())},
          {"_discrete", solution.is_discrete},
          {"_work", work_text(solution.work)},
          {"_error_work", is_empty(solution.error_work) ? Json() : Json(work_text(solution.error_work))}};
}

template Json solution_json(const SceneSolution<fast::Estimate>&, bool);
template Json solution_json(const SceneSolution<ref::Estimate>&, bool);

}  // namespace nipref::verify
