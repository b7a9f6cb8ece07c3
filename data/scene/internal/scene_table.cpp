#include <nipref/data/scene/internal/scene_table.hpp>

// All of toml++ is compiled here, for verify too.
#define TOML_HEADER_ONLY 0
#define TOML_IMPLEMENTATION
#include <toml++/toml.h>

#include <nipref/data/closest_name.hpp>
#include <nipref/data/internal/common.hpp>
#include <nipref/data/toml_obstacle.hpp>

namespace nipref::data {

struct SceneTable::Contents {
  std::shared_ptr<const toml::table> file;  ///< owns all tables
  const toml::table* table;

  [[nodiscard]] SceneKind kind() const {
    return file->contains("half_space") ? SceneKind::half_space : SceneKind::nip;
  }
};

/// A value with the key that refusals name.
struct SceneTable::Item {
  const toml::node* node;
  std::string name;
  std::string_view allowed;  ///< says which type is wanted
  const SceneOrigin* origin;

  /// The value as a number, text, ...; refused if it is something else.
  template <class Value>
  [[nodiscard]] Value as() const {
    const std::optional<Value> value = node->value<Value>();
    // toml++ also reads true as the number 1.
    if (!value || (node->is_boolean() && !std::is_same_v<Value, bool>)) refuse();
    return *value;
  }
  [[noreturn]] void refuse() const { origin->refuse(name, shown(), allowed); }
  [[nodiscard]] std::string shown() const;
};

std::string SceneTable::Item::shown() const {
  if (node->is_table()) return "(a table)";
  if (node->is_array()) return "(a list)";
  std::ostringstream text;
  node->visit([&](const auto& value) { text << value; });
  return text.str();
}

namespace {

constexpr std::size_t longest_line_shown = 200;

/// Returns the line of this number, counted from 1. The parser may complain about the line after the last one.
std::string line_of(const std::string& text, std::size_t number) {
  std::istringstream stream(text);
  std::string line;
  for (std::size_t i = 0; i < number; ++i) {
    if (!std::getline(stream, line)) return "(end of file)";
  }
  return line;
}

[[noreturn]] void refuse_syntax(const std::string& text, std::size_t line, std::string_view allowed,
                                SceneOrigin& origin) {
  origin.note("syntax", line);
  origin.refuse("syntax", line_of(text, line).substr(0, longest_line_shown), allowed);
}

using Override = std::pair<std::string, std::string>;

/// The TOML value of `text`, as the only element of a list. If `text` is not a TOML value, it is a text whose quotes
/// the shell has removed.
toml::array value_of(const std::string& text) {
  toml::array held;
  if (toml_obstacle(text)) {
    held.push_back(text);
    return held;
  }
  try {
    const toml::table parsed = toml::parse("value = " + text);
    if (parsed.size() == 1)
      held.push_back(*parsed.get("value"));  // a copy has no line numbers, which would be wrong here
  } catch (const toml::parse_error&) {
    // `text` is a text without quotes
  }
  if (held.empty()) held.push_back(text);
  return held;
}

/// Returns the table in which the key stands, made if the file has none, and the last part of the key.
std::pair<toml::table*, std::string> place_of(toml::table& file, const Override& given) {
  const auto& [key, value] = given;
  if (static_cast<std::size_t>(std::ranges::count(key, '.')) >= most_key_parts)
    throw BadInput(key, value, fmt::format("must be a key of at most {} parts", most_key_parts));
  toml::table* table = &file;
  std::size_t start = 0;
  for (std::size_t dot = key.find('.'); dot != std::string::npos; dot = key.find('.', start)) {
    const std::string part = key.substr(start, dot - start);
    table = table->insert(part, toml::table{}).first->second.as_table();
    if (table == nullptr || part.empty()) {
      throw BadInput(key, value, "must be TABLE.KEY or KEY of the scene: '" + part + "' is no table");
    }
    start = dot + 1;
  }
  return {table, key.substr(start)};
}

void override_one(toml::table& file, const Override& given) {
  const auto [table, key] = place_of(file, given);
  const toml::array held = value_of(given.second);
  if (key.empty() || held.get(0)->is_table() || (table->contains(key) && table->get(key)->is_table())) {
    throw BadInput(given.first, given.second,
                   "must be TABLE.KEY=VALUE or KEY=VALUE: a number, a text or a list at a time");
  }
  table->erase(key);  // erases the old line number as well
  table->insert(key, *held.get(0));
}

void override_all(toml::table& file, const std::vector<Override>& overrides, SceneOrigin& origin) {
  std::set<std::string> seen;
  for (const Override& given : overrides) {
    if (!seen.insert(given.first).second)
      throw BadInput(given.first, given.second, "given twice: must be given once");
    override_one(file, given);
    origin.note_given(given.first, given.second);
  }
}

}  // namespace

SceneTable::SceneTable(std::shared_ptr<const Contents> contents, std::string name, SceneOrigin& origin)
    : contents_(std::move(contents)), name_(std::move(name)), origin_(&origin) {}

SceneTable SceneTable::parse(const std::string& text, SceneOrigin& origin,
                             const std::vector<Override>& overrides) {
  if (text.find('\0') != std::string::npos)
    origin.refuse("syntax", "(binary)", "must be text: this has zero bytes");
  if (const auto obstacle = toml_obstacle(text))
    refuse_syntax(text, obstacle->line, obstacle->allowed, origin);
  try {
    auto parsed = std::make_shared<toml::table>(toml::parse(text));
    override_all(*parsed, overrides, origin);
    auto contents = std::make_shared<const Contents>(Contents{parsed, parsed.get()});
    return {std::move(contents), "", origin};
  } catch (const toml::parse_error& error) {
    refuse_syntax(text, error.source().begin.line, fmt::format("must be TOML: {}", error.description()),
                  origin);
  }
}

std::string SceneTable::full_name(std::string_view key) const {
  return name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
}

void SceneTable::allow(std::string_view model) const {
  const std::vector<std::string_view> known = names_in_table(name_, contents_->kind(), model);
  for (const auto& [key, node] : *contents_->table) {
    if (std::ranges::find(known, key.str()) != known.end()) continue;
    const std::string name = full_name(key.str());
    origin_->note(name, key.source().begin.line);
    const Item unknown{&node, name, "", origin_};
    origin_->refuse(
        name, unknown.shown(),
        fmt::format("unknown key: {}known here: {}", did_you_mean(key.str(), known), fmt::join(known, ", ")));
  }
}

bool SceneTable::has(std::string_view key) const { return contents_->table->contains(key); }

bool SceneTable::has_table(std::string_view key) const {
  return has(key) && contents_->table->get(key)->is_table();
}

std::vector<std::string> SceneTable::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, node] : *contents_->table) keys.emplace_back(key.str());
  return keys;
}

