#include <fmt/format.h>

#include <cstdio>

#include <nipref/data/scene/file.hpp>
#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/options.hpp>
#include <nipref/verify/cli/solve_sweep.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/solve/likely_time.hpp>
#include <nipref/verify/solve/render.hpp>

namespace nipref::verify {
namespace {

/// 1 if something is not as accurate as was asked.
template <class Number>
int print(const SceneSolution<Number>& solution, const CommandLine& line, std::ostream& out) {
  out << (line.json ? answer_text("solve", solution_json(solution), line.no_times)
                    : solution_text(solution, line.has("full")));
  return solution.missed().empty() ? 0 : 1;
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

}  // namespace nipref::verify
