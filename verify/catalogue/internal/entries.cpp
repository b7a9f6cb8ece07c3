#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>
#include <stdexcept>

#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

/// The text of quantities.toml, put here by the build so that the catalogue needs no file.
constexpr std::string_view definitions =
#include <nipref_quantities.inc>
    ;

const std::map<std::string_view, ArgumentKind> kinds{{"nonzero_position", ArgumentKind::nonzero_position},
                                                     {"position", ArgumentKind::position},
                                                     {"depth", ArgumentKind::depth},
                                                     {"young", ArgumentKind::young},
                                                     {"poisson", ArgumentKind::poisson},
                                                     {"index", ArgumentKind::index},
                                                     {"rate", ArgumentKind::rate},
                                                     {"amplitude", ArgumentKind::amplitude},
                                                     {"time", ArgumentKind::time},
                                                     {"passing_time", ArgumentKind::passing_time},
                                                     {"positive", ArgumentKind::positive},
                                                     {"nonnegative", ArgumentKind::nonnegative},
                                                     {"degrees", ArgumentKind::degrees}};

using Groups = std::map<std::string_view, ArgumentGroup (*)()>;
const Groups groups{{"@sheet", sheet_arguments},
                    {"@material", material_arguments},
                    {"@constants", constants_arguments},
                    {"@stiffness", stiffness_arguments}};

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::istringstream stream(text);
  std::vector<std::string> parts;
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

/// NAME:KIND, NAME:KIND=DEFAULT, NAME:ONE|OTHER=DEFAULT.
Argument argument_of(const std::string& text) {
  const std::size_t colon = text.find(':'), equals = text.find('=');
  Argument argument{text.substr(0, colon), ArgumentKind::choice, {}, {}};
  const std::string kind = text.substr(colon + 1, equals - colon - 1);
  if (equals != text.npos) argument.default_text = text.substr(equals + 1);
  if (const auto found = kinds.find(kind); found != kinds.end()) {
    argument.kind = found->second;
  } else {
    argument.choices = parts_of(kind, '|');
  }
  return argument;
}

Quantity quantity_of(const toml::table& row) {
  Quantity quantity;
  quantity.name = row["name"].value<std::string>().value();
  quantity.subject = row["subject"].value<std::string>().value();
  for (const std::string& word : parts_of(row["arguments"].value<std::string>().value(), ' ')) {
    if (const auto found = groups.find(word); found != groups.end()) {
      ArgumentGroup group = found->second();
      std::ranges::move(group.arguments, std::back_inserter(quantity.arguments));
      quantity.solid = std::move(group.written);
    } else {
      quantity.arguments.push_back(argument_of(word));
    }
  }
  quantity.unit = row["unit"].value_or(std::string("1"));
  quantity.promise = row["promise"].value<double>().value();
  quantity.audit_points = row["points"].value_or(quantity.audit_points);
  quantity.is_costly = row["costly"].value_or(false);
  quantity.source = row["source"].value<std::string>().value();
  quantity.scale = row["scale"].value_or(std::string("the value"));
  quantity.definition = row["definition"].value<std::string>().value();
  return quantity;
}

}  // namespace

std::vector<ModelKey> keys_of_numbers(const std::vector<std::string>& arguments) {
  std::vector<ModelKey> keys;
  for (const std::string& argument : arguments) keys.push_back({argument, {argument}});
  return keys;
}

const std::vector<Quantity>& described_quantities() {
  static const std::vector<Quantity> all = [] {
    const toml::table table = toml::parse(definitions);
    std::vector<Quantity> rows;
    for (const toml::node& row : *table["quantities"].as_array())
      rows.push_back(quantity_of(*row.as_table()));
    return rows;
  }();
  return all;
}

Quantity described(std::string_view name) {
  const auto found = std::ranges::find(described_quantities(), name, &Quantity::name);
  if (found == described_quantities().end())
    throw std::logic_error(fmt::format("quantities.toml has no row '{}'", name));
  return *found;
}

}  // namespace nipref::verify
