#pragma once
#include <vector>

namespace nipref::data {

/// Where stresses inside the sheet of a nip are wanted: at each depth at all positions.
struct FieldPlaces {
  std::vector<double> positions;  ///< Y as in Profile, unit of length, finite; field.positions
  std::vector<double> depths;     ///< over half the thickness, -1 to 1, 0 is the middle plane; field.depths

  [[nodiscard]] std::size_t size() const { return positions.size() * depths.size(); }
};

}  // namespace nipref::data
