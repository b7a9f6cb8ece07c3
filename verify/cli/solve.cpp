#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>

#include <nipref/data/scene/file.hpp>
#include <nipref/data/scene/sweep.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/sweep_rows.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/solve/energy_balance.hpp>
#include <nipref/verify/solve/likely_time.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/mapped.hpp>

namespace nipref::verify {

namespace {

/// 1 if something is not as accurate as was asked.
template <class Number>
int print(const SceneSolution<Number>& solution, const CommandLine& line, std::ostream& out) {
  return write_answer(line, out, "solve", solution.missed().empty(),
                      solution_json(solution, line.has("full")), "solve.txt");
}

}  // namespace

int solve_verb(const CommandLine& line, std::ostream& out) {
  const auto [text, digits] = scene_request(line);
  const AxesProduct scenes = swept_scenes(text, line);
  if (scenes.size() > 1) return solve_sweep(text, scenes, digits, line, out);
  refuse_option(line, "points", "has no effect without a range: must be left out");
  const data::Scene scene = data::load_scene(text, scenes.assignments(0, &AxisValue::shown));
  if (!digits) return print(solve(scene), line, out);
  if (!line.has("quiet")) fmt::print(stderr, "{}", warning_of_time(likely_seconds_by_ref(scene, *digits)));
  return print(solve_by_ref(scene, *digits), line, out);
}

namespace {

using data::BadInput;

/// A list as TOML writes it is one value, and so is a title.
Axis axis_of_assignment(const std::string& key, const std::string& text, std::size_t points) {
  const bool swept = key != "title" && !text.starts_with('[') && is_swept(text);
  return swept ? axis_of(key, text, points) : Axis{key, {{text, text}}};
}

/// The first scene that is none to be refused; BadInput, the first one's, if all are.
data::Scene first_scene(const data::SceneText& text, const AxesProduct& scenes) {
  std::optional<BadInput> refused;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    try {
      return data::load_scene(text, scenes.assignments(i, &AxisValue::shown));
    } catch (const BadInput& error) {
      if (!refused) refused = error;
    }
  }
  throw BadInput(*refused);
}

std::vector<SweepColumn> columns_of(const data::Scene& scene, bool by_ref) {
  std::vector<SweepColumn> columns;
  for (const data::ResultId id : scene.wanted) {
    const data::SceneResult& what = data::scene_result(id);
    if (what.shape != data::Shape::number) {
      const char* const shape = what.shape == data::Shape::list      ? "list"
                                : what.shape == data::Shape::profile ? "profile"
                                                                     : "field";
      scene.origin.refuse("wanted", what.name,
                          fmt::format("must be left out with a sweep: it is a {}", shape));
    }
    columns.push_back({std::string(what.name), by_ref});
    columns.push_back({std::string(what.name) + "_error", by_ref});
  }
  columns.push_back({"missed", true});
  columns.push_back({"warnings", true});
  return columns;
}

template <class Number>
SweepRow row_of(const SceneSolution<Number>& solution) {
  SweepRow row;
  for (const auto& result : solution.results) {
    row.cells.push_back(value_text(result.numbers.front()));
    row.cells.push_back(error_text(result.numbers.front()));
  }
  const auto missed = solution.missed();
  row.cells.push_back(fmt::format("{}", fmt::join(missed, " ")));
  row.cells.push_back(fmt::format("{}", fmt::join(mapped(solution.warnings, &BeyondTheory::quantity), " ")));
  row.fell_short = !missed.empty();
  return row;
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

int solve_sweep(const data::SceneText& text, const AxesProduct& scenes, std::optional<int> digits,
                const CommandLine& line, std::ostream& out) {
  const data::Scene first = first_scene(text, scenes);
  const Sweep sweep{"solve_sweep",
                    scenes,
                    columns_of(first, digits.has_value()),
                    {{"path", digits ? "ref" : "fast"}},
                    [&](std::size_t i) {
                      // A decimal, which is what TOML takes, means the same double.
                      const data::Scene scene =
                          data::load_scene(text, scenes.assignments(i, &AxisValue::shown));
                      return digits ? row_of(solve_by_ref(scene, *digits)) : row_of(solve(scene));
                    }};
  return write_sweep(sweep, line, out);
}

namespace {

Json estimate_json(const fast::Estimate& number) {
  return {{"value", number.value}, {"error", number.error}, {"proven", false}};
}

Json balance_json(const EnergyBalance& balance, const std::string& path) {
  return {{"title", balance.title},
          {"path", path},
          {"work", estimate_json(balance.work)},
          {"loss", estimate_json(balance.loss)},
          {"warnings", warnings_json(balance.warnings)},
          {"difference", balance.difference()},
          {"allowed", balance.allowed()},
          {"met", balance.meets()},
          {"times", {{"seconds", balance.seconds}}}};
}

}  // namespace

int balance_verb(const CommandLine& line, std::ostream& out) {
  const SceneRequest request = scene_request(line);
  const EnergyBalance balance =
      energy_balance(data::load_scene(request.scene, line.assignments), request.digits);
  return write_answer(line, out, "balance", balance.meets(),
                      balance_json(balance, request.digits ? "ref" : "fast"), "balance.txt");
}

}  // namespace nipref::verify
