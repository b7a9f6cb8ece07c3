#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/options.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/solve/render.hpp>

namespace nipref::verify {
namespace {

/// 1 if something is not as accurate as was asked.
template <class Number>
int print(const SceneSolution<Number>& solution, const CommandLine& line, std::ostream& out) {
  out << (line.json ? answer_text("solve", solution_json(solution), line.no_times) : solution_text(solution));
  return solution.missed().empty() ? 0 : 1;
}

}  // namespace

int solve_verb(const CommandLine& line, std::ostream& out) {
  const auto [scene, digits] = scene_request(line, "solve", 30);
  return digits ? print(solve_by_ref(scene, *digits), line, out) : print(solve(scene), line, out);
}

}  // namespace nipref::verify
