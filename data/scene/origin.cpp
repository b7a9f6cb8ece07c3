#include <fmt/format.h>

#include <nipref/data/scene/keys.hpp>
#include <nipref/data/scene/origin.hpp>

namespace nipref::data {

std::string SceneOrigin::locate(std::string_view key) const {
  if (file_.empty()) return std::string(key);
  for (std::string_view part = key; !part.empty();) {
    if (given_.contains(part)) return std::string(key);
    const auto found = lines_.find(part);
    if (found != lines_.end()) return fmt::format("{}:{}: {}", file_, found->second, key);
    const std::size_t cut = part.find_last_of(".[");
    part = part.substr(0, cut == std::string_view::npos ? 0 : cut);
  }
  return fmt::format("{}: {}", file_, key);
}

void SceneOrigin::refuse(std::string_view key, std::string_view value, std::string_view allowed) const {
  const auto given = given_.find(key);
  throw BadInput(locate(key), given == given_.end() ? value : given->second, allowed);
}

void SceneOrigin::refuse(std::string_view key, double value, std::string_view allowed) const {
  refuse(key, fmt::format("{}", value), allowed);
}

void SceneOrigin::refuse_as(std::string_view key, const BadInput& error) const {
  refuse(key, error.value(), error.allowed());
}

void SceneOrigin::require(bool holds, std::string_view key, double value, std::string_view allowed) const {
  if (!holds) refuse(key, value, allowed);
}

void SceneOrigin::require_whole(std::string_view key, int value, int least, int most) const {
  require(least <= value && value <= most, key, value,
          fmt::format("must be a whole number from {} to {}", least, most));
}

void SceneOrigin::check_domain(std::string_view key, double value) const {
  const std::string_view allowed = find_scene_key(key)->refusal_of(value);
  require(allowed.empty(), key, value, allowed);
}

void SceneOrigin::check_domain(std::string_view key, const std::vector<double>& list) const {
  for (std::size_t i = 0; i < list.size(); ++i) check_domain(fmt::format("{}[{}]", key, i), list[i]);
}

}  // namespace nipref::data
