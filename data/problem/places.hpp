#pragma once
#include <cstddef>
#include <variant>
#include <vector>

namespace nipref::data {

/// The places of a scene's profiles. In a nip they are Y, counted from the line through the rollers' centres towards
/// the entry side. On a half-space they are angles from the motion, in degrees, or positions on a line, counted from
/// the point of first touch.
struct EvenlySpaced {
  /// 2 to 10000 points, the ends included: from the middle of an elastic nip, or the trailing end of a viscoelastic
  /// one, to the leading end; from -90 to 90 degrees; or from end to end of a line.
  int points;
};
struct Positions {
  std::vector<double>
      y;  ///< finite, unit of length or degrees, inside the contact or outside; 1 to 10000 of them
};
using Profile = std::variant<EvenlySpaced, Positions>;

inline int count_of(const Profile& profile) {
  if (const auto* spacing = std::get_if<EvenlySpaced>(&profile)) return spacing->points;
  return static_cast<int>(std::get<Positions>(profile).y.size());
}

/// The places inside the sheet of a nip at which fields are wanted: all positions at each depth.
struct FieldPlaces {
  std::vector<double> positions;  ///< Y as in Profile, unit of length, finite; field.positions
  std::vector<double> depths;     ///< depth/half-thickness, -1 to 1, 0 is the middle plane; field.depths

  [[nodiscard]] std::size_t size() const { return positions.size() * depths.size(); }
};

}  // namespace nipref::data
