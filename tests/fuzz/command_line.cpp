#include <sstream>
#include <vector>

#include <nipref/data/scene/file.hpp>
#include <nipref/data/table/index.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/ranges.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/sweep_rows.hpp>

#include "reading.hpp"

using namespace nipref;
using verify::CommandLine;

namespace {

/// A command line whose words are separated by blanks.
CommandLine command_line_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  return verify::parse_command_line(static_cast<int>(arguments.size()), arguments.data());
}

void read_options(const CommandLine& line) {
  take_or_refuse([&] { static_cast<void>(verify::accuracy_option(line)); });
  take_or_refuse([&] { static_cast<void>(line.count("points")); });
  take_or_refuse([&] { static_cast<void>(line.count("scenes")); });
  take_or_refuse([&] { static_cast<void>(verify::max_slowdown_option(line)); });
  take_or_refuse([&] { static_cast<void>(line.count("every")); });
  take_or_refuse([&] { static_cast<void>(line.number("promise")); });
}

void read_scene(const CommandLine& line) {
  const data::SceneText text = verify::scene_request(line).scene;
  const verify::AxesProduct scenes = verify::swept_scenes(text, line);
  static_cast<void>(data::load_scene(text, scenes.assignments(0, &verify::AxisValue::shown)));
}

void read_arguments(const CommandLine& line) {
  const verify::Quantity& quantity = verify::find_quantity(line.words.empty() ? "I6" : line.words.front());
  take_or_refuse([&] { static_cast<void>(verify::parse_ranges(quantity, line.assignments)); });
  std::vector<verify::Axis> axes;
  for (const auto& [name, text] : line.assignments)
    axes.push_back(verify::axis_of(name, text, line.option("points") ? line.count("points") : 100));
  const verify::AxesProduct points(axes);
  static_cast<void>(
      verify::parse_arguments(quantity, points.assignments(0, &verify::AxisValue::exact)).nearest(quantity));
}

}  // namespace

/// Reads all that verbs read of a command line before they compute.
void read_given(const std::string& text, const GivenFile&) {
  take_or_refuse([&] {
    const CommandLine line = command_line_of(text);
    read_options(line);
    take_or_refuse([&] { read_scene(line); });
    take_or_refuse([&] { read_arguments(line); });
    for (const std::string& word : line.words)
      take_or_refuse([&] { static_cast<void>(data::find_table_id(word)); });
  });
}
