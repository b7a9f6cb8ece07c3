#include <nipref/data/internal/common.hpp>
#include <nipref/data/scene/internal/rows.hpp>
#include <nipref/data/scene/keys.hpp>

namespace nipref::data {
namespace {

constexpr std::string_view table_of_keys =
#include <nipref_scene_keys.inc>
    ;

// In the order of KeyType.
constexpr std::array<std::string_view, 6> types{"text", "texts", "choice", "number", "numbers", "whole"};
constexpr std::array<std::string_view, 6> allowed_types{
    "must be a text in quotes", "must be a list of texts in quotes", "must be a text in quotes",
    "must be a number",         "must be a list of numbers",         "must be a whole number"};

void set_unit(SceneKey& key, std::string_view unit) {
  for (const std::string_view factor : words_in(unit)) {
    const std::vector<std::string_view> parts = split(factor, '^');
    if (parts.back() == "k") {
      key.time_grows_along_list = true;
      continue;
    }
    const int exponent = parts.size() > 1 ? std::stoi(std::string(parts[1])) : 1;
    if (parts[0] == "length") key.dimension.length = exponent;
    if (parts[0] == "stress") key.dimension.stress = exponent;
    if (parts[0] == "time") key.dimension.time = exponent;
  }
}

/// "LEAST..MOST UNIT", where an empty MOST is the largest double.
void set_range(SceneKey& key, std::string_view range, std::string_view unit) {
  const std::size_t dots = range.find("..");
  const std::string least(range.substr(0, dots)), most(range.substr(dots + 2));
  key.least = std::stod(least);
  key.most = most.empty() ? std::numeric_limits<double>::max() : std::stod(most);
  key.allowed =
      fmt::format("must be {}from {} to {}{}{}", key.type == KeyType::whole ? "a whole number " : "", least,
                  most, unit.empty() ? "" : " ", unit);
  if (most.empty()) key.allowed = "must be finite and >= " + least;
}

void set_domain(SceneKey& key, std::string_view domain) {
  if (key.type == KeyType::choice) {
    const std::vector<std::string_view> of_kinds = split(domain, ';');
    key.choices[0] = words_in(of_kinds.front());
    key.choices[1] = words_in(of_kinds.back());
  } else if (domain == "magnitude") {
    key.least = least_magnitude;
    key.most = greatest_magnitude;
  } else if (!domain.empty()) {
    const std::vector<std::string_view> words = words_in(domain);
    set_range(key, words.front(), words.size() > 1 ? words.back() : "");
  }
}

SceneKey key_of(const std::vector<std::string_view>& fields) {
  SceneKey key{.name = fields[0], .meaning = fields[5]};
  key.type = named<KeyType>(types, fields[1]);
  set_unit(key, fields[2]);
  set_domain(key, fields[3]);
  key.models = words_in(fields[4]);
  if (!key.models.empty()) {
    key.kind = named<SceneKind>(scene_kinds, key.models.front());
    key.models.erase(key.models.begin());
  }
  return key;
}

}  // namespace

std::string Dimension::text() const {
  std::string text;
  for (const auto& [name, exponent] : {std::pair("length", length), {"stress", stress}, {"time", time}}) {
    if (exponent == 0) continue;
    text += (text.empty() ? "" : " ") + std::string(name);
    if (exponent != 1) text += "^" + std::to_string(exponent);
  }
  return text.empty() ? "1" : text;
}

std::string_view SceneKey::table() const {
  const std::size_t dot = name.find('.');
  return dot == std::string_view::npos ? std::string_view{} : name.substr(0, dot);
}

std::string_view SceneKey::last() const { return name.substr(name.find('.') + 1); }

const std::vector<std::string_view>& SceneKey::choices_of(SceneKind scene) const {
  return choices[scene == SceneKind::half_space ? 1 : 0];
}

std::string_view SceneKey::allowed_type() const { return allowed_types[static_cast<std::size_t>(type)]; }

std::string_view SceneKey::refusal_of(double value) const {
  if (least <= value && value <= most) return {};
  if (allowed.empty()) return allowed_magnitude(value);
  if (least == -greatest_magnitude && !std::isfinite(value)) return "must be finite";
  return allowed;
}

const std::vector<SceneKey>& scene_keys() {
  static const std::vector<SceneKey> keys = [] {
    std::vector<SceneKey> all;
    for (const auto& row : rows_of(table_of_keys, 6)) all.push_back(key_of(row));
    return all;
  }();
  return keys;
}

const SceneKey* find_scene_key(std::string_view name) {
  const auto found = std::ranges::find(scene_keys(), name.substr(0, name.find('[')), &SceneKey::name);
  return found == scene_keys().end() ? nullptr : &*found;
}

std::vector<std::string_view> names_in_table(std::string_view table, SceneKind kind, std::string_view model) {
  std::vector<std::string_view> names;
  for (const SceneKey& key : scene_keys()) {
    if (key.kind.value_or(kind) != kind) continue;
    if (table.empty()) {
      const std::string_view name = key.table().empty() ? key.name : key.table();
      if (names.empty() || names.back() != name) names.push_back(name);
    } else if (key.table() == table && (key.models.empty() || std::ranges::count(key.models, model) > 0)) {
      names.push_back(key.last());
    }
  }
  return names;
}

}  // namespace nipref::data
