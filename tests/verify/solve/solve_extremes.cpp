// Scenes with numbers at the ends of their ranges end soon, with a result whose error estimate covers or a refusal.
#include <fmt/format.h>

#include <iterator>

#include <nipref/data/directory.hpp>
#include <nipref/data/input_file.hpp>

#include "support/covered.hpp"
#include "support/solved_scene.hpp"
#include "support/stated_contact.hpp"

using namespace nipref;

namespace {

std::string text_of(const std::string& scene) {
  return data::text_of_input_file(data::example_scene(scene), "scene");
}

/// The sheet of "viscoelastic-short-memory" with another relaxation time.
data::Scene relaxing_in(const std::string& time) {
  return loaded_example("viscoelastic-short-memory",
                        {{"material.relaxation_time", time}, {"accuracy", "1e-10"}});
}

/// The elastic sheet of that scene with the moduli over `softening`: E = 9 K G/(3 K + G), nu = (3 K - 2 G)/(6 K + 2 G).
data::Scene elastic(double softening) {
  const double bulk = 1.45e5, shear = 5.4375e4;
  return loaded_example(
      "viscoelastic-elastic-limit",
      {{"material.young", fmt::format("{}", 9 * bulk * shear / (3 * bulk + shear) / softening)},
       {"material.poisson", fmt::format("{}", (3 * bulk - 2 * shear) / (6 * bulk + 2 * shear))},
       {"sheet.thickness", "1.0"}});
}

constexpr const char* same_when_elastic[] = {"contact_length", "indentation", "creep_ratio", "peak_pressure"};

/// Replaces one of the numbers behind equals signs: by an extreme, by a number of another size, or by any number. The
/// result is the same on every machine, because only the engine's own bits are used.
std::string edited(std::string text, std::mt19937_64& engine) {
  const auto below = [&](std::size_t count) { return static_cast<std::size_t>(engine() % count); };
  std::vector<std::pair<std::size_t, std::size_t>> numbers;  // begin and length
  for (std::size_t at = text.find(" = "); at != std::string::npos; at = text.find(" = ", at + 1)) {
    const std::size_t begin = at + (text[at + 3] == '[' ? 4 : 3);
    const std::size_t end = text.find_first_not_of("0123456789.+-e", begin);
    if (end > begin) numbers.emplace_back(begin, end - begin);
  }
  const auto [begin, length] = numbers[below(numbers.size())];
  static const std::vector<std::string> extremes = [] {
    std::istringstream words(
        "0 -0.0 5e-324 1e-308 1e-100 1e-60 1e-20 1e-8 1e8 1e20 1e60 1e100 1.7976931348623157e308 nan inf -inf -1 -1.0 1 "
        "2.0 0.5 0.49999999999999994 -0.9999999999999999");
    return std::vector<std::string>(std::istream_iterator<std::string>(words), {});
  }();
  const double share = static_cast<double>(engine() >> 11) * 0x1p-53;
  const std::string others[]{
      extremes[below(extremes.size())],
      fmt::format("{}", std::strtod(text.c_str() + begin, nullptr) * std::pow(10, 24 * share - 12)),
      fmt::format("{}", std::pow(10, 616 * share - 308))};
  return text.replace(begin, length, others[below(3)]);
}

}  // namespace

TEST_CASE("a memory that is far shorter or longer than the contact leaves the elastic contact") {
  const auto relaxed = verify::solve(elastic(2)), stiff = verify::solve(elastic(1));
  for (const std::string time : {"1e-308", "1e-100", "1e-12"}) {
    CAPTURE(time);
    const auto rolling = verify::solve(relaxing_in(time));
    // Lengths change by about the relaxation length, which is this time at speed 1.
    const double relaxation = std::strtod(time.c_str(), nullptr);
    for (const char* name : same_when_elastic) {
      const fast::Estimate& limit = relaxed[name];
      const double shift = 10 * relaxation * std::fabs(limit.value) / relaxed["contact_length"].value;
      check_covered(rolling[name], fast::Estimate{{limit.value, limit.error + shift}});
    }
    // The resistance is half the relaxation length, by which the pressure trails, over the radius 6.
    const double resistance = relaxation / 12;
    const fast::Estimate& found = rolling["rolling_resistance"];
    CHECK(std::fabs(found.value - resistance) <= found.error + 100 * relaxation * resistance);
    CHECK(found.error > 0);
    CHECK(found.error < (relaxation < 1e-30 ? 1e-30 : 1e-6 * resistance));
    CHECK(rolling.work.unknowns < 120);
  }
  for (const std::string time : {"1e20", "1e308"}) {
    CAPTURE(time);
    const auto rolling = verify::solve(relaxing_in(time));
    for (const char* name : same_when_elastic) check_covered(rolling[name], stiff[name]);
  }
}

TEST_CASE("an angle of many turns keeps its digits") {
  const auto span_at = [](const char* angle) {
    return verify::solve(loaded_example("half-space-sliding-die",
                                        {{"wanted", R"(["span"])"}, {"profile.positions", angle}}))
        .profile("span")[0]
        .value;
  };
  CHECK(span_at("[45.0]") == span_at("[3600000000000045.0]"));  // exact in double
}

TEST_CASE("a result that is no number is refused by its name") {
  data::Scene scene = loaded_example("thick-frictionless");
  scene.wanted = {data::ResultId::load};
  for (const fast::Estimate estimate : {fast::Estimate{infinite, 1}, {1, infinite}, {std::nan(""), 1}}) {
    StatedContact<fast::Estimate> contact;
    contact.numbers[data::ResultId::load] = [estimate](double) { return estimate; };
    contact.numbers[data::ResultId::indentation] = [](double) { return fast::Estimate{0, 0}; };
    CHECK_REFUSED(verify::collect_results(scene, contact, scene.accuracy), "wanted[0] = load: ");
  }
}

TEST_CASE("random edits of scenes end in numbers or in a refusal") {
  std::vector<std::string> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(data::scenes_directory())) {
    if (entry.path().extension() == ".toml") scenes.push_back(entry.path().stem().string());
  }
  std::ranges::sort(scenes);  // a folder has no order
  std::mt19937_64 engine(20261121);
  int results = 0, refusals = 0;
  for (int i = 0; i < (is_thorough() ? 3000 : 150); ++i) {
    std::string text = text_of(scenes[static_cast<std::size_t>(engine() % scenes.size())]);
    for (std::uint64_t count = 1 + engine() % 2; count > 0; --count) text = edited(text, engine);
    CAPTURE(text);
    try {
      for (const auto& result : solved(text).results) {
        for (const fast::Estimate& number : result.numbers) {
          CHECK(std::isfinite(number.value));
          CHECK(std::isfinite(number.error));
          CHECK(number.error >= 0);
        }
      }
      ++results;
    } catch (const data::BadInput&) {
      ++refusals;
    }
  }
  CHECK(results > 25);
  CHECK(refusals > 25);
}
