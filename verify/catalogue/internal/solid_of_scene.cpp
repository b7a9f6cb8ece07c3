#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/input_file.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/internal/solid_of_scene.hpp>

namespace nipref::verify {
namespace {

std::string text_of(const toml::node& node) {
  if (const toml::array* const list = node.as_array()) {
    std::vector<std::string> items;
    for (const toml::node& item : *list) items.push_back(text_of(item));
    return fmt::format("[{}]", fmt::join(items, ","));
  }
  const auto number = node.value<double>();
  return number ? fmt::format("{}", *number) : node.value_or(std::string("?"));
}

}  // namespace

std::string solid_of_scene(const Quantity& quantity, const Argument& material, const std::string& path) {
  const std::string name = quantity.solid ? "half_space" : "material";
  const data::BadInput not_so(material.name, "@" + path,
                              fmt::format("must be a scene's file with a table [{}]", name));
  toml::table scene;
  try {
    scene = toml::parse(data::text_of_input_file(path, material.name));
  } catch (const toml::parse_error&) {
    throw not_so;
  }
  const toml::table* const solid = scene[name].as_table();
  if (solid == nullptr) throw not_so;
  const std::vector<Argument> others = written_arguments(quantity);
  std::vector<std::string> keys;
  for (const auto& [key, value] : *solid) {
    const std::string word(key.str());
    if (word != "model" && std::ranges::find(others, word, &Argument::name) == others.end())
      keys.push_back(word + "=" + text_of(value));
  }
  return fmt::format("{}({})", (*solid)["model"].value_or(std::string()), fmt::join(keys, ","));
}

}  // namespace nipref::verify
