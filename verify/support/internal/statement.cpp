#define TOML_HEADER_ONLY 1
#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

#include <nipref/data/input_file.hpp>
#include <nipref/verify/support/internal/statement.hpp>

namespace nipref::verify {
namespace {

[[noreturn]] void refuse_statement(const std::string& where, std::string_view requirement) {
  throw data::BadInput("statements file", where, requirement);
}

Statement statement_of(const toml::table& table, const std::string& path) {
  const auto where = [&](const toml::node& node) {
    return fmt::format("{}:{}", path, node.source().begin.line);
  };
  Statement statement{where(table)};
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    if (const auto text = node.value_exact<std::string>()) {
      statement.texts.emplace(name, *text);
    } else if (node.is_number()) {
      statement.numbers.emplace(name, *node.value<double>());
    } else if (node.is_array_of_tables()) {
      for (const toml::node& one : *node.as_array())
        statement.lists[name].push_back(statement_of(*one.as_table(), path));
    } else {
      refuse_statement(where(node), fmt::format("must have a text, a number or tables as {}", name));
    }
  }
  return statement;
}

const auto& found(const auto& values, const std::string& key, const Statement& statement,
                  std::string_view type) {
  const auto value = values.find(key);
  if (value == values.end()) statement.refuse(fmt::format("must have {} as {}", type, key));
  return value->second;
}

}  // namespace

void Statement::refuse(std::string_view requirement) const { refuse_statement(where, requirement); }

const std::string& Statement::text(const std::string& key) const {
  return found(texts, key, *this, "a text");
}
double Statement::number(const std::string& key) const { return found(numbers, key, *this, "a number"); }

std::string Statement::text_or(const std::string& key, const std::string& otherwise) const {
  return texts.contains(key) ? text(key) : otherwise;
}
double Statement::number_or(const std::string& key, double otherwise) const {
  return numbers.contains(key) ? number(key) : otherwise;
}

const std::vector<Statement>& Statement::list(const std::string& key,
                                              std::initializer_list<std::string_view> required,
                                              std::initializer_list<std::string_view> optional) const {
  static const std::vector<Statement> none;
  const auto all = lists.find(key);
  if (all == lists.end()) return none;
  const auto is_allowed = [&](const auto& one) {
    return std::ranges::count(required, one.first) + std::ranges::count(optional, one.first) > 0;
  };
  for (const Statement& one : all->second) {
    for (const std::string_view name : required) static_cast<void>(one.text(std::string(name)));
    if (!std::ranges::all_of(one.texts, is_allowed) || !std::ranges::all_of(one.numbers, is_allowed) ||
        !std::ranges::all_of(one.lists, is_allowed))
      one.refuse(fmt::format("must have no keys in [[{}]] but {}, {}", key, fmt::join(required, ", "),
                             fmt::join(optional, ", ")));
  }
  return all->second;
}

const Statement& Statement::entry(const std::string& key, const std::string& id) const {
  const auto all = lists.find(key);
  if (all != lists.end()) {
    const auto one =
        std::ranges::find(all->second, id, [](const Statement& of) { return of.text_or("id", ""); });
    if (one != all->second.end()) return *one;
  }
  refuse(fmt::format("must have a [[{}]] with the id '{}'", key, id));
}

Statement read_statements(const std::filesystem::path& file) {
  const std::string path = file.string();
  std::ifstream stream = data::open_input_file(path, "statements file");
  std::stringstream text;
  text << stream.rdbuf();
  try {
    return statement_of(toml::parse(text.str()), path);
  } catch (const toml::parse_error& error) {
    refuse_statement(fmt::format("{}:{}", path, error.source().begin.line),
                     fmt::format("must be TOML: {}", error.description()));
  }
}

}  // namespace nipref::verify
