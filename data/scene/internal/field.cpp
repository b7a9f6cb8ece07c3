#include <fmt/format.h>

#include <nipref/data/scene/internal/field.hpp>
#include <nipref/data/scene/internal/require.hpp>

namespace nipref::data {

FieldPlaces read_field(const TomlTable& field) {
  return {field.numbers("positions"), field.numbers("depths")};
}

void check_field(const FieldPlaces& field, const SceneOrigin& origin) {
  constexpr std::size_t most_places = 100'000;
  if (field.positions.empty()) origin.refuse("field.positions", "[]", "must hold at least one position");
  if (field.depths.empty()) origin.refuse("field.depths", "[]", "must hold at least one depth");
  require(field.size() <= most_places, origin, "field.depths", static_cast<double>(field.size()),
          "places with all positions: must be at most 100000");
  for (std::size_t i = 0; i < field.positions.size(); ++i) {
    check_domain(field.positions[i], origin, fmt::format("field.positions[{}]", i));
  }
  for (std::size_t i = 0; i < field.depths.size(); ++i) {
    check_domain(field.depths[i], origin, fmt::format("field.depths[{}]", i));
  }
}

}  // namespace nipref::data
