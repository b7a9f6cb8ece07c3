#include <fmt/format.h>

#include <nipref/data/scene/internal/profile.hpp>
#include <nipref/data/scene/internal/require.hpp>

namespace nipref::data {
namespace {

constexpr std::size_t most_positions = 10'000;

struct ProfileCheck {
  const SceneOrigin& origin;

  void operator()(const EvenlySpaced& spacing) const {
    check_domain(spacing.points, origin, "profile.points");
  }
  void operator()(const Positions& positions) const {
    if (positions.y.empty()) origin.refuse("profile.positions", "[]", "must hold at least one position");
    require(positions.y.size() <= most_positions, origin, "profile.positions",
            static_cast<double>(positions.y.size()), "of them: must be at most 10000");
    for (std::size_t i = 0; i < positions.y.size(); ++i) {
      check_domain(positions.y[i], origin, fmt::format("profile.positions[{}]", i));
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
