#define TOML_HEADER_ONLY 0  // the parser is compiled in data
#include <toml++/toml.h>

#include <charconv>

#include <nipref/data/closest_name.hpp>
#include <nipref/data/input_file.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/named_point.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

std::string text_of(const Argument& argument, const Quantity& quantity, const Assignments& assignments) {
  if (const auto given = argument_text(argument, assignments)) return *given;
  if (argument.default_text) return *argument.default_text;
  refuse(argument.name, "(missing)", "{} needs it: must be {}", quantity.name, domain(argument));
}

/// Reads an argument exactly. The name of a choice stands for its number.
ref::Exact parse(const Argument& argument, const std::string& text) {
  if (argument.kind != ArgumentKind::choice) {
    const ref::Exact number = ref::Exact::parse(text, argument.name);
    const bool refused = (argument.kind == ArgumentKind::nonnegative && number.sign() < 0) ||
                         (argument.kind == ArgumentKind::positive && number.sign() <= 0);
    if (refused) throw BadInput(argument.name, text, "must be " + domain(argument));
    return number;
  }
  return ref::Exact(choice_number(argument, text));
}

/// The argument that a user writes as MODEL(KEY=VALUE, ...), a material or a solid; null if there is none.
const Argument* material_of(const Quantity& quantity) {
  if (quantity.solid) return &*quantity.solid;
  const auto found =
      std::ranges::find_if(quantity.arguments, [](const Argument& one) { return !one.models.empty(); });
  return found == quantity.arguments.end() ? nullptr : &*found;
}

/// Whether the argument is written within the material in any of its models.
bool is_of_material(const Argument* material, const std::string& argument) {
  return material != nullptr && std::ranges::any_of(material->models, [&](const MaterialModel& model) {
           return model.holds(argument);
         });
}

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

/// The parts of a text between its commas; commas within brackets do not separate.
std::vector<std::string> items_of(const std::string& text) {
  std::vector<std::string> items;
  int depth = 0;
  for (const char c : text) {
    if (items.empty()) items.emplace_back();
    depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    if (c == ',' && depth == 0) {
      items.emplace_back();
    } else {
      items.back() += c;
    }
  }
  return items;
}

/// Appends the values of KEY=VALUE or KEY=[VALUE, ...] as pairs with their arguments. Values that a list lacks are 0.
void append_key(const std::vector<Argument>& arguments, const MaterialModel& model, const std::string& item,
                const BadInput& not_so, Assignments& all) {
  const std::size_t equals = item.find('=');
  const ModelKey* const key = model.key(item.substr(0, equals));
  if (equals == std::string::npos || key == nullptr) throw not_so;
  std::string value = item.substr(equals + 1);
  const bool is_list = value.starts_with('[') && value.ends_with(']');
  if (is_list != (key->arguments.size() > 1)) throw not_so;
  if (is_list) value = value.substr(1, value.size() - 2);
  const std::vector<std::string> values = is_list ? items_of(value) : std::vector{value};
  const std::size_t most = key->arguments.size(), least = key->is_whole ? most : 1;
  if (values.size() < least || values.size() > most)
    refuse(key->name, "[" + value + "]", "must hold {}{} numbers", least < most ? "1 to " : "", most);
  for (std::size_t i = 0; i < key->arguments.size(); ++i) {
    const std::string& name = key->arguments[i];
    if (i < values.size()) {
      all.emplace_back(name, values[i]);
    } else if (default_number(arguments[argument_number(arguments, name)]) != 0) {
      all.emplace_back(name, "0");
    }
  }
}

std::size_t number_of(const Argument& material, const auto& is_wanted) {
  const auto found = std::ranges::find_if(material.models, is_wanted);
  return static_cast<std::size_t>(found - material.models.begin());
}

/// The number of the model that the user writes: among the models of that name the first one that has all keys in
/// `items`, or, if none has, the first one.
std::size_t model_written(const Argument& material, const std::string& name,
                          const std::vector<std::string>& items) {
  const std::size_t fitting = number_of(material, [&](const MaterialModel& model) {
    return model.name == name && std::ranges::all_of(items, [&](const std::string& item) {
             return model.key(item.substr(0, item.find('='))) != nullptr;
           });
  });
  if (fitting < material.models.size()) return fitting;
  return number_of(material, [&](const MaterialModel& model) { return model.name == name; });
}

