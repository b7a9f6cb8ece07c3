#include <cstdio>

#include <nipref/data/scene/file.hpp>
#include <nipref/verify/cli/sweep_rows.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/solve/energy_balance.hpp>
#include <nipref/verify/solve/solve.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

template <class Number>
VerbAnswer answer_of(const data::Scene& scene, const SceneSolution<Number>& solution, bool full) {
  Json answer = solution_json(solution, full);
  const auto step_json = [](const SearchStep& step) -> Json {
    return {{"contact_length", step.contact_length}, {"load", step.load}};
  };
  if (full) answer.set("search", json_list(thesis_search(scene), step_json));
  return {"solve", answer, solution.missed().empty()};
}

/// The axis of an assignment. A list as TOML writes it is one value, and so is a title.
Axis axis_of_assignment(const std::string& key, const std::string& text, std::size_t points) {
  const bool swept = key != "title" && !text.starts_with('[') && is_swept(text);
  return swept ? axis_of(key, text, points) : Axis{key, {{text, text}}};
}

/// The scene of a combination. TOML takes decimals; the decimals that are shown are read as the same doubles.
data::Scene scene_at(const data::SceneText& text, const AxesProduct& scenes, std::size_t number) {
  return data::load_scene(text, scenes.assignments(number, &AxisValue::shown));
}

std::string place_text(const std::optional<double>& place) { return place ? fmt::format("{}", *place) : ""; }

/// Adds a line for each number of each result, with its place, and lists for JSON.
template <class Number>
void add_lists(SweepRow& row, const SceneSolution<Number>& solution, const std::string& missed,
               const std::string& warnings) {
  const Json answer = solution_json(solution), results = answer.at("results");
  row.heads = {"result", "depth", "position", "value", "error", "missed", "warnings"};
  row.lines.clear();
  for (const auto& result : solution.results) {
    const std::string name(result.what->name);
    row.add(name, results.at(name).at("value"));
    row.add(name + "_error", results.at(name).at("error"));
    for (std::size_t i = 0; i < result.numbers.size(); ++i) {
      const auto [position, depth] = solution.place(*result.what, i);
      row.lines.push_back({name, place_text(depth), place_text(position), value_text(result.numbers[i]),
                           error_text(result.numbers[i]), missed, warnings});
    }
  }
  row.add("missed", missed);
  row.add("warnings", warnings);
  if (!solution.positions.empty()) row.add("positions", answer.at("positions"));
  const Json field = answer.at("field");
  for (const char* const places : {"positions", "depths"})
    if (!field.is_null()) row.add(fmt::format("field.{}", places), field.at(places));
}

template <class Number>
SweepRow row_of(const SceneSolution<Number>& solution) {
  SweepRow row;
  const auto missed = solution.missed();
  row.fell_short = !missed.empty();
  const std::string names = fmt::format("{}", fmt::join(missed, " "));
  const std::string warnings =
      fmt::format("{}", fmt::join(mapped(solution.warnings, &BeyondTheory::quantity), " "));
  if (std::ranges::any_of(solution.results,
                          [](const auto& result) { return result.what->shape != data::Shape::number; })) {
    add_lists(row, solution, names, warnings);
    return row;
  }
  const auto add = [&](const std::string& column, const std::string& text) {
    row.add(column, std::is_same_v<Number, ref::Estimate> ? Json(text) : Json::number(text), text);
  };
  for (const auto& result : solution.results) {
    const std::string name(result.what->name);
    add(name, value_text(result.numbers.front()));
    add(name + "_error", error_text(result.numbers.front()));
  }
  row.add("missed", Json::unless_empty(names), names);
  row.add("warnings", Json::unless_empty(warnings), warnings);
  return row;
}

/// The answer has a row for each combination: its results and errors, the names of the results that missed the
/// accuracy, and what is beyond linear theory. If a profile, a field or a list is wanted, there is a row for each
/// number with its place. Without `digits` fast solves the scenes. The answer falls short if a scene was refused or
/// missed its accuracy. BadInput if all are refused.
VerbAnswer solve_sweep(const data::SceneText& text, const AxesProduct& scenes, std::optional<int> digits,
                       const CommandLine& line) {
  const auto row_at = [&](std::size_t i) {
    const data::Scene scene = scene_at(text, scenes, i);
    return digits ? row_of(solve_by_ref(scene, *digits)) : row_of(solve(scene));
  };
  return swept({"solve_sweep", scenes, {{"path", digits ? "ref" : "fast"}}, row_at}, line);
}

Json estimate_json(const fast::Estimate& number) {
  return {{"value", number.value}, {"error", number.error}, {"proven", false}};
}

}  // namespace

AxesProduct swept_scenes(const data::SceneText& text, const CommandLine& line) {
  const data::SceneSweep sweep = data::scene_sweep(text);
  const bool points_are_in_file = sweep.points && !line.option("points");
  const std::size_t points =
      points_are_in_file ? static_cast<std::size_t>(*sweep.points) : line.count("points");
  std::vector<Axis> axes;
  for (const auto& [key, values] : sweep.keys) {
    if (std::ranges::find(line.assignments, key, &Assignments::value_type::first) == line.assignments.end())
      axes.push_back(axis_of(key, values, points));
  }
  for (const auto& [key, value] : line.assignments) axes.push_back(axis_of_assignment(key, value, points));
  return AxesProduct(std::move(axes));
}

VerbAnswer solve_verb(const CommandLine& line) {
  const auto [text, digits] = scene_request(line);
  const AxesProduct scenes = swept_scenes(text, line);
  if (scenes.size() > 1 || line.has("csv")) return solve_sweep(text, scenes, digits, line);
  refuse_option(line, "points", "has no effect without a range: must be left out");
  const data::Scene scene = scene_at(text, scenes, 0);
  if (!digits) return answer_of(scene, solve(scene), line.has("full"));
  if (!line.has("quiet")) fmt::print(stderr, "{}", warning_of_time(likely_seconds_by_ref(scene, *digits)));
  return answer_of(scene, solve_by_ref(scene, *digits), line.has("full"));
}

VerbAnswer balance_verb(const CommandLine& line) {
  const auto [text, digits] = scene_request(line);
  const EnergyBalance balance = energy_balance(data::load_scene(text, line.assignments), digits);
  const Json answer{{"title", balance.title},
                    {"path", digits ? "ref" : "fast"},
                    {"work", estimate_json(balance.work)},
                    {"loss", estimate_json(balance.loss)},
                    {"warnings", warnings_json(balance.warnings)},
                    {"difference", balance.difference()},
                    {"allowed", balance.allowed()},
                    {"met", balance.meets()},
                    {"times", {{"seconds", balance.seconds}}}};
  return {"balance", answer, balance.meets()};
}

}  // namespace nipref::verify
