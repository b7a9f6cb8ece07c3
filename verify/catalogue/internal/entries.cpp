#include <toml++/toml.h>

#include <stdexcept>

#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/support/formula.hpp>
#include <nipref/verify/support/text.hpp>

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

/// The words of a text, with NAME_2..9REST as NAME_2REST to NAME_9REST.
std::vector<std::string> names_of(const std::string& text) {
  std::vector<std::string> names;
  for (const std::string& word : words_of(text)) {
    const std::size_t dots = word.find("..");
    if (dots == word.npos) {
      names.push_back(word);
      continue;
    }
    const std::size_t first = word.rfind('_', dots) + 1, end = std::min(word.find(':', dots), word.size());
    const int last = std::stoi(word.substr(dots + 2, end - dots - 2));
    for (int number = std::stoi(word.substr(first, dots - first)); number <= last; ++number)
      names.push_back(word.substr(0, first) + std::to_string(number) + word.substr(end));
  }
  return names;
}

/// A model from its name and its keys.
MaterialModel model_of(const std::string& text) {
  const std::vector<std::string> words = words_of(text);
  MaterialModel model{words.front(), {}};
  for (const std::string& name : std::span(words).subspan(1)) {
    const auto key = definitions_table()["keys"][name];
    model.keys.push_back(
        {name, names_of(key["arguments"].value_or(std::string(name))), key["whole"].value_or(false)});
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
    argument.choices = parts_of(kind, "|");
  } else {
    argument.kind = argument_kind(kind);
  }
  return argument;
}

/// Adds the arguments. A material that has only one model needs no number in a point to say which model it is.
void add_arguments(Quantity& quantity, const std::string& text) {
  for (const std::string& word : names_of(text)) {
    if (word.starts_with('@')) {
      add_arguments(quantity, definitions_table()["groups"][word.substr(1)].value<std::string>().value());
      continue;
    }
    Argument argument = argument_of(word);
    if (argument.models.size() == 1) {
      quantity.solid = std::move(argument);
    } else {
      quantity.arguments.push_back(std::move(argument));
    }
  }
}

/// What a quantity has of its own, or else what its section has.
class Row {
 public:
  Row(const toml::table& section, const toml::node& own) : section_(section), own_(own) {}

  template <class Value>
  [[nodiscard]] std::optional<Value> get(std::string_view key) const {
    const toml::table* const own = own_.as_table();
    if (own == nullptr && key == "definition") return own_.value<Value>();
    return own != nullptr && own->contains(key) ? (*own)[key].value<Value>() : section_[key].value<Value>();
  }
  [[nodiscard]] std::string text(std::string_view key) const { return get<std::string>(key).value(); }
  [[nodiscard]] std::vector<SeedForm> forms() const {
    std::vector<SeedForm> forms;
    if (!own_.is_table()) return forms;
    if (const toml::table* const all = (*own_.as_table())["forms"].as_table()) {
      for (const auto& [name, differs] : *all)
        forms.push_back({std::string(name.str()), differs.value<std::string>().value(), {}});
    }
    return forms;
  }

 private:
  const toml::table& section_;
  const toml::node& own_;
};

Quantity quantity_of(std::string_view name, const Row& row) {
  Quantity quantity;
  quantity.name = name;
  quantity.subject = row.text("subject");
  add_arguments(quantity, row.text("arguments"));
  quantity.unit = row.get<std::string>("unit").value_or("1");
  quantity.promise = row.get<double>("promise").value();
  quantity.audit_points = row.get<std::size_t>("points").value_or(quantity.audit_points);
  quantity.family = row.get<std::string>("family").value_or("");
  quantity.most_digits = row.get<int>("digits").value_or(quantity.most_digits);
  quantity.is_costly = row.get<bool>("costly").value_or(false);
  quantity.source = row.text("source");
  quantity.scale = row.get<std::string>("scale").value_or("the value");
  quantity.notation = row.text("definition");
  quantity.definition = without_marks(quantity.notation);
  quantity.seed_forms = row.forms();
  return quantity;
}

/// In the order of their lines: a table does not keep it.
std::vector<Quantity> quantities_of(const toml::table& section) {
  std::vector<std::pair<toml::source_position, Quantity>> found;
  for (const auto& [name, own] : *section["quantities"].as_table())
    found.emplace_back(name.source().begin, quantity_of(name.str(), Row(section, own)));
  std::ranges::sort(found, {}, [](const auto& one) { return one.first.line; });
  return mapped(found, [](auto& one) { return std::move(one.second); });
}

}  // namespace

const std::vector<Quantity>& described_quantities() {
  static const std::vector<Quantity> all = [] {
    std::vector<Quantity> joined;
    for (const toml::node& section : *definitions_table()["sections"].as_array())
      std::ranges::move(quantities_of(*section.as_table()), std::back_inserter(joined));
    return joined;
  }();
  return all;
}

const Quantity& described(std::string_view name) {
  if (const auto* row = item_with(described_quantities(), &Quantity::name, name)) return *row;
  throw std::logic_error(fmt::format("quantities.toml has no row '{}'", name));
}

void set_defaults(const NamedNumbers& x, const std::vector<ModelKey>& keys) {
  for (const ModelKey& key : keys)
    for (const std::string& name : key.arguments)
      x[name] = default_number(x.arguments()[argument_number(x.arguments(), name)]);
}

}  // namespace nipref::verify