std::string written_models(const Argument& material, const std::string& name) {
  std::vector<std::string> written;
  for (const MaterialModel& model : material.models)
    if (model.name == name) written.push_back(written_model(model));
  return fmt::format("{}", fmt::join(written, " or "));
}

/// Appends the model of a material that the user writes, and its numbers. A solid has only one model, without a number.
void append_material(const Quantity& quantity, const Argument& material, const std::string& given,
                     Assignments& all) {
  const std::string text = without_blanks(given), name = text.substr(0, text.find('('));
  const bool has_keys = name.size() < text.size(), is_closed = text.ends_with(')') && !text.ends_with("()");
  std::vector<std::string> items;
  if (has_keys && is_closed) items = items_of(text.substr(name.size() + 1, text.size() - name.size() - 2));
  const std::size_t model = model_written(material, name, items);
  if (model == material.models.size()) throw BadInput(material.name, given, "must be " + domain(material));
  const BadInput not_so(material.name, given,
                        fmt::format("must be {}, each key at most once", written_models(material, name)));
  if (has_keys && !is_closed) throw not_so;
  if (!quantity.solid) all.emplace_back(material.name, material.choices[model]);
  for (const std::string& item : items)
    append_key(quantity.arguments, material.models[model], item, not_so, all);
}

[[noreturn]] void refuse_outside_material(const Argument& material, const std::string& name,
                                          const std::string& value) {
  const std::size_t model = number_of(material, [&](const MaterialModel& one) { return one.holds(name); });
  refuse(name, value, "is part of the {0}: {0}={1}", material.name, written_model(material.models[model]));
}

std::string toml_text(const toml::node& node) {
  if (const toml::array* const list = node.as_array())
    return fmt::format("[{}]", fmt::join(mapped(*list, toml_text), ","));
  const auto number = node.value<double>();
  return number ? fmt::format("{}", *number) : node.value_or(std::string("?"));
}

/// MODEL(KEY=VALUE, ...) of the material of the scene in that file, or of its half-space for an argument "solid". Keys
/// that are arguments of their own, such as the direction of an axis, are left out. BadInput if the file holds none.
std::string solid_of_scene(const Quantity& quantity, const Argument& material, const std::string& path) {
  const std::string name = quantity.solid ? "half_space" : "material";
  const BadInput not_so(material.name, "@" + path,
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
      keys.push_back(word + "=" + toml_text(value));
  }
  return fmt::format("{}({})", (*solid)["model"].value_or(std::string()), fmt::join(keys, ","));
}

template <class Number>
std::optional<Number> whole_text_as(const std::string& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

double nearest_double(const std::string& name, const std::string& text, const ref::Exact& exact) {
  const double value = std::strtod(text.c_str(), nullptr);
  if (!std::isfinite(value) || (value == 0 && exact.sign() != 0))
    throw BadInput(name, text, "must be within the range of a double for fast; --path ref takes it");
  return value;
}

}  // namespace

std::string written_model(const MaterialModel& model) {
  const auto form_of = [](const ModelKey& key) {
    return key.name + (key.arguments.size() > 1 ? "=[...]" : "=...");
  };
  return fmt::format("{}({})", model.name, fmt::join(mapped(model.keys, form_of), ", "));
}

const std::string& written_name(const Quantity& quantity, const Argument& argument) {
  const Argument* const material = material_of(quantity);
  return is_of_material(material, argument.name) ? material->name : argument.name;
}

std::vector<Argument> written_arguments(const Quantity& quantity) {
  std::vector<Argument> written;
  for (const Argument& argument : quantity.arguments) {
    const std::string& name = written_name(quantity, argument);
    if (std::ranges::find(written, name, &Argument::name) != written.end()) continue;
    written.push_back(name == argument.name ? argument : *material_of(quantity));
  }
  return written;
}

