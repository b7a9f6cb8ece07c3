// The scenes of data/scenes/hard, in which errors were found: each scene says at its beginning what was wrong.
#include <nipref/data/directory.hpp>
#include <nipref/data/scene/file.hpp>

#include "support/covered.hpp"

using namespace nipref;

namespace {

std::vector<std::filesystem::path> hard_scenes() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(data::scenes_directory() / "hard"))
    files.push_back(entry.path());
  REQUIRE(files.size() >= 25);
  return files;
}

/// Whether each result is within its allowed error, or has an error at most twice that of the coarser solution.
bool is_best(const verify::SceneSolution<fast::Estimate>& found,
             const verify::SceneSolution<fast::Estimate>& coarser) {
  const auto is_met_or_best = [&](std::size_t r) {
    return found.results[r].met() == true ||
           std::ranges::equal(
               found.results[r].numbers, coarser.results[r].numbers,
               [](const auto& fine, const auto& coarse) { return fine.error <= 2 * coarse.error; });
  };
  for (std::size_t r = 0; r < found.results.size(); ++r) {
    if (!is_met_or_best(r)) return false;
  }
  return true;
}

/// Places in every zone of a contact: equally spaced ones, and others next to its ends.
std::vector<double> places_in_zones(const std::vector<fast::Estimate>& boundaries) {
  constexpr int parts = 12;
  std::vector<double> shares{1e-2, 1e-4, 1e-6};
  for (int k = 1; k <= parts / 2; ++k) shares.push_back(static_cast<double>(k) / parts);
  std::vector<double> places;
  for (std::size_t k = 1; k < boundaries.size(); ++k) {
    const double from = boundaries[k - 1].value, to = boundaries[k].value;
    for (const double share : shares) {
      places.push_back(from + share * (to - from));
      places.push_back(to + share * (from - to));
    }
  }
  return places;
}

}  // namespace

TEST_CASE("hard scenes are within their errors of finer solutions at all accuracies, and meet 1e-8") {
  for (const auto& file : hard_scenes()) {
    CAPTURE(file.stem().string());
    data::Scene scene = data::load_scene(file);
    // The scene's own accuracy is the one at which it was wrong.
    std::vector<double> accuracies{scene.accuracy, 1e-8};
    for (int digits = 2; is_thorough() && digits < 12; ++digits) accuracies.push_back(std::pow(10, -digits));
    std::ranges::sort(accuracies, std::greater());
    // Except in .ci/thorough the truth is 100 times as accurate as requested, which takes a fifth of the time.
    scene.accuracy = is_thorough() || scene.accuracy < 1e-9 ? 1e-13 : 1e-11;
    const auto truth = verify::solve(scene);
    auto coarser = truth;
    for (const double accuracy : accuracies) {
      CAPTURE(accuracy);
      scene.accuracy = accuracy;
      const auto found = verify::solve(scene);
      check_covered(found, truth);
      CHECK((accuracy >= 1e-8 ? found.missed().empty() : is_best(found, coarser)));
      coarser = found;
    }
    CHECK(is_best(truth, coarser));
  }
}

TEST_CASE("hard scenes: the pressure at the place of the largest is not larger than it") {
  int looked_at = 0;
  for (const auto& file : hard_scenes()) {
    data::Scene scene = data::load_scene(file);
    const auto wants = [&](data::ResultId result) {
      return std::ranges::find(scene.wanted, result) != scene.wanted.end();
    };
    if (!wants(data::ResultId::peak_pressure) || !wants(data::ResultId::peak_pressure_position)) continue;
    CAPTURE(file.stem().string());
    const auto found = verify::solve(scene);
    const double place = found[data::ResultId::peak_pressure_position].value;
    std::visit([&](auto& problem) { problem.profile = data::Positions{{place}}; }, scene.system);
    scene.wanted = {data::ResultId::pressure};
    const fast::Estimate largest = found[data::ResultId::peak_pressure],
                         there = verify::solve(scene).profile(data::ResultId::pressure).front();
    CHECK(there.value - there.error <= largest.value + largest.error);
    ++looked_at;
  }
  CHECK(looked_at >= 2);
}

// What both discretisations miss alike, their difference does not show.
TEST_CASE(
    "hard scenes with Coulomb's friction: it is not exceeded, slip is along the shear, or 0 where they stick") {
  int looked_at = 0;
  for (const auto& file : hard_scenes()) {
    data::Scene scene = data::load_scene(file);
    auto* const problem = std::get_if<data::PartialSlipProblem>(&scene.system);
    if (problem == nullptr) continue;
    CAPTURE(file.stem().string());
    const double mu = problem->nip.friction_coefficient;
    scene.wanted = {data::ResultId::zone_boundaries};
    const std::vector<double> places =
        places_in_zones(verify::solve(scene).profile(data::ResultId::zone_boundaries));
    problem->profile = data::Positions{places};
    scene.wanted = {data::ResultId::pressure, data::ResultId::shear, data::ResultId::slip};
    const auto found = verify::solve(scene);
    for (std::size_t i = 0; i < places.size(); ++i) {
      CAPTURE(places[i]);
      const fast::Estimate pressure = found.profile(data::ResultId::pressure)[i],
                           shear = found.profile(data::ResultId::shear)[i],
                           slip = found.profile(data::ResultId::slip)[i];
      const double left = mu * pressure.value - std::fabs(shear.value),
                   error = mu * pressure.error + shear.error;
      CHECK(left >= -error);
      CHECK((std::fabs(slip.value) <= slip.error || (slip.value * shear.value > 0 && left <= error)));
    }
    ++looked_at;
  }
  CHECK(looked_at >= 14);
}

TEST_CASE("hard scenes are within their errors of the reference where it solves them within seconds") {
  int solved = 0;
  for (const auto& file : hard_scenes()) {
    CAPTURE(file.stem().string());
    const data::Scene scene = data::load_scene(file);
    if (verify::likely_seconds_by_ref(scene, 16) > (is_thorough() ? 6 : 2)) continue;
    try {
      static_cast<void>(by_both_paths(scene));
      ++solved;
    } catch (const data::BadInput&) {
      // The reference cannot solve this scene.
    }
  }
  MESSAGE(solved, " scenes were solved");
  CHECK(solved >= (is_thorough() ? 11 : 4));
}
