#include <algorithm>
#include <filesystem>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/scene/file.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/options.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/solve/render.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

constexpr long default_digits = 30;

/// A file, or the name of an example where there is no such file.
std::filesystem::path scene_file_of(const CommandLine& line) {
  if (line.words.empty())
    throw BadInput("scene", "(missing)", "must be the name of a TOML file or of an example");
  if (line.words.size() > 1)
    throw BadInput("argument", line.words[1], "unexpected: solve takes one scene and key=value pairs");
  const std::filesystem::path word = line.words.front();
  const bool is_file = std::filesystem::exists(word) || word.has_parent_path() || word.has_extension();
  return is_file ? word : data::example_scene(word.string());
}

int digits_of(const CommandLine& line) {
  const auto text = line.option("digits");
  const long digits = text ? parse_integer("digits", *text) : default_digits;
  ref::check_digits(static_cast<int>(std::clamp(digits, -1L, 1'000'000'000L)));
  return static_cast<int>(digits);
}

/// 1 if something is not as accurate as was asked.
template <class Number>
int print(const SceneSolution<Number>& solution, const CommandLine& line, std::ostream& out) {
  out << (line.json ? answer_text("solve", solution_json(solution), line.no_times) : solution_text(solution));
  return solution.missed().empty() ? 0 : 1;
}

}  // namespace

int solve_verb(const CommandLine& line, std::ostream& out) {
  const std::string path = line.option("path").value_or("fast");
  if (path != "ref" && path != "fast") throw BadInput("path", path, "must be ref or fast");
  if (path == "fast")
    refuse_option(line, "digits", "has no effect with path=fast: must be left out, or path=ref given");
  const int digits = digits_of(line);
  const data::Scene scene = data::load_scene(scene_file_of(line), line.assignments);
  return path == "ref" ? print(solve_by_ref(scene, digits), line, out) : print(solve(scene), line, out);
}

}  // namespace nipref::verify
