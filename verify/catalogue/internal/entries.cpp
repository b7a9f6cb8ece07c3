#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <sstream>
#include <stdexcept>

#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/support/mapped.hpp>

namespace nipref::verify {
namespace {

/// The text of quantities.toml, put here by the build so that the catalogue needs no file.
constexpr std::string_view definitions =
#include <nipref_quantities.inc>
    ;

const toml::table& definitions_table() {
  static const toml::table table = toml::parse(definitions);
  return table;
}

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::istringstream stream(text);
  std::vector<std::string> parts;
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// A model from its name and its keys.
MaterialModel model_of(const std::string& text) {
  const std::vector<std::string> words = words_of(text);
  MaterialModel model{words.front(), {}};
  for (const std::string& name : std::span(words).subspan(1)) {
    const auto key = definitions_table()["keys"][name];
    model.keys.push_back(
        {name, words_of(key["arguments"].value_or(std::string(name))), key["whole"].value_or(false)});
  }
  return model;
}

/// NAME:KIND, NAME:KIND=DEFAULT, NAME:ONE|OTHER=DEFAULT, NAME:@MODELS=DEFAULT.
Argument argument_of(const std::string& text) {
  const std::size_t colon = text.find(':'), equals = text.find('=');
  Argument argument{text.substr(0, colon), ArgumentKind::choice, {}, {}};
  const std::string kind = text.substr(colon + 1, equals - colon - 1);
  if (equals != text.npos) argument.default_text = text.substr(equals + 1);
  if (kind.starts_with('@')) {
    for (const toml::node& model : *definitions_table()["models"][kind.substr(1)].as_array()) {
      argument.models.push_back(model_of(model.value<std::string>().value()));
      const std::string& name = argument.models.back().name;
      const bool is_new = std::ranges::find(argument.choices, name) == argument.choices.end();
      argument.choices.push_back(is_new ? name : fmt::format("{}/{}", name, argument.choices.size()));
    }
  } else if (kind.find('|') != kind.npos) {
    argument.choices = parts_of(kind, '|');
  } else {
    argument.kind = argument_kind(kind);
  }
  return argument;
}

/// Adds the arguments. A material that has only one model needs no number in a point to say which model it is.
void add_arguments(Quantity& quantity, const std::string& text) {
  for (const std::string& word : words_of(text)) {
    if (word.starts_with('@')) {
      add_arguments(quantity, definitions_table()["groups"][word.substr(1)].value<std::string>().value());
      continue;
    }
    const Argument argument = argument_of(word);
    if (argument.models.size() == 1) {
      quantity.solid = argument;
    } else {
      quantity.arguments.push_back(argument);
    }
  }
}

Quantity quantity_of(const toml::table& row) {
  Quantity quantity;
  quantity.name = row["name"].value<std::string>().value();
  quantity.subject = row["subject"].value<std::string>().value();
  add_arguments(quantity, row["arguments"].value<std::string>().value());
  quantity.unit = row["unit"].value_or(std::string("1"));
  quantity.promise = row["promise"].value<double>().value();
  quantity.audit_points = row["points"].value_or(quantity.audit_points);
  quantity.family = row["family"].value_or(std::string());
  quantity.most_digits = row["digits"].value_or(quantity.most_digits);
  quantity.is_costly = row["costly"].value_or(false);
  quantity.source = row["source"].value<std::string>().value();
  quantity.scale = row["scale"].value_or(std::string("the value"));
  quantity.definition = row["definition"].value<std::string>().value();
  if (const toml::array* const forms = row["forms"].as_array()) {
    for (const toml::node& node : *forms) {
      const toml::table& form = *node.as_table();
      quantity.seed_forms.push_back(
          {form["name"].value_or(std::string()), form["differs"].value_or(std::string()), {}});
    }
  }
  return quantity;
}

}  // namespace

const std::vector<Quantity>& described_quantities() {
  static const std::vector<Quantity> all =
      mapped(*definitions_table()["quantities"].as_array(),
             [](const toml::node& row) { return quantity_of(*row.as_table()); });
  return all;
}

Quantity described(std::string_view name) {
  const auto found = std::ranges::find(described_quantities(), name, &Quantity::name);
  if (found == described_quantities().end())
    throw std::logic_error(fmt::format("quantities.toml has no row '{}'", name));
  return *found;
}

void set_defaults(const NamedNumbers& x, const std::vector<ModelKey>& keys) {
  for (const ModelKey& key : keys)
    for (const std::string& name : key.arguments)
      x[name] = default_number(x.arguments()[argument_number(x.arguments(), name)]);
}

}  // namespace nipref::verify
