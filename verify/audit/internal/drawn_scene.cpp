#include <nipref/data/material/stiffness.hpp>
#include <nipref/data/scene/file.hpp>
#include <nipref/fast/material/functions.hpp>
#include <nipref/verify/audit/internal/scene_audit.hpp>
#include <nipref/verify/seeds/internal/solved.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

using data::ResultId;

/// Writes a value in TOML. A number without a point or exponent would be read as an integer.
struct TomlText {
  std::string operator()(double number) const {
    std::string text = fmt::format("{}", number);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
  }
  std::string operator()(const std::string& text) const { return fmt::format("\"{}\"", text); }
  std::string operator()(data::ResultId id) const {
    return fmt::format("\"{}\"", data::scene_result(id).name);
  }
  template <class Item>
  std::string operator()(const std::vector<Item>& items) const {
    return fmt::format("[{}]", fmt::join(mapped(items, *this), ", "));
  }
};

const TomlTable& drawn_file() {
  static const auto& file = statements_file("drawn_scenes.toml");
  static const auto& checked =
      file.list("part", {"id"}, {"if", "given", "keys", "without", "wanted", "unwanted", "stiffness"});
  static_cast<void>(checked);
  return file;
}

/// Thrown if the scene that is drawn so far is refused.
struct RefusedSoFar {};

/// A positive definite stiffness as a triangular matrix times its transpose, with moduli within about a decade.
std::vector<double> draw_stiffness(Random& random, double unit) {
  data::Stiffness::Voigt factor{};
  for (std::size_t i = 0; i < 6; ++i) {
    const double size = random.log_uniform(1, 4);
    for (std::size_t k = 0; k <= i; ++k) factor[i][k] = i == k ? size : size * random.uniform(-0.5, 0.5);
  }
  const data::Stiffness::Voigt product = data::Stiffness::squared(factor, unit);
  return mapped(data::upper_triangle, [&](const auto& at) { return product[at.first][at.second]; });
}

/// The results of converged nips that need no friction, without the moments, which the eccentricity covers.
std::vector<ResultId> results_of_every_nip() {
  std::vector<ResultId> wanted;
  for (const data::SceneResult& result : data::scene_results()) {
    const bool is_moment = result.id == ResultId::leading_moment || result.id == ResultId::trailing_moment;
    const bool is_of_all = result.needs == data::Needs::nothing || result.needs == data::Needs::converged ||
                           result.needs == data::Needs::inside || result.needs == data::Needs::inside_all;
    if (result.is_of(data::SceneKind::nip) && is_of_all && !is_moment) wanted.push_back(result.id);
  }
  return wanted;
}

/// Draws one scene, part by part.
class SceneDrawing {
 public:
  explicit SceneDrawing(Random& random) : random_(random) { formulas_.define(drawn_file().text("given")); }

  void add(const TomlTable& part) {
    if (value(part.text_or("if", "1")) == 0) return;
    try {
      formulas_.define(part.text_or("given", ""));
    } catch (const RefusedSoFar&) {
      return;  // reading the scene again reports the refusal
    }
    for (const std::string& key : words_of(part.text_or("without", ""))) drawn.remove(key);
    for (const std::string& word : words_of(part.text_or("keys", ""))) {
      const std::size_t equals = word.find('=');
      drawn.set(word.substr(0, equals), key_value(word.substr(equals + 1)));
    }
    if (const std::string key = part.text_or("stiffness", ""); !key.empty()) {
      const std::vector<double> upper = draw_stiffness(random_, value("unit"));
      formulas_.define("stiffness", Propagated::exact(upper.back()));
      drawn.set(key, upper);
    }
    set_wanted(part);
  }

  DrawnScene drawn;

 private:
  double value(const std::string& formula) { return formulas_.value(formula).value(); }

  DrawnScene::Value key_value(const std::string& stated) {
    const std::string inside = stated.substr(1, stated.size() - 2);
    if (stated.starts_with('\'')) return inside;
    if (!stated.starts_with('[')) return value(stated);
    return mapped(parts_of(inside, ","), [this](const std::string& formula) { return value(formula); });
  }

