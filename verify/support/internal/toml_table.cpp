#define TOML_HEADER_ONLY 0  // the parser is compiled in data
#include <toml++/toml.h>

#include <mutex>

#include <nipref/data/directory.hpp>
#include <nipref/data/input_file.hpp>
#include <nipref/data/toml_obstacle.hpp>
#include <nipref/verify/support/internal/toml_table.hpp>

namespace nipref::verify {
namespace {

std::string place(const std::string& path, std::size_t line) { return fmt::format("{}:{}", path, line); }

TomlTable table_of(const toml::table& table, const std::string& what, const std::string& path) {
  TomlTable all{what, place(path, table.source().begin.line)};
  for (const auto& [key, node] : table) {
    const std::string& name = all.keys.emplace_back(key.str());
    const toml::array* const array = node.as_array();
    const auto subtable = [&](const toml::node& one) { return table_of(*one.as_table(), what, path); };
    if (node.is_string()) {
      all.texts.emplace(name, *node.value<std::string>());
    } else if (node.is_boolean()) {
      all.numbers.emplace(name, *node.value<bool>() ? 1 : 0);
    } else if (node.is_number()) {
      all.numbers.emplace(name, *node.value<double>());
    } else if (node.is_table()) {
      all.tables[name] = {subtable(node)};
    } else if (node.is_array_of_tables()) {
      all.tables[name] = mapped(*array, subtable);
    } else if (array != nullptr && (array->empty() || array->is_homogeneous<std::string>())) {
      all.words[name] = mapped(*array, [](const toml::node& one) { return *one.value<std::string>(); });
    } else {
      refuse(what, place(path, node.source().begin.line), "must have a text, a number, texts or tables as {}",
             name);
    }
  }
  return all;
}

const auto& found(const auto& values, const std::string& key, const TomlTable& table, std::string_view type) {
  const auto value = values.find(key);
  if (value == values.end()) table.refuse(fmt::format("must have {} as {}", type, key));
  return value->second;
}

/// The value of a key, or `otherwise` if the key is missing.
template <class Value>
Value found_or(const std::map<std::string, Value>& values, const std::string& key, const Value& otherwise) {
  const auto value = values.find(key);
  return value == values.end() ? otherwise : value->second;
}

}  // namespace

void TomlTable::refuse(std::string_view requirement) const { throw data::BadInput(what, where, requirement); }

const std::string& TomlTable::text(const std::string& key) const {
  return found(texts, key, *this, "a text");
}
double TomlTable::number(const std::string& key) const { return found(numbers, key, *this, "a number"); }
const TomlTable& TomlTable::table(const std::string& key) const {
  return found(tables, key, *this, "a table").front();
}

std::string TomlTable::text_or(const std::string& key, const std::string& otherwise) const {
  return found_or(texts, key, otherwise);
}
double TomlTable::number_or(const std::string& key, double otherwise) const {
  return found_or(numbers, key, otherwise);
}
std::vector<std::string> TomlTable::words_of(const std::string& key) const {
  return found_or(words, key, {});
}
std::map<std::string, std::string> TomlTable::texts_of(const std::string& key) const {
  return tables.contains(key) ? table(key).texts : std::map<std::string, std::string>();
}

const std::vector<TomlTable>& TomlTable::list(const std::string& key,
                                              std::initializer_list<std::string_view> required,
                                              std::initializer_list<std::string_view> optional) const {
  static const std::vector<TomlTable> none;
  const auto all = tables.find(key);
  if (all == tables.end()) return none;
  const auto is_allowed = [&](const std::string& name) {
    return std::ranges::count(required, name) + std::ranges::count(optional, name) > 0;
  };
  for (const TomlTable& one : all->second) {
    for (const std::string_view name : required) static_cast<void>(one.text(std::string(name)));
    if (!std::ranges::all_of(one.keys, is_allowed))
      one.refuse(fmt::format("must have no keys in [[{}]] but {}, {}", key, fmt::join(required, ", "),
                             fmt::join(optional, ", ")));
  }
  return all->second;
}

const TomlTable& TomlTable::entry(const std::string& key, const std::string& id) const {
  const auto has_id = [&](const TomlTable& one) { return one.text_or("id", "") == id; };
  if (const auto known = tables.find(key); known != tables.end()) {
    const auto one = std::ranges::find_if(known->second, has_id);
    if (one != known->second.end()) return *one;
  }
  refuse(fmt::format("must have a [[{}]] with the id '{}'", key, id));
}

TomlTable parse_toml(const std::string& text, const std::string& what, const std::string& path) try {
  if (const auto obstacle = data::toml_obstacle(text))
    throw data::BadInput(what, place(path, obstacle->line), std::string(obstacle->allowed));
  return table_of(toml::parse(text), what, path);
} catch (const toml::parse_error& error) {
  refuse(what, place(path, error.source().begin.line), "must be TOML: {}", error.description());
}

TomlTable read_toml(const std::filesystem::path& path, const std::string& what) {
  return parse_toml(data::text_of_input_file(path, what), what, path.string());
}

const TomlTable& statements_file(const std::string& name) {
  static std::mutex mutex;
  static std::map<std::filesystem::path, TomlTable> files;
  const auto path = data::statements_directory() / name;
  const std::scoped_lock lock(mutex);
  if (!files.contains(path)) files.emplace(path, read_toml(path, "statements file"));
  return files.at(path);
}

}  // namespace nipref::verify
