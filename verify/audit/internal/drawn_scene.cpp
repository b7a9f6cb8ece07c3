#include <nipref/data/scene/file.hpp>
#include <nipref/verify/audit/internal/drawn_scene.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {
namespace {

/// The value in TOML. A number without point and exponent would be a whole one.
struct TomlText {
  std::string operator()(double number) const {
    std::string text = fmt::format("{}", number);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
  }
  std::string operator()(const std::string& text) const { return fmt::format("\"{}\"", text); }
  std::string operator()(data::ResultId id) const {
    return fmt::format("\"{}\"", data::scene_result(id).name);
  }
  template <class Item>
  std::string operator()(const std::vector<Item>& items) const {
    return fmt::format("[{}]", fmt::join(mapped(items, *this), ", "));
  }
};

}  // namespace

std::string DrawnScene::toml() const {
  std::string top, tables, table;
  for (const auto& [key, value] : keys_) {
    const std::size_t dot = key.find('.');
    const std::string text = std::visit(TomlText{}, value);
    if (dot == std::string::npos) {
      top += fmt::format("{} = {}\n", key, text);
      continue;
    }
    if (key.substr(0, dot) != table) {
      table = key.substr(0, dot);
      tables += fmt::format("[{}]\n", table);
    }
    tables += fmt::format("{} = {}\n", key.substr(dot + 1), text);
  }
  return top + tables;
}

data::Scene DrawnScene::scene() const { return data::parse_scene(toml(), text("title")); }

}  // namespace nipref::verify
