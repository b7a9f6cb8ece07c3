#include <nipref/data/material/seed_solids.hpp>
#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/data/table/index.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/deviation.hpp>
#include <nipref/verify/seeds/internal/solved.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

using data::ViscoelasticMaterial;

const auto& entry_of(const auto& table, const std::string& key, const Brackets& brackets) {
  const auto found = table.find(key);
  if (found == table.end()) brackets.refuse(fmt::format("no '{}'", key));
  return found->second;
}

Propagated as_propagated(const ref::Estimate& reference) {
  const double value = reference.to_double();
  return {value, std::fabs(reference.error_of(value)) + std::strtod(reference.error_text().c_str(), nullptr)};
}

/// A quantity of the catalogue at decimal arguments. The error of fast is its promise at the doubles nearest to them,
/// plus the change of the quantity from the decimals to the doubles.
Propagated of_quantity(const Brackets& brackets) {
  constexpr int digits = 20;
  const std::string& kind = brackets.name(0);
  const Quantity& quantity = find_quantity(brackets.name(1));
  const ParsedArguments arguments = parse_arguments(quantity, brackets.arguments());
  const Point point = arguments.nearest(quantity);
  if (kind == "double") return Propagated::exact(quantity.by_fast(point, {}));
  const Propagated by_ref = as_propagated(quantity.by_ref(arguments.exact, digits));
  if (kind == "ref") return by_ref;
  if (kind == "printed") {
    const auto form = std::ranges::find(quantity.seed_forms, "printed", &SeedForm::name);
    if (form == quantity.seed_forms.end()) brackets.refuse("a quantity that the seed prints");
    return printed_form(form->value(point));
  }
  const double value = quantity.by_fast(point, {});
  const double promised = quantity.promise * ulp_of(std::max(std::fabs(value), quantity.envelope(point)));
  const Propagated change = as_propagated(ref_value(quantity, point, digits)) - by_ref;
  return {value, promised + std::fabs(change.value()) + change.error()};
}

}  // namespace

Propagated result_of(const Brackets& brackets, const SolvedContact<fast::Estimate>& contact) {
  const std::string& name = brackets.names.back();
  const data::SceneResult* const what = data::find_scene_result(name);
  if (what == nullptr) brackets.refuse(fmt::format("no '{}'", name));
  if (what->shape == data::Shape::number) return contact.number(what->id);
  const double at = brackets.number("at", 0);
  if (what->shape == data::Shape::list) return contact.get(what->id).at(static_cast<std::size_t>(at));
  return contact.at(what->id, at);
}

namespace {

constexpr data::ElasticMaterial thesis_sheet = data::seed::sheet_of_the_tables;

ViscoelasticMaterial solid_of(const Brackets& brackets) {
  const double memory = brackets.number("memory", 1);
  const std::string name = brackets.text_of("solid", "thesis");
  if (name == "elastic") return data::elastic_solid(thesis_sheet);
  if (name == "thesis")
    return data::single_relaxation_time_solid({thesis_sheet.theta1(), thesis_sheet.theta2()}, memory);
  if (name == "one_time") return data::single_relaxation_time_solid(1, 0.375, memory);
  if (name == "one_time_misprinted")
    return data::single_relaxation_time_solid(1, 0.375, memory, data::misprinted_rate_factor);
  if (name != "two_times") brackets.refuse(fmt::format("no '{}'", name));
  // The moduli in shear and dilatation relax by different parts.
  return data::prony_solid({1.3, {0.4 / memory, 0.9 / memory}, {1 / memory, 3 / memory}},
                           {0.5, {0.1 / memory, 0.3 / memory}, {1 / memory, 3 / memory}});
}

Propagated of_material(const Brackets& brackets) {
  const data::MaterialFunctions functions = solid_of(brackets).functions().value();
  const std::string& name = brackets.name(1);
  if (name != "theta1" && name != "theta2") brackets.refuse(fmt::format("no '{}'", name));
  const double value =
      (name == "theta1" ? functions.theta1 : functions.theta2).transform(brackets.number("p", 0)).real();
  // The value is a sum of a few products, so that this bounds its rounding error.
  return {value, 0x1p-48 * std::fabs(value)};
}

Propagated printed_cell(const Brackets& brackets) {
  const data::Table table = data::load_table_by_id(brackets.name(1));
  const std::string& column = brackets.given.at(0).second;
  const auto& [key, value] = brackets.given.at(1);
  const double wanted = brackets.formulas.value(value).value();
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const auto& here = table.cell(row, key).number;
    const auto& printed = table.cell(row, column).number;
    if (here && printed && std::fabs(here->value / wanted - 1) < 1e-6)
      return Propagated::exact(printed->value);
  }
  brackets.refuse("a row that is printed");
}

/// mu_R by ten line loads on the leading side that start at `distance` before the nip.
Propagated started_resistance(const Brackets& brackets) {
  const data::ViscoelasticNip nip{6, brackets.number("thickness", 2), solid_of(brackets), 1};
  const double half_thicknesses = brackets.number("distance", 1) / nip.half_thickness();
  const data::ViscoelasticLineLoads method{10, {}, half_thicknesses, 0};
  return printed_form(
      fast::line_loads_for_load(nip, method, brackets.number("load", 0)).rolling_resistance());
}

