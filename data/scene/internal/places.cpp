// Where results are wanted: the tables [profile] and [field].
#include <nipref/data/scene/internal/check.hpp>
#include <nipref/data/scene/internal/read.hpp>

namespace nipref::data {

Profile read_profile(const SceneTable& profile, const SceneOrigin& origin) {
  if (profile.has("points") == profile.has("positions")) {
    origin.refuse("profile", profile.has("points") ? "(points and positions)" : "(empty)",
                  "must hold points or positions, one of the two");
  }
  if (profile.has("points")) return EvenlySpaced{profile.whole("points")};
  return Positions{profile.numbers("positions")};
}

void check_profile(const Profile& profile, const SceneOrigin& origin) {
  constexpr std::size_t most_positions = 10'000;
  if (const auto* const spacing = std::get_if<EvenlySpaced>(&profile))
    return origin.check_domain("profile.points", spacing->points);
  const std::vector<double>& positions = std::get<Positions>(profile).y;
  if (positions.empty()) origin.refuse("profile.positions", "[]", "must hold at least one position");
  origin.require(positions.size() <= most_positions, "profile.positions",
                 static_cast<double>(positions.size()), "of them: must be at most 10000");
  origin.check_domain("profile.positions", positions);
}

FieldPlaces read_field(const SceneTable& field) {
  return {field.numbers("positions"), field.numbers("depths")};
}

void check_field(const FieldPlaces& field, const SceneOrigin& origin) {
  constexpr std::size_t most_places = 100'000;
  if (field.positions.empty()) origin.refuse("field.positions", "[]", "must hold at least one position");
  if (field.depths.empty()) origin.refuse("field.depths", "[]", "must hold at least one depth");
  origin.require(field.size() <= most_places, "field.depths", static_cast<double>(field.size()),
                 "places with all positions: must be at most 100000");
  origin.check_domain("field.positions", field.positions);
  origin.check_domain("field.depths", field.depths);
}

}  // namespace nipref::data
