#include <fmt/format.h>

#include <cmath>

#include <nipref/data/magnitude.hpp>
#include <nipref/data/scene/internal/profile.hpp>
#include <nipref/data/scene/internal/require.hpp>

namespace nipref::data {
namespace {

constexpr int most_points = 10'000;

struct ProfileCheck {
  const SceneOrigin& origin;

  void operator()(const EvenlySpaced& spacing) const {
    require_whole(spacing.points, 2, most_points, origin, "profile.points");
  }
  void operator()(const Positions& positions) const {
    if (positions.y.empty()) origin.refuse("profile.positions", "[]", "must hold at least one position");
    require(positions.y.size() <= most_points, origin, "profile.positions",
            static_cast<double>(positions.y.size()), "of them: must be at most 10000");
    for (std::size_t i = 0; i < positions.y.size(); ++i) {
      const double y = positions.y[i];
      const std::string key = fmt::format("profile.positions[{}]", i);
      require(std::isfinite(y), origin, key, y, "must be finite");
      require(std::fabs(y) <= greatest_magnitude, origin, key, y, "must be from -1e60 to 1e60");
    }
  }
};

}  // namespace

Profile read_profile(const TomlTable& profile, const SceneOrigin& origin, SceneKind kind) {
  profile.allow(kind);
  if (profile.has("points") == profile.has("positions")) {
    origin.refuse("profile", profile.has("points") ? "(points and positions)" : "(empty)",
                  "must hold points or positions, one of the two");
  }
  if (profile.has("points")) return EvenlySpaced{profile.whole("points")};
  return Positions{profile.numbers("positions")};
}

void check_profile(const Profile& profile, const SceneOrigin& origin) {
  std::visit(ProfileCheck{origin}, profile);
}

}  // namespace nipref::data
