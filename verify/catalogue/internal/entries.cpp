#define TOML_HEADER_ONLY 0  // the parser is compiled in data
#include <toml++/toml.h>

#include <stdexcept>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/fast/sheet/branch_points.hpp>
#include <nipref/fast/sheet/roots.hpp>
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/catalogue/internal/printed.hpp>
#include <nipref/verify/support/formula.hpp>
#include <nipref/verify/support/internal/cache.hpp>
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

/// The words of a text, where NAME_2..9REST stands for NAME_2REST to NAME_9REST.
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

/// Reads NAME:KIND, NAME:KIND=DEFAULT, NAME:ONE|OTHER=DEFAULT or NAME:@MODELS=DEFAULT.
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

/// Adds the arguments. A material with only one model becomes `solid`: a point needs no number for its model.
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

/// The definitions of the functions of [sampling] or of [sizes].
std::string functions_in(const char* part) {
  return definitions_table()[part]["functions"].value<std::string>().value();
}

const Formulas& sampling_formulas() {
  static const Formulas all({}, functions_in("sampling"));
  return all;
}

/// The numbers of a point by the names of the arguments.
GivenNumbers given_by_point(const std::vector<Argument>& arguments, std::span<const double> x) {
  GivenNumbers numbers;
  for (std::size_t i = 0; i < x.size(); ++i) numbers.emplace_back(arguments[i].name, x[i]);
  return numbers;
}

/// The size of a quantity by its formula.
decltype(Quantity::envelope) size_of(const std::string& formula, const std::vector<Argument>& arguments) {
  static const Formulas functions({}, functions_in("sizes"));
  return [arguments, size = functions.compiled(formula)](std::span<const double> x) {
    Formulas scope(given_by_point(arguments, x));
    return size(scope).value();
  };
}

bool has_argument(const std::vector<Argument>& arguments, const std::string& name) {
  return std::ranges::find(arguments, name, &Argument::name) != arguments.end();
}

/// The value of the brackets in a formula of [sampling], which hold a kind of number and formulas without blanks.
/// `random` is null if a point is only moved.
double sampled_number(const std::string& words, Formulas& scope, const std::vector<Argument>& arguments,
                      Random* random) {
  static Cache<std::string, std::vector<Formulas::Expression>> read;
  const auto formulas = read.at(words, [&] {
    const std::vector<std::string> all = words_of(words);
    return mapped(std::span(all).subspan(1),
                  [](const auto& one) { return sampling_formulas().compiled(one); });
  });
  const std::string kind = words.substr(0, words.find(' '));
  const auto at = [&](std::size_t i) { return formulas->at(i)(scope).value(); };
  const auto index = [&](std::size_t count) { return static_cast<double>(random->index(count)); };
  const auto root = [&] { return fast::sheet_root(static_cast<int>(at(0))); };
  if (kind == "uniform") return random->uniform(at(0), at(1));
  if (kind == "log") return random->log_uniform(at(0), at(1));
  if (kind == "chance") return random->chance(at(0)) ? 1 : 0;
  if (kind == "index") return index(static_cast<std::size_t>(at(0)));
  if (kind == "pick") return at(random->index(formulas->size()));
  if (kind == "root_re") return root().real();
  if (kind == "root_im") return root().imag();
  const Point point = mapped(arguments, [&](const Argument& one) { return scope.number(one.name).value(); });
  return point_functions().at(kind)(NamedPoint(arguments, point));
}

/// Lines that replace the constants of the quantity's solid by their defaults where default_solid is not 0.
std::string default_constants_lines(const Quantity& quantity) {
  std::string lines;
  for (const ModelKey& key : quantity.solid ? quantity.solid->models.front().keys : std::vector<ModelKey>())
    for (const std::string& name : key.arguments)
      lines += fmt::format("{0} = if(default_solid, {1}, {0})\n", name,
                           default_number(quantity.arguments[argument_number(quantity.arguments, name)]));
  return lines;
}

/// The lines for a quantity. @default_constants is replaced by default_constants_lines, any other @NAME by lines of
/// [sampling]; ?ARGUMENT begins a line that is left out if the quantity has no such argument.
std::string whole_lines(const std::string& text, const Quantity& quantity) {
  std::string lines;
  for (const std::string& line : parts_of(text, "\n")) {
    if (line == "@default_constants") {
      lines += default_constants_lines(quantity);
    } else if (line.starts_with('@')) {
      const auto more = definitions_table()["sampling"][line.substr(1)].value<std::string>();
      lines += whole_lines(more.value(), quantity);
    } else if (!line.starts_with('?') ||
               has_argument(quantity.arguments, line.substr(1, line.find(' ') - 1))) {
      lines += line.substr(line.starts_with('?') ? 1 : 0) + "\n";
    }
  }
  return lines;
}

