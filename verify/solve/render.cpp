#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/internal/number_text.hpp>

namespace nipref::verify {
namespace {

/// A number in JSON. A number of the reference is a text: it may have more digits than a double, and a smaller error.
struct Shown {
  Json value, error;
  bool proven;
};
Shown shown(const fast::Estimate& number) { return {number.value, number.error, false}; }
Shown shown(const ref::Estimate& number) { return {number.value_text(), number.error_text(), number.proven}; }

/// The numbers of a result: one, a list, or for a field a list for each depth.
Json list_json(const data::SceneResult& what, const std::vector<Shown>& numbers,
               const data::FieldPlaces& field, Json Shown::*part) {
  if (what.shape == data::Shape::number) return numbers.front().*part;
  if (what.shape != data::Shape::field) return json_list(numbers, part);
  const std::size_t across = field.positions.size();
  std::vector<Json> depths;
  for (std::size_t first = 0; first < numbers.size(); first += across)
    depths.push_back(json_list(std::span(numbers).subspan(first, across), part));
  return depths;
}

Json counted(auto count) { return count > 0 ? Json(count) : Json(); }

/// Counts that are not known are null.
Json work_json(const fast::Work& work) {
  Json kernels = Json::object();
  std::vector<Json> evaluated;
  for (std::size_t k = 0; k < work.kernel_evaluations.size(); ++k) {
    const std::uint64_t count = work.kernel_evaluations[k];
    const std::string name = fmt::format("I{}", k + 1);
    kernels.set(name, count);
    if (count > 0) evaluated.push_back({{"name", name}, {"count", count}});
  }
  return {{"kernel_evaluations", evaluated.empty() ? Json() : kernels},
          {"terms", counted(work.terms)},
          {"unknowns", counted(work.unknowns)},
          {"systems", counted(work.systems)},
          {"line_responses", counted(work.line_responses)},
          {"_evaluated", evaluated}};
}

/// The numbers of a result as the text shows them, in a profile or a field each with its place; `next_depth` is set at
/// the first number of each depth.
template <class Number>
std::vector<Json> numbers_json(const SceneSolution<Number>& solution,
                               const typename SceneSolution<Number>::Result& result,
                               const std::vector<Shown>& numbers) {
  return mapped(std::views::iota(std::size_t{0}, result.numbers.size()), [&](std::size_t i) {
    const Number& number = result.numbers[i];
    const auto [position, depth] = solution.place(*result.what, i);
    const bool is_first = depth && i % solution.field.positions.size() == 0;
    return Json{{"value", value_text(number)},
                {"error", error_text(number)},
                {"error_word", numbers[i].proven ? "bound" : "error"},
                {"position", position},
                {"depth", depth},
                {"next_depth", is_first ? Json(depth) : Json()}};
  });
}

/// The solution from which the errors measure the distance.
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
    const auto numbers = mapped(result.numbers, [](const Number& number) { return shown(number); });
    const std::vector<Json> texts = numbers_json(solution, result, numbers);
    results.set(what.name, {{"value", list_json(what, numbers, solution.field, &Shown::value)},
                            {"error", list_json(what, numbers, solution.field, &Shown::error)},
                            {"proven", std::ranges::all_of(numbers, &Shown::proven)},
                            {"met", result.met()},
                            {"unit", what.unit},
                            {"_meaning", what.meaning},
                            {"_measured_against", data::text(what.scale)},
                            {"_axis", what.is_along_line() ? "Y" : "psi"},
                            {"_one", what.shape == data::Shape::number ? texts.front() : Json()},
                            {"_numbers", texts}});
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
          {"error_work", solution.error_work.unknowns == 0 ? Json() : work_json(solution.error_work)},
          {"times", {{"seconds", solution.seconds}}},
          {"_full", full},
          {"_accuracy", met ? Json(fmt::format("{:g}", solution.accuracy)) : Json()},
          {"_met", met},
          {"_missed", json_list(solution.missed())},
          {"_discrete", solution.is_discrete}};
}

template Json solution_json(const SceneSolution<fast::Estimate>&, bool);
template Json solution_json(const SceneSolution<ref::Estimate>&, bool);

}  // namespace nipref::verify
