#include <algorithm>
#include <filesystem>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/scene/file.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/command_line.hpp>

namespace nipref::verify {

using data::BadInput;

fast::Accuracy accuracy_option(const CommandLine& line) {
  const auto text = line.option("rtol");
  return text ? fast::Accuracy(parse_real("rtol", *text)) : fast::Accuracy();
}

namespace {

/// 0 if the option is neither given nor has a default.
std::size_t count_option(const CommandLine& line, const std::string& name) {
  const std::string text = line.option_or_usual(name);
  return text.empty() ? 0 : static_cast<std::size_t>(parse_real(name, text));
}

/// A file, or the name of an example where there is no such file.
std::filesystem::path scene_file_of(const CommandLine& line) {
  if (line.words.empty())
    throw BadInput("scene", "(missing)", "must be the name of a TOML file or of an example");
  if (line.words.size() > 1)
    throw BadInput("argument", line.words[1],
                   "unexpected: " + line.verb + " takes one scene and key=value pairs");
  const std::filesystem::path word = line.words.front();
  std::error_code none;  // as where a name is longer than a file's may be
  const bool is_file = std::filesystem::exists(word, none) || word.has_parent_path() || word.has_extension();
  return is_file ? word : data::example_scene(word.string());
}

}  // namespace

SceneRequest scene_request(const CommandLine& line) {
  const bool by_ref = line.option_or_usual("path") == "ref";
  if (!by_ref)
    refuse_option(line, "digits", "has no effect with path=fast: must be left out, or path=ref given");
  return {data::read_scene(scene_file_of(line)), by_ref ? digits_option(line) : std::nullopt};
}

std::size_t points_option(const CommandLine& line) { return count_option(line, "points"); }

std::size_t scenes_option(const CommandLine& line) { return count_option(line, "scenes"); }

std::string seed_option(const CommandLine& line) { return line.option_or_usual("seed"); }

std::optional<double> max_slowdown_option(const CommandLine& line) {
  const auto text = line.option("max-slowdown");
  if (!text) return std::nullopt;
  if (!line.option("against")) throw BadInput("max-slowdown", *text, "must be given with --against");
  const bool percent = text->ends_with('%');
  const double slowdown =
      parse_real("max-slowdown", percent ? text->substr(0, text->size() - 1) : *text) / (percent ? 100 : 1);
  if (slowdown < 0) throw BadInput("max-slowdown", *text, "must be a number >= 0: 10% and 0.1 are the same");
  return slowdown;
}

std::optional<int> digits_option(const CommandLine& line) {
  const std::size_t digits = count_option(line, "digits");
  return digits == 0 ? std::nullopt : std::optional(static_cast<int>(digits));
}

std::size_t every_option(const CommandLine& line) { return count_option(line, "every"); }

void refuse_option(const CommandLine& line, const std::string& name, const std::string& why) {
  if (line.option(name) || line.has(name)) throw BadInput(name, line.option(name).value_or("(given)"), why);
}

bool Selection::has(std::string_view group) const { return std::ranges::find(groups, group) != groups.end(); }

Selection selection(const CommandLine& line, const std::vector<std::string_view>& groups) {
  if (line.words.empty()) return {select_quantities({}), groups};
  Selection selected;
  for (const std::string& word : line.words) {
    const auto group = std::ranges::find(groups, word);
    const Quantity* const quantity = known_quantity(word);
    if (quantity == nullptr && group == groups.end()) refuse_quantity(word, groups);
    if (quantity != nullptr) {
      if (std::ranges::find(selected.quantities, quantity) == selected.quantities.end())
        selected.quantities.push_back(quantity);
    } else if (!selected.has(*group)) {
      selected.groups.push_back(*group);
    }
  }
  return selected;
}

}  // namespace nipref::verify