/// Makes a function that changes a point by such lines.
std::function<void(Point& point, Random* random)> changed_by(const std::string& text, double nearest,
                                                             const std::vector<Argument>& arguments) {
  using Lines = std::vector<std::pair<std::string, Formulas::Expression>>;
  return [=](Point& point, Random* random) {
    static Cache<std::string, Lines> compiled;
    const auto lines = compiled.at(text, [&] { return sampling_formulas().compiled_lines(text); });
    Formulas scope([&](const std::string& words, Formulas& inner) {
      return sampled_number(words, inner, arguments, random);
    });
    scope.define("nearest", nearest);
    for (std::size_t i = 0; i < point.size(); ++i) scope.define(arguments[i].name, point[i]);
    for (const auto& [name, formula] : *lines) scope.define(name, formula(scope));
    for (std::size_t i = 0; i < point.size(); ++i) point[i] = scope.number(arguments[i].name).value();
  };
}

/// Sets how audits draw points of the quantity, by a table of [sampling].
void set_sampling(Quantity& quantity, const std::string& name, double nearest) {
  const auto table = definitions_table()["sampling"][name];
  const auto lines_of = [&](const char* key) {
    return whole_lines(table[key].value<std::string>().value_or(""), quantity);
  };
  const auto change = [&](const std::string& lines) {
    return changed_by(lines, nearest, quantity.arguments);
  };
  const std::string keep = lines_of("keep");
  quantity.draw = [drawn = change(lines_of("draw") + keep),
                   defaults = point_of(quantity, {})](Random& random) {
    Point point = defaults;
    drawn(point, &random);
    return point;
  };
  if (!keep.empty()) quantity.keep_off = [kept = change(keep)](Point& point) { kept(point, nullptr); };
}

/// The values of a quantity, or, for keys that the quantity lacks, those of its section.
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
  [[nodiscard]] std::vector<SeedForm> forms(const std::vector<Argument>& arguments) const {
    std::vector<SeedForm> forms;
    if (!own_.is_table()) return forms;
    if (const toml::table* const all = (*own_.as_table())["forms"].as_table()) {
      for (const auto& [name, form] : *all) {
        const toml::table& stated = *form.as_table();
        forms.push_back({std::string(name.str()), stated["differs"].value<std::string>().value(),
                         form_of(stated["is"].value<std::string>().value(), arguments)});
      }
    }
    return forms;
  }

 private:
  [[nodiscard]] decltype(SeedForm::value) form_of(const std::string& formula,
                                                  const std::vector<Argument>& arguments) const {
    if (const auto own = point_functions().find(formula); own != point_functions().end())
      return [=, value = own->second](std::span<const double> x) { return value({arguments, x}); };
    return [=, is_over_steel = get<bool>("over_steel").value_or(false),
            needs = parts_of(get<std::string>("needs").value_or(""), "\n")](std::span<const double> x) {
      GivenNumbers given = given_by_point(arguments, x);
      for (const std::string& need : needs) {
        const std::vector<std::string> parts = parts_of(need, " | ");
        if (printed_value(parts.at(1), given) != 0) continue;
        const std::size_t number = argument_number(arguments, parts.front());
        if (arguments[number].kind != ArgumentKind::choice)
          throw data::BadInput(parts.front(), x[number], parts.at(2));
        throw data::BadInput(parts.front(), arguments[number].choice(x[number]), parts.at(2));
      }
      if (is_over_steel)
        std::ranges::move(scaled_moduli(transverse_of({arguments, x}), data::seed::steel),
                          std::back_inserter(given));
      return printed_value(formula, given);
    };
  }

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
  quantity.seed_forms = row.forms(quantity.arguments);
  quantity.envelope = size_of(row.get<std::string>("size").value_or("0"), quantity.arguments);
  if (const auto sampling = row.get<std::string>("sampling"))
    set_sampling(quantity, *sampling, row.get<double>("nearest").value_or(1 - 1e-9));
  return quantity;
}

/// The quantities in the order of their lines, which a TOML table does not keep.
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

std::vector<double> hard_values(ArgumentKind kind) {
  const auto listed = [](std::string_view key) {
    const auto words = words_of(definitions_table()["hard"][key].value_or(std::string()));
    return mapped(words, [](const std::string& formula) { return Formulas().value(formula).value(); });
  };
  std::vector<double> values;
  const auto add_with_neighbours = [&](double value) {
    for (const double near : {std::nextafter(value, 0.0), value, std::nextafter(value, HUGE_VAL)})
      values.push_back(values.size() % 2 == 0 ? near : -near);
  };
  if (kind == ArgumentKind::position || kind == ArgumentKind::nonzero_position) {
    std::ranges::for_each(fast::branch_points(), add_with_neighbours);
    std::ranges::for_each(listed("positions"), add_with_neighbours);
  }
  std::ranges::copy(listed(kind_of_number(kind).name), std::back_inserter(values));
  return values;
}

double drawn(const std::string& formula, Random& random, const GivenNumbers& given) {
  Formulas scope(
      [&](const std::string& words, Formulas& inner) { return sampled_number(words, inner, {}, &random); });
  scope.define(given);
  return sampling_formulas().compiled(formula)(scope).value();
}

double draw_passing_time(double t, Random& random) { return drawn("passing_time(t)", random, {{"t", t}}); }

void set_defaults(const NamedNumbers& x, const std::vector<ModelKey>& keys) {
  for (const ModelKey& key : keys)
    for (const std::string& name : key.arguments)
      x[name] = default_number(x.arguments()[argument_number(x.arguments(), name)]);
}

}  // namespace nipref::verify
