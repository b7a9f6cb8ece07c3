#include <cstdio>

#include <nipref/data/scene/file.hpp>
#include <nipref/data/scene/sweep.hpp>
#include <nipref/verify/cli/sweep_rows.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/solve/energy_balance.hpp>
#include <nipref/verify/solve/solve.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

/// 1 if something is not as accurate as was asked.
template <class Number>
int print(const data::Scene& scene, const SceneSolution<Number>& solution, const CommandLine& line,
          std::ostream& out) {
  const bool full = line.has("full");
  Json answer = solution_json(solution, full);
  const auto step_json = [](const SearchStep& step) -> Json {
    return {{"contact_length", step.contact_length}, {"load", step.load}};
  };
  if (full) answer.set("search", json_list(thesis_search(scene), step_json));
  return write_answer(line, out, "solve", solution.missed().empty(), answer, "solve.txt");
}

/// A list as TOML writes it is one value, and so is a title.
Axis axis_of_assignment(const std::string& key, const std::string& text, std::size_t points) {
  const bool swept = key != "title" && !text.starts_with('[') && is_swept(text);
  return swept ? axis_of(key, text, points) : Axis{key, {{text, text}}};
}

/// A decimal, which is what TOML takes, means the same double.
data::Scene scene_at(const data::SceneText& text, const AxesProduct& scenes, std::size_t number) {
  return data::load_scene(text, scenes.assignments(number, &AxisValue::shown));
}

/// The first scene that is none to be refused; BadInput, the first one's, if all are.
data::Scene first_scene(const data::SceneText& text, const AxesProduct& scenes) {
  std::optional<BadInput> refused;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    try {
      return scene_at(text, scenes, i);
    } catch (const BadInput& error) {
      if (!refused) refused = error;
    }
  }
  throw BadInput(*refused);
}

std::vector<std::string> columns_of(const data::Scene& scene) {
  std::vector<std::string> columns;
  for (const data::ResultId id : scene.wanted) {
    columns.emplace_back(data::scene_result(id).name);
    columns.push_back(columns.back() + "_error");
  }
  columns.insert(columns.end(), {"missed", "warnings"});
  if (wants(scene, data::Shape::profile)) columns.emplace_back("positions");
  if (wants(scene, data::Shape::field)) columns.insert(columns.end(), {"field.positions", "field.depths"});
  return columns;
}

const std::vector<std::string> heads_of_numbers{"result", "depth",  "position", "value",
                                                "error",  "missed", "warnings"};

std::string place_text(const std::optional<double>& place) { return place ? fmt::format("{}", *place) : ""; }

/// A line for each number of each result, with its place, and lists for JSON.
template <class Number>
void add_lists(SweepRow& row, const SceneSolution<Number>& solution, const std::string& missed,
               const std::string& warnings) {
  const Json answer = solution_json(solution);
  for (const auto& result : solution.results) {
    const Json numbers = answer.at("results").at(result.what->name);
    row.values.insert(row.values.end(), {numbers.at("value"), numbers.at("error")});
    for (std::size_t i = 0; i < result.numbers.size(); ++i) {
      const auto [position, depth] = solution.place(*result.what, i);
      row.lines.push_back({std::string(result.what->name), place_text(depth), place_text(position),
                           value_text(result.numbers[i]), error_text(result.numbers[i]), missed, warnings});
    }
  }
  row.values.insert(row.values.end(), {missed, warnings});
  if (!solution.positions.empty()) row.values.push_back(answer.at("positions"));
  if (const Json field = answer.at("field"); !field.is_null())
    row.values.insert(row.values.end(), {field.at("positions"), field.at("depths")});
}

template <class Number>
SweepRow row_of(const SceneSolution<Number>& solution, bool has_lists) {
  SweepRow row;
  const auto missed = solution.missed();
  row.fell_short = !missed.empty();
  const std::string names = fmt::format("{}", fmt::join(missed, " "));
  const std::string warnings =
      fmt::format("{}", fmt::join(mapped(solution.warnings, &BeyondTheory::quantity), " "));
  if (has_lists) {
    add_lists(row, solution, names, warnings);
    return row;
  }
  for (const auto& result : solution.results) {
    for (const std::string& text : {value_text(result.numbers.front()), error_text(result.numbers.front())})
      row.add(text, std::is_same_v<Number, ref::Estimate> ? Json(text) : Json::number(text));
  }
  row.add(names, Json::unless_empty(names));
  row.add(warnings, Json::unless_empty(warnings));
  return row;
}

/// A row for each combination with its results and errors, with the names of those that missed the accuracy, and with
/// what is beyond linear theory; where a profile, a field or a list is wanted, a row for each number with its place.
/// digits: of ref; nothing: by fast. 1 if a scene was refused or missed its accuracy. BadInput if all are refused.
int solve_sweep(const data::SceneText& text, const AxesProduct& scenes, std::optional<int> digits,
                const CommandLine& line, std::ostream& out) {
  const data::Scene first = first_scene(text, scenes);
  const bool has_lists = std::ranges::any_of(
      first.wanted, [](data::ResultId id) { return data::scene_result(id).shape != data::Shape::number; });
  const std::vector<std::string> columns = columns_of(first);
  const Sweep sweep{"solve_sweep",
                    scenes,
                    columns,
                    {{"path", digits ? "ref" : "fast"}},
                    has_lists ? heads_of_numbers : columns,
                    [&](std::size_t i) {
                      const data::Scene scene = scene_at(text, scenes, i);
                      return digits ? row_of(solve_by_ref(scene, *digits), has_lists)
                                    : row_of(solve(scene), has_lists);
                    }};
  return write_sweep(sweep, line, out);
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

int solve_verb(const CommandLine& line, std::ostream& out) {
  const auto [text, digits] = scene_request(line);
  const AxesProduct scenes = swept_scenes(text, line);
  if (scenes.size() > 1 || line.has("csv")) return solve_sweep(text, scenes, digits, line, out);
  refuse_option(line, "points", "has no effect without a range: must be left out");
  const data::Scene scene = scene_at(text, scenes, 0);
  if (!digits) return print(scene, solve(scene), line, out);
  if (!line.has("quiet")) fmt::print(stderr, "{}", warning_of_time(likely_seconds_by_ref(scene, *digits)));
  return print(scene, solve_by_ref(scene, *digits), line, out);
}

int balance_verb(const CommandLine& line, std::ostream& out) {
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
  return write_answer(line, out, "balance", balance.meets(), answer, "balance.txt");
}

}  // namespace nipref::verify
