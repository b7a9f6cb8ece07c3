// Scenes that both paths solve: fast is within the errors of the reference; the reference has the requested digits and
// proves, for each kind of contact, what the pages say.
#include <nipref/data/directory.hpp>
#include <nipref/data/scene/results.hpp>

#include "support/covered.hpp"
#include "support/proven_pages.hpp"
#include "support/solved_scene.hpp"
#include "support/table_rows.hpp"

using namespace nipref;

namespace {

const std::map<std::string, std::string> several_results{
    {"{loads}",
     R"(["contact_length","load","indentation","edge_displacement","creep_ratio","peak_pressure","peak_shear",
     "pressure","shear","normal_displacement","tangential_displacement"])"},
    {"{inside}", R"(["stress_across","stress_along","stress_shear","highest_stress","maximum_shear"])"}};

/// The row of the pages about the kind of contact with this example.
const TableRow& kind_of_example(const std::string& example) {
  static const std::vector<TableRow> kinds = rows_of_proven("contact");
  const auto kind = std::ranges::find(kinds, example, [](const TableRow& row) { return row.at(1); });
  REQUIRE(kind != kinds.end());
  return *kind;
}

/// Checks that these results are proven, and no others.
void check_proven(const verify::SceneSolution<ref::Estimate>& solution,
                  const std::vector<std::string>& proven) {
  for (const auto& result : solution.results) {
    CAPTURE(result.what->name);
    const bool is_proven =
        std::ranges::all_of(result.numbers, [](const ref::Estimate& number) { return number.proven; });
    CHECK(is_proven == (std::ranges::find(proven, result.what->name) != proven.end()));
  }
}

/// The scene of a line of both_paths.txt.
data::Scene scene_of(const std::string& line) {
  std::istringstream words(line);
  std::string example, word;
  words >> example;
  data::SceneOverrides overrides;
  while (words >> word) {
    if (word == "{kind}") continue;
    const std::string value = word.substr(word.find('=') + 1);
    const auto known = several_results.find(value);
    overrides.emplace_back(word.substr(0, word.find('=')),
                           known == several_results.end() ? value : known->second);
  }
  data::Scene scene = loaded_example(example, overrides);
  if (!contains(line, "{kind}")) return scene;
  if (!contains(line, "profile."))
    std::visit([](auto& problem) { problem.profile = data::Positions{{0.01}}; }, scene.system);
  const TableRow& kind = kind_of_example(example);
  scene.wanted.clear();
  for (const std::string& name : names_in(kind[2] + kind[3])) {
    const data::SceneResult& result = *data::find_scene_result(name);
    if (!result.is_inside()) scene.wanted.push_back(result.id);  // stresses inside take long
  }
  return scene;
}

/// Checks line loads, whose errors are distances to the continuous contact: both paths agree to the accuracy.
void check_same(const BothPaths& solved, double accuracy) {
  for (std::size_t r = 0; r < solved.fast.results.size(); ++r) {
    const auto& numbers = solved.fast.results[r].numbers;
    const auto& truths = solved.ref.results[r].numbers;
    CAPTURE(solved.fast.results[r].what->name);
    double size = 1e-4;
    for (const fast::Estimate& number : numbers) size = std::max(size, std::fabs(number.value));
    for (std::size_t i = 0; i < numbers.size(); ++i)
      CHECK(std::fabs(truths[i].error_of(numbers[i].value)) <= 100 * accuracy * size);
  }
}

}  // namespace

TEST_CASE(
    "both paths agree about all numbers of both_paths.txt, and ref has its digits and proves what pages say") {
  const auto rows = table_rows("verify/solve/both_paths.txt");
  CHECK(rows.size() >= 30);
  std::size_t kinds = 0;
  for (const auto& row : rows) {
    const std::string& line = row.front();
    CAPTURE(line);
    const data::Scene scene = scene_of(line);
    const BothPaths solved = by_both_paths(scene);
    const bool is_kind = contains(line, "{kind}");
    // A slip of 0 has no digits.
    for (const std::string_view missed : solved.ref.missed()) CHECK((is_kind && missed == "slip"));
    CHECK((solved.ref.work.unknowns > 0 || line.starts_with("half-space")));
    if (is_kind) {
      check_proven(solved.ref, names_in(kind_of_example(line.substr(0, line.find(' ')))[2]));
      ++kinds;
    }
    if (!solved.fast.met()) check_same(solved, scene.accuracy);
  }
  CHECK(kinds == rows_of_proven("contact").size());
}

TEST_CASE("with full friction the shear reverses once more on thinner sheets, where both paths have it") {
  for (const auto& [length, zeros] : {std::pair("0.3", 1U), std::pair("1.5", 2U), std::pair("6", 2U)}) {
    const auto [fast, by_ref] = by_both_paths(
        loaded_example("thin-given-length",
                       {{"wanted", R"(["peak_pressure_position", "peak_shear_position", "shear_zeros"])"},
                        {"roller.radius", "1e3"},
                        {"sheet.thickness", "1"},
                        {"material.young", "1"},
                        {"friction.model", "full"},
                        {"contact.length", length}}));
    CHECK(fast.profile(data::ResultId::shear_zeros).size() == zeros);
    CHECK(by_ref.missed().empty());
  }
}