Assignments with_material_numbers(const Quantity& quantity, const Assignments& given) {
  const Argument* const material = material_of(quantity);
  Assignments all;
  for (const auto& [name, value] : given) {
    if (material != nullptr && name == material->name) {
      const std::string text =
          value.starts_with('@') ? solid_of_scene(quantity, *material, value.substr(1)) : value;
      append_material(quantity, *material, text, all);
    } else if (is_of_material(material, name)) {
      refuse_outside_material(*material, name, value);
    } else {
      all.emplace_back(name, value);
    }
  }
  return all;
}

Assignments written_arguments(const Quantity& quantity, const std::vector<std::string>& text) {
  const Argument* const material = material_of(quantity);
  const auto text_of_key = [&](const ModelKey& key) {
    auto values = mapped(key.arguments, [&](const std::string& name) {
      return text[argument_number(quantity.arguments, name)];
    });
    // Numbers that are missing at the end of a list are 0.
    while (!key.is_whole && values.size() > 1 && std::strtod(values.back().c_str(), nullptr) == 0)
      values.pop_back();
    const std::string list = fmt::format("{}", fmt::join(values, ", "));
    return key.name + (key.arguments.size() > 1 ? "=[" + list + "]" : "=" + list);
  };
  const auto text_of_model = [&](const std::string& choice) {
    const auto number = std::ranges::find(material->choices, choice) - material->choices.begin();
    const MaterialModel& model = material->models[static_cast<std::size_t>(number)];
    return fmt::format("{}({})", model.name, fmt::join(mapped(model.keys, text_of_key), ", "));
  };
  Assignments written;
  for (const Argument& argument : written_arguments(quantity)) {
    const bool is_solid = quantity.solid && quantity.solid->name == argument.name;
    const std::string& own =
        is_solid ? argument.choices.front() : text[argument_number(quantity.arguments, argument.name)];
    written.emplace_back(argument.name, argument.models.empty() ? own : text_of_model(own));
  }
  return written;
}

Assignments written_point(const Quantity& quantity, std::span<const double> point,
                          const std::function<std::string(double)>& number) {
  std::vector<std::string> text;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const Argument& argument = quantity.arguments[i];
    text.push_back(argument.kind == ArgumentKind::choice ? std::string(argument.choice(point[i]))
                                                         : number(point[i]));
  }
  return written_arguments(quantity, text);
}

void refuse_unknown_arguments(const Quantity& quantity, const Assignments& assignments) {
  const std::vector<Argument> written = written_arguments(quantity);
  const auto known = mapped<std::string_view>(written, &Argument::name);
  for (const auto& [name, value] : assignments) {
    if (std::ranges::find(quantity.arguments, name, &Argument::name) != quantity.arguments.end()) continue;
    refuse(name, value, "unknown argument: {}{} takes {}", data::did_you_mean(name, known), quantity.name,
           fmt::join(known, ", "));
  }
}

std::optional<std::string> argument_text(const Argument& argument, const Assignments& assignments) {
  std::vector<std::string> given;
  for (const auto& [name, value] : assignments)
    if (name == argument.name) given.push_back(value);
  if (given.size() > 1) throw BadInput(argument.name, given[1], "given twice: must be given once");
  return given.empty() ? std::nullopt : std::optional(given.front());
}

Point ParsedArguments::nearest(const Quantity& quantity) const {
  Point point;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const Argument& argument = quantity.arguments[i];
    point.push_back(argument.kind == ArgumentKind::choice ? exact[i].approximate()
                                                          : nearest_double(argument.name, text[i], exact[i]));
  }
  return point;
}

ParsedArguments parse_arguments(const Quantity& quantity, const Assignments& assignments) {
  refuse_unknown_arguments(quantity, assignments);
  ParsedArguments parsed;
  for (const Argument& argument : quantity.arguments) {
    parsed.text.push_back(text_of(argument, quantity, assignments));
    parsed.exact.push_back(parse(argument, parsed.text.back()));
  }
  return parsed;
}

long parse_integer(const std::string& name, const std::string& text) {
  const auto value = whole_text_as<long>(text);
  if (!value) throw BadInput(name, text, "must be a whole number");
  return *value;
}

double parse_real(const std::string& name, const std::string& text) {
  const auto value = whole_text_as<double>(text);
  if (!value || !std::isfinite(*value)) throw BadInput(name, text, "must be a finite number");
  return *value;
}

}  // namespace nipref::verify
