#include <fmt/format.h>

#include <cmath>

#include <nipref/data/scene/internal/require.hpp>

namespace nipref::data {

void require(bool holds, const SceneOrigin& origin, std::string_view key, double value,
             std::string_view allowed) {
  if (!holds) origin.refuse(key, value, allowed);
}

void require_positive(double value, const SceneOrigin& origin, std::string_view key) {
  require(std::isfinite(value) && value > 0, origin, key, value, "must be finite and > 0");
}

void require_whole(int value, int least, int most, const SceneOrigin& origin, std::string_view key) {
  require(least <= value && value <= most, origin, key, value,
          fmt::format("must be a whole number from {} to {}", least, most));
}

}  // namespace nipref::data
