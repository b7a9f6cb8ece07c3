#include <fmt/format.h>

#include <nipref/data/scene/internal/require.hpp>
#include <nipref/data/scene/keys.hpp>

namespace nipref::data {

void require(bool holds, const SceneOrigin& origin, std::string_view key, double value,
             std::string_view allowed) {
  if (!holds) origin.refuse(key, value, allowed);
}

void check_domain(double value, const SceneOrigin& origin, std::string_view key) {
  const std::string_view allowed = find_scene_key(key)->refusal_of(value);
  require(allowed.empty(), origin, key, value, allowed);
}

void require_whole(int value, int least, int most, const SceneOrigin& origin, std::string_view key) {
  require(least <= value && value <= most, origin, key, value,
          fmt::format("must be a whole number from {} to {}", least, most));
}

}  // namespace nipref::data