  void set_wanted(const TomlTable& part) {
    std::vector<ResultId> wanted = drawn.has("wanted") ? drawn.wanted() : std::vector<ResultId>();
    const auto result = [&](const std::string& name) {
      const data::SceneResult* const found = data::find_scene_result(name);
      if (found == nullptr) part.refuse(fmt::format("must want results, and not '{}'", name));
      return found->id;
    };
    for (const std::string& name : words_of(part.text_or("unwanted", ""))) std::erase(wanted, result(name));
    for (const std::string& name : words_of(part.text_or("wanted", "")))
      std::ranges::copy(name == "of_every_nip" ? results_of_every_nip() : std::vector{result(name)},
                        std::back_inserter(wanted));
    drawn.set_wanted(std::move(wanted));
  }

  /// The value of the words that a formula has in brackets: a random number, or a property of the scene drawn so far.
  Propagated number(const std::string& words) {
    const std::vector<std::string> all = words_of(words);
    const std::string& kind = all.front();
    const auto at = [&](std::size_t i) { return value(all.at(i)); };
    if (kind == "uniform") return exact(random_.uniform(at(1), at(2)));
    if (kind == "log") return exact(random_.log_uniform(at(1), at(2)));
    if (kind == "chance") return exact(random_.chance(at(1)) ? 1 : 0);
    if (kind == "index") return exact(static_cast<double>(random_.index(static_cast<std::size_t>(at(1)))));
    DrawnScene so_far = drawn;
    so_far.set("title", "what is drawn so far");
    try {
      if (kind == "critical_speed") {
        so_far.set_wanted({ResultId::critical_speed});
        return exact(solve(so_far.scene())[ResultId::critical_speed].value);
      }
      const data::MaterialFunction compliance =
          fast::material_functions(std::get<data::ViscoelasticNipProblem>(so_far.scene().system).nip.material)
              .normal_compliance();
      return exact(all.at(1) == "at_once" ? compliance.instantaneous : compliance.long_time());
    } catch (const data::BadInput&) {
      throw RefusedSoFar();
    }
  }
  static Propagated exact(double value) { return Propagated::exact(value); }

  Random& random_;
  Formulas formulas_{[this](const std::string& words, Formulas&) { return number(words); }};
};

/// The bits of shortened numbers, whose products with a few small whole numbers are exact.
constexpr int short_bits = 34;

double shortened(double number) {
  int exponent = 0;
  const double mantissa = std::frexp(number, &exponent);
  return std::ldexp(std::round(std::ldexp(mantissa, short_bits)), exponent - short_bits);
}

struct Shorten {
  void operator()(double& number) const { number = shortened(number); }
  void operator()(std::vector<double>& numbers) const {
    for (double& number : numbers) number = shortened(number);
  }
  void operator()(const auto&) const {}
};

}  // namespace

std::string DrawnScene::toml() const {
  std::string top, tables, table;
  for (const auto& [key, value] : keys_) {
    const std::size_t dot = key.find('.');
    const std::string text = std::visit(TomlText{}, value);
    if (dot == std::string::npos) {
      top += fmt::format("{} = {}\n", key, text);
      continue;
    }
    if (key.substr(0, dot) != table) {
      table = key.substr(0, dot);
      tables += fmt::format("[{}]\n", table);
    }
    tables += fmt::format("{} = {}\n", key.substr(dot + 1), text);
  }
  return top + tables;
}

data::Scene DrawnScene::scene() const { return data::parse_scene(toml(), text("title")); }

const std::vector<std::string_view>& drawn_kinds() {
  static const auto names =
      mapped<std::string_view>(drawn_file().list("kind", {"id", "parts"}, {}),
                               [](const TomlTable& kind) -> const std::string& { return kind.text("id"); });
  return names;
}

DrawnScene draw_scene(const std::string& seed, std::uint64_t index) {
  const std::vector<TomlTable>& kinds = drawn_file().list("kind", {"id", "parts"}, {});
  const TomlTable& kind = kinds[index % kinds.size()];
  Random random(fmt::format("scene {} of {}", index, seed));
  SceneDrawing drawing(random);
  for (const std::string& part : words_of(kind.text("parts"))) drawing.add(drawn_file().entry("part", part));
  DrawnScene& drawn = drawing.drawn;
  drawn.set("title", fmt::format("{}, scene {} of seed {}", kind.text("id"), index, seed));
  drawn.set("accuracy", random.log_uniform(1e-13, 1e-2));
  if (index / kinds.size() % 2 == 0) {
    for (auto& [key, value] : drawn.keys()) std::visit(Shorten{}, value);
    drawn.set("accuracy", std::max(1e-13, drawn.number("accuracy")));
  }
  return drawn;
}

}  // namespace nipref::verify
