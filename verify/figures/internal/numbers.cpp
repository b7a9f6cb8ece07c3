#include <nipref/data/material/seed_solids.hpp>
#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/data/scene/file.hpp>
#include <nipref/fast/memory/plain_moving_load.hpp>
#include <nipref/fast/sheet/plain_series.hpp>
#include <nipref/verify/figures/internal/drawings.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>

namespace nipref::verify {
namespace {

/// The number of residues of the thesis's viscoelastic tables. For the elastic tables the thesis states none.
constexpr int residues = 500;
constexpr double stated_bulk = data::seed::sheet.young,
                 stated_shear = data::thesis_shear_over_bulk * stated_bulk;

double plain_sum(const Brackets& brackets) {
  const auto number = [&](const char* key) { return brackets.number(key); };
  const std::string& name = brackets.name(1);
  if (name == "Un" || name == "Vn") {
    constexpr double half_thickness = 0.0025, speed = 1;
    const fast::PlainMovingLoad load(
        data::single_relaxation_time_solid(stated_bulk, stated_shear, number("memory"),
                                           data::misprinted_rate_factor),
        speed, half_thickness, residues);
    return name == "Un" ? load.normal_displacement(number("t"), number("T"))
                        : load.tangential_displacement(number("t"), number("T"), number("t0"));
  }
  const std::array at{number("x")};
  std::array<double, 1> I1{}, I3{}, I6{};
  fast::plain_series(at, residues, {I1, I3, I6});
  return name == "I1" ? I1[0] : name == "I3" ? I3[0] : I6[0];
}

/// The contact of a scene with the given values of the scene's keys.
const SolvedContact<fast::Estimate>& scene_of(const Brackets& brackets, const FigureScope& scope,
                                              FigureContacts& contacts) {
  const std::string& name = brackets.name(1);
  data::SceneOverrides keys{{"method.kind", brackets.name(2)}};
  std::string all = name + " " + brackets.name(2);
  for (const auto& [key, formula] : brackets.given) {
    if (key == "at") continue;
    keys.emplace_back(key, fmt::format("{}", brackets.number(key)));
    all += " " + keys.back().second;
  }
  SolvedInDouble& contact = contacts.scenes[all];
  if (contact == nullptr) {
    const std::string id = name == "shown" ? scope.shown->text("scene") : name;
    const data::Scene scene = data::load_scene({id, drawings_file().entry("scene", id).text("text")}, keys);
    contact = solve_half_space(std::get<data::HalfSpaceProblem>(scene.system));
  }
  return *contact;
}

}  // namespace

FigureFormulas::FigureFormulas(const FigureScope& of, FigureContacts& contacts)
    : scope(of),
      contacts_(contacts),
      formulas_([this](const std::string& words, Formulas&) { return solve(words); }) {
  for (const auto& [list, words] : scope.row->lists)
    if (words.size() == 1) define(list, scope.row->numbers(list).front());
  if (!tables().empty()) define_parameters(tables().front().table);
  for (const auto& [list, number] : scope.numbers) define(list, number);
  for (const std::string& lines : scope.given) formulas_.define(lines);
}

Propagated FigureFormulas::solve(const std::string& words) {
  const Brackets brackets(words, formulas_);
  const std::string& kind = brackets.name(0);
  if (kind == "plain") return Propagated::exact(plain_sum(brackets));
  if (kind == "nip") return result_of(brackets, nip());
  if (kind == "scene") return result_of(brackets, scene_of(brackets, scope, contacts_));
  if (kind != "replayed") return contacts_.others(words, formulas_);
  if (replayed_ == nullptr || !replayed_->contains(brackets.name(1)))
    brackets.refuse("a column of a nip's table");
  return Propagated::exact(replayed_->at(brackets.name(1)));
}

const SolvedContact<fast::Estimate>& FigureFormulas::nip() {
  const bool remembers = value("memory") != 0, full_friction = value("full_friction") != 0;
  return contacts_.others.contact(
      {fmt::format("{} nip thickness=B load=load accuracy=accuracy {}", remembers ? "rolling" : "elastic",
                   remembers       ? "memory=memory"
                   : full_friction ? "friction=full"
                                   : "friction=none"),
       formulas_});
}

std::span<const Replay> FigureFormulas::tables() const {
  return scope.table != nullptr ? std::span(scope.table, 1) : std::span<const Replay>(scope.row->tables);
}

void FigureFormulas::define_parameters(const data::Table& table) {
  for (const data::TableParameter& one : table.parameters) define(one.name, one.value);
  const auto how = std::ranges::find(line_load_tables(), table.id, &LineLoadTable::id);
  define("full_friction", how != line_load_tables().end() && how->friction == data::Friction::full ? 1 : 0);
}

void FigureFormulas::enter(const Replay& replay, const ReplayedCell& cell) {
  const data::Table& table = replay.table;
  define_parameters(table);
  define("key", key_of_row(table, cell.row));
  define("coordinate", table.columns[table.column_index(cell.column)].coordinate.value_or(0));
  replayed_ = replay.nips.empty() ? nullptr : &replay.nips[cell.row].values;
}

std::string FigureFormulas::text(const std::string& stated) {
  return with_fields(stated, [&](const std::string& field, const std::string& format) {
    if (!format.empty()) return fmt::format(fmt::runtime("{" + format + "}"), value(field));
    if (field == "label") return text(scope.row->label);
    if (field == "slip") return std::string(value("full_friction") != 0 ? "no slip" : "complete slip");
    return scope.shown->text(field);
  });
}

}  // namespace nipref::verify