SolvedInDouble contact_of_nip(const Brackets& brackets) {
  const auto number = [&](const char* key, double otherwise) { return brackets.number(key, otherwise); };
  const double radius = number("radius", 6), thickness = number("thickness", 2), length = number("length", 0),
               accuracy = number("accuracy", 1e-9);
  data::Given given = data::GivenLength{length};
  if (!(length > 0)) given = data::GivenLoad{number("load", 0)};
  if (brackets.name(0) == "rolling")
    return solve_nip(
        data::ViscoelasticNipProblem{.nip = {radius, thickness, solid_of(brackets), number("speed", 1)},
                                     .given = given},
        accuracy);
  const data::ElasticNip nip{
      radius, thickness, {number("young", thesis_sheet.young), number("poisson", thesis_sheet.poisson)}};
  if (const double mu = number("mu", 0); mu > 0)
    return solve_nip(data::PartialSlipProblem{.nip = {nip, mu, data::GivenTraction{number("traction", 0)}},
                                              .given = given},
                     accuracy);
  const auto friction =
      brackets.text_of("friction", "none") == "full" ? data::Friction::full : data::Friction::none;
  return solve_nip(data::ElasticNipProblem{.nip = nip, .given = given, .friction = friction}, accuracy);
}

/// The exact contact of the steel sphere that slides over the graphite epoxy, whose axis is in the surface along x2.
SolvedInDouble contact_of_sliding_sphere(const Brackets& brackets) {
  const data::IsotropicSolid& of_sphere = data::seed::steel;
  return solve_half_space(
      {.body = data::ElasticSphere{1, of_sphere, true},
       .half_space =
           data::TransverselyIsotropicBody{data::seed::graphite_epoxy, data::SymmetryAxis::in_plane},
       .speed = brackets.number("speed", 0) * std::sqrt(of_sphere.shear / of_sphere.density),
       .direction = brackets.number("direction", 0),
       .given = data::GivenNormalForce{1e-6}});
}

const std::map<std::string, SolvedInDouble (*)(const Brackets&)> contacts_by_kind{
    {"elastic", contact_of_nip}, {"rolling", contact_of_nip}, {"sliding_sphere", contact_of_sliding_sphere}};

const std::map<std::string, Propagated (*)(const Brackets&)> other_kinds{
    {"ref", of_quantity},
    {"fast", of_quantity},
    {"printed", of_quantity},
    {"double", of_quantity},
    {"material", of_material},
    {"table", printed_cell},
    {"started", started_resistance},
    {"computed", [](const Brackets& one) { return entry_of(computed_numbers(), one.name(1), one)(); }}};

}  // namespace

Brackets::Brackets(const std::string& words, Formulas& scope) : text(words), formulas(scope) {
  for (const std::string& word : words_of(words)) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) {
      names.push_back(word);
    } else {
      given.emplace_back(word.substr(0, equals), word.substr(equals + 1));
    }
  }
}

void Brackets::refuse(std::string_view lacking) const {
  throw data::BadInput("formula", "[" + text + "]", fmt::format("must have {}", lacking));
}

const std::string& Brackets::name(std::size_t i) const {
  if (i >= names.size()) refuse(fmt::format("{} names", i + 1));
  return names[i];
}

std::string Brackets::text_of(const std::string& key, const std::string& otherwise) const {
  const auto* const found = item_with(given, &Assignments::value_type::first, key);
  return found == nullptr ? otherwise : found->second;
}

double Brackets::number(const std::string& key, std::optional<double> otherwise) const {
  const std::string formula = text_of(key, "");
  if (formula.empty() && !otherwise) refuse(key + "=VALUE");
  return formula.empty() ? *otherwise : formulas.value(formula).value();
}

Assignments Brackets::arguments() const {
  Assignments all = given;
  for (auto& [key, value] : all)
    if (value.starts_with('$')) value = fmt::format("{}", formulas.value(value.substr(1)).value());
  return all;
}

std::string with_fields(const std::string& text,
                        const std::function<std::string(const std::string&, const std::string&)>& written) {
  std::string all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = std::min(text.find('{', at), text.size());
    all += text.substr(at, open - at);
    if (open == text.size()) break;
    const std::size_t close = text.find('}', open), colon = std::min(text.find(':', open), close);
    all += written(text.substr(open + 1, colon - open - 1), text.substr(colon, close - colon));
    at = close + 1;
  }
  return all;
}

Propagated SolvedNumbers::operator()(const std::string& words, Formulas& formulas) const {
  const Brackets brackets(words, formulas);
  if (brackets.names.size() != 2) brackets.refuse("2 names");
  return contacts_by_kind.contains(brackets.name(0))
             ? result_of(brackets, contact(brackets))
             : entry_of(other_kinds, brackets.name(0), brackets)(brackets);
}

const SolvedContact<fast::Estimate>& SolvedNumbers::contact(const Brackets& brackets) const {
  std::map<std::string, std::string> inputs{{"", brackets.name(0)}};
  for (const auto& [key, text] : brackets.given) {
    const bool is_word = key == "friction" || key == "solid";
    if (key != "at") inputs[key] = is_word ? text : fmt::format("{}", brackets.number(key));
  }
  SolvedInDouble& solved = (*contacts_)[inputs];
  if (solved == nullptr) solved = entry_of(contacts_by_kind, brackets.name(0), brackets)(brackets);
  return *solved;
}

StatementFormulas::StatementFormulas(const TomlTable& file, const TomlTable& entry)
    : entry_(entry), formulas_(SolvedNumbers(), statements_file("claims.toml").text("functions")) {
  if (const std::string named = entry.text_or("setting", ""); !named.empty()) {
    const TomlTable& setting = file.entry("setting", named);
    setting.located([&] { formulas_.define(setting.text("given")); });
    setting_ = setting.text_or("at", "");
  }
  entry.located([&] { formulas_.define(entry.text_or("given", "")); });
}

Propagated StatementFormulas::value(const std::string& formula) {
  return entry_.located([&] { return formulas_.value(formula); });
}

}  // namespace nipref::verify
