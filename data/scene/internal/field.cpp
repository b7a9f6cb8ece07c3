#include <fmt/format.h>

#include <cmath>

#include <nipref/data/magnitude.hpp>
#include <nipref/data/scene/internal/field.hpp>
#include <nipref/data/scene/internal/require.hpp>

namespace nipref::data {

FieldPlaces read_field(const TomlTable& field) {
  field.allow(SceneKind::nip);
  return {field.numbers("positions"), field.numbers("depths")};
}

void check_field(const FieldPlaces& field, const SceneOrigin& origin) {
  constexpr std::size_t most_places = 100'000;
  if (field.positions.empty()) origin.refuse("field.positions", "[]", "must hold at least one position");
  if (field.depths.empty()) origin.refuse("field.depths", "[]", "must hold at least one depth");
  require(field.size() <= most_places, origin, "field.depths", static_cast<double>(field.size()),
          "places with all positions: must be at most 100000");
  for (std::size_t i = 0; i < field.positions.size(); ++i) {
    require(std::fabs(field.positions[i]) <= greatest_magnitude, origin,
            fmt::format("field.positions[{}]", i), field.positions[i], "must be from -1e60 to 1e60");
  }
  for (std::size_t i = 0; i < field.depths.size(); ++i) {
    require(std::fabs(field.depths[i]) <= 1, origin, fmt::format("field.depths[{}]", i), field.depths[i],
            "must be from -1 to 1");
  }
}

}  // namespace nipref::data
