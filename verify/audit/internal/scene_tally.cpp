#include <algorithm>

#include <nipref/verify/audit/internal/scene_tally.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {
namespace {

std::optional<double> middle_of(std::vector<double> numbers) {
  if (numbers.empty()) return {};
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::ranges::nth_element(numbers, middle);
  return *middle;
}

void add(SceneTally& tally, const SceneFindings& findings) {
  if (tally.scenes == 0) tally.worst = tally.slowest = findings;
  ++tally.scenes;
  if (!findings.refused.empty() && tally.refused++ == 0) tally.refusal = findings.refused;
  if (!findings.failed.empty() && tally.failed++ == 0) tally.failure = findings;
  tally.numbers += findings.numbers;
  tally.unchecked += findings.unchecked;
  tally.uncovered += findings.uncovered;
  tally.missed_said += findings.missed_said;
  tally.missed_unsaid += findings.missed_unsaid;
  if (findings.largest_ratio > tally.worst.largest_ratio) tally.worst = findings;
  if (findings.seconds > tally.slowest.seconds) tally.slowest = findings;
}

}  // namespace

std::vector<SceneTally> tally(const std::vector<SceneFindings>& findings) {
  const auto& kinds = drawn_kinds();
  std::vector<SceneTally> tallies(kinds.size());
  std::vector<std::vector<double>> overestimates(kinds.size());
  for (const SceneFindings& found : findings) {
    const std::size_t k = found.index % kinds.size();
    add(tallies[k], found);
    overestimates[k].insert(overestimates[k].end(), found.overestimates.begin(), found.overestimates.end());
  }
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    tallies[k].kind = kinds[k];
    tallies[k].median_overestimate = middle_of(std::move(overestimates[k]));
  }
  std::erase_if(tallies, [](const SceneTally& one) { return one.scenes == 0; });
  return tallies;
}

std::vector<SceneTally> audit_scenes(std::size_t count, const std::string& seed,
                                     const std::function<void(double)>& progress,
                                     const SceneSolvers& solvers) {
  std::vector<std::optional<SceneFindings>> findings(count);
  try {
    parallel_for(
        count, [&](std::size_t i) { findings[i] = audit_scene(seed, i, solvers); },
        [&](std::size_t done) { progress(static_cast<double>(done) / static_cast<double>(count)); });
  } catch (const Interrupted&) {
    // What is finished is told.
  }
  std::vector<SceneFindings> finished;
  for (const auto& found : findings) {
    if (found) finished.push_back(*found);
  }
  return tally(finished);
}

bool all_kept(const std::vector<SceneTally>& tallies) {
  return std::ranges::all_of(tallies, &SceneTally::kept);
}

}  // namespace nipref::verify
