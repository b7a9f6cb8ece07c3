#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include <nipref/data/scene/file.hpp>
#include <nipref/verify/audit/internal/drawn_scene.hpp>
#include <nipref/verify/support/mapped.hpp>

namespace nipref::verify {
namespace {

/// Numbers of 34 bits, whose products with a few small whole numbers are exact.
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

/// The value in TOML. A number without point and exponent would be a whole one.
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

template <data::Friction friction>
DrawnScene nip(Random& random) {
  return draw_elastic_nip(random, friction);
}
template <RollingMaterial material>
DrawnScene nip(Random& random) {
  return draw_rolling_nip(random, material);
}
template <Body body, data::ContourRule rule>
DrawnScene half_space(Random& random) {
  return draw_on_half_space(random, body, rule);
}

struct Kind {
  std::string_view name;
  DrawnScene (*draw)(Random& random);
};

using data::ContourRule;
constexpr std::array kinds{
    Kind{"elastic, no friction", nip<data::Friction::none>},
    Kind{"elastic, full friction", nip<data::Friction::full>},
    Kind{"rolling, elastic", nip<RollingMaterial::elastic>},
    Kind{"rolling, standard linear solid", nip<RollingMaterial::standard_linear>},
    Kind{"rolling, Prony series", nip<RollingMaterial::prony>},
    Kind{"rolling, operators", nip<RollingMaterial::operators>},
    Kind{"die, exact", half_space<Body::die, ContourRule::exact>},
    Kind{"die, papers' rule", half_space<Body::die, ContourRule::stationary_force>},
    Kind{"rolling sphere", half_space<Body::rolling_sphere, ContourRule::stationary_force>},
    Kind{"sphere, exact", half_space<Body::sphere, ContourRule::exact>},
    Kind{"sphere, papers' rule", half_space<Body::sphere, ContourRule::stationary_force>},
    Kind{"die, similar contour", half_space<Body::die, ContourRule::similar_contour>},
    Kind{"rolling, Coulomb's friction", draw_partial_slip},
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
  static const auto names = mapped(kinds, &Kind::name);
  return names;
}

DrawnScene draw_scene(const std::string& seed, std::uint64_t index) {
  Random random(fmt::format("scene {} of {}", index, seed));
  const Kind& kind = kinds[index % kinds.size()];
  DrawnScene drawn = kind.draw(random);
  drawn.set("title", fmt::format("{}, scene {} of seed {}", kind.name, index, seed));
  drawn.set("accuracy", random.log_uniform(1e-13, 1e-2));
  if (index / kinds.size() % 2 == 0) {
    for (auto& [key, value] : drawn.keys()) std::visit(Shorten{}, value);
    drawn.set("accuracy", std::max(1e-13, drawn.number("accuracy")));
  }
  return drawn;
}

}  // namespace nipref::verify
