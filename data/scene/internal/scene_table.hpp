#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nipref/data/scene/keys.hpp>
#include <nipref/data/scene/origin.hpp>

namespace nipref::data {

/// One table of a scene's TOML file. `origin` gets the line of each value that is read and must outlive the table;
/// every refusal (BadInput) names the line.
class SceneTable {
 public:
  /// The table of a whole file, with `overrides` (key, value) in place of the file's values. Refuses a text that is
  /// not TOML (keys given twice included), and the overrides that load_scene refuses.
  static SceneTable parse(const std::string& text, SceneOrigin& origin,
                          const std::vector<std::pair<std::string, std::string>>& overrides);

  /// Refuses the keys that scene_keys() does not have for scenes of the file's kind with this model or method.
  void allow(std::string_view model = {}) const;

  [[nodiscard]] bool has(std::string_view key) const;
  [[nodiscard]] bool has_table(std::string_view key) const;
  /// In the order of the alphabet.
  [[nodiscard]] std::vector<std::string> keys() const;
  // The value of the key. It is refused if it is missing, or not of the type in scene_keys().
  /// table() refuses keys of the table as allow() does; any_table() does not.
  [[nodiscard]] SceneTable table(std::string_view key, std::string_view model = {}) const;
  [[nodiscard]] SceneTable any_table(std::string_view key) const;
  [[nodiscard]] std::string text(std::string_view key) const;
  [[nodiscard]] double number(std::string_view key) const;
  [[nodiscard]] int whole(std::string_view key) const;
  [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;
  [[nodiscard]] std::vector<double> numbers(std::string_view key) const;
  /// A text as it is, or a list of numbers and texts with commas between them.
  [[nodiscard]] std::string text_or_list(std::string_view key) const;
  /// A text that is one of the key's choices.
  [[nodiscard]] std::string choice(std::string_view key) const;

  /// "TABLE.KEY", as the origin knows it.
  [[nodiscard]] std::string full_name(std::string_view key) const;

 private:
  struct Contents;
  struct Item;
  SceneTable(std::shared_ptr<const Contents> contents, std::string name, SceneOrigin& origin);
  [[nodiscard]] Item item(std::string_view key, std::string_view allowed) const;
  [[nodiscard]] std::string_view allowed_type(std::string_view key, KeyType type) const;
  [[nodiscard]] std::vector<Item> items(std::string_view key, std::string_view allowed) const;

  std::shared_ptr<const Contents> contents_;
  std::string name_;  ///< empty for the file itself
  SceneOrigin* origin_;
};

}  // namespace nipref::data