SceneTable::Item SceneTable::item(std::string_view key, std::string_view allowed) const {
  const auto found = contents_->table->find(key);
  const std::string name = full_name(key);
  if (found == contents_->table->end()) origin_->refuse(name, "(missing)", allowed);
  origin_->note(name, found->first.source().begin.line);
  return {&found->second, name, allowed, origin_};
}

std::vector<SceneTable::Item> SceneTable::items(std::string_view key, std::string_view allowed) const {
  const Item whole = item(key, allowed);
  const toml::array* const array = whole.node->as_array();
  if (array == nullptr) whole.refuse();
  std::vector<Item> elements;
  for (const toml::node& element : *array) {
    const std::string name = fmt::format("{}[{}]", whole.name, elements.size());
    origin_->note(name, element.source().begin.line);
    elements.push_back({&element, name, allowed, origin_});
  }
  return elements;
}

SceneTable SceneTable::any_table(std::string_view key) const {
  const Item found = item(key, "must be a table");
  const toml::table* const inner = found.node->as_table();
  if (inner == nullptr) found.refuse();
  return {std::make_shared<const Contents>(Contents{contents_->file, inner}), found.name, *origin_};
}

SceneTable SceneTable::table(std::string_view key, std::string_view model) const {
  SceneTable inner = any_table(key);
  inner.allow(model);
  return inner;
}

std::string_view SceneTable::allowed_type(std::string_view key, KeyType type) const {
  const SceneKey* const known = find_scene_key(full_name(key));
  if (known == nullptr || known->type != type) throw std::logic_error("another type in the table of keys");
  return known->allowed_type();
}

std::string SceneTable::text(std::string_view key) const {
  return item(key, allowed_type(key, KeyType::text)).as<std::string>();
}

double SceneTable::number(std::string_view key) const {
  return item(key, allowed_type(key, KeyType::number)).as<double>();
}

int SceneTable::whole(std::string_view key) const {
  const Item found = item(key, allowed_type(key, KeyType::whole));
  if (!found.node->is_integer()) found.refuse();
  const std::optional<int> value = found.node->value<int>();  // empty if too large for int
  if (!value) found.refuse();
  return *value;
}

std::vector<std::string> SceneTable::texts(std::string_view key) const {
  std::vector<std::string> values;
  for (const Item& element : items(key, allowed_type(key, KeyType::texts)))
    values.push_back(element.as<std::string>());
  return values;
}

std::vector<double> SceneTable::numbers(std::string_view key) const {
  std::vector<double> values;
  for (const Item& element : items(key, allowed_type(key, KeyType::numbers)))
    values.push_back(element.as<double>());
  return values;
}

std::string SceneTable::text_or_list(std::string_view key) const {
  constexpr auto allowed =
      "must be a range in quotes, \"lo..hi:log\", or a list of numbers or of texts without commas";
  const Item whole = item(key, allowed);
  if (whole.node->is_string()) return whole.as<std::string>();
  std::string all;
  for (const Item& element : items(key, allowed)) {
    const std::string one =
        element.node->is_string() ? element.as<std::string>() : fmt::format("{}", element.as<double>());
    if (one.empty() || one.find(',') != std::string::npos) element.refuse();
    all += (all.empty() ? "" : ", ") + one;
  }
  if (all.empty()) whole.refuse();
  return all;
}

std::string SceneTable::choice(std::string_view key) const {
  const std::string chosen = item(key, allowed_type(key, KeyType::choice)).as<std::string>();
  const std::vector<std::string_view>& choices =
      find_scene_key(full_name(key))->choices_of(contents_->kind());
  if (std::ranges::find(choices, chosen) == choices.end())
    origin_->refuse(full_name(key), chosen, fmt::format("must be {}", fmt::join(choices, " or ")));
  return chosen;
}

}  // namespace nipref::data
