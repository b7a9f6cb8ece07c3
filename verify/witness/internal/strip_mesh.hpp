#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace nipref::verify::calculix {

/// The positions of nodes along a side: corners alternate with the midpoints between them.
using Side = std::vector<double>;

/// Distances from 0 to `length` in steps that start with `first` and grow by 1.15 up to `largest`. All steps are
/// scaled so that the last one ends at `length`.
inline std::vector<double> graded(double length, double first, double largest) {
  std::vector<double> distances{0};
  for (double step = first; distances.back() < length; step = std::min(1.15 * step, largest)) {
    distances.push_back(distances.back() + step);
  }
  const double stretch = length / distances.back();
  for (double& distance : distances) distance *= stretch;
  return distances;
}

/// The same from the other end: the first step is the last before `length`.
inline std::vector<double> graded_towards(double length, double first, double largest) {
  std::vector<double> positions = graded(length, first, largest);
  for (double& position : positions) position = length - position;
  std::ranges::reverse(positions);
  return positions;
}

inline Side with_middles(const std::vector<double>& corners) {
  Side side{corners.front()};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    side.push_back((corners[i - 1] + corners[i]) / 2);
    side.push_back(corners[i]);
  }
  return side;
}

/// Eight-node elements of half a sheet in plane strain: y >= 0 along the sheet from the middle of the nip, z from the
/// middle plane, 0, to the surface, `half_thickness`. The elements are smallest at the contact's end, where the
/// tractions end like square roots. The strip ends four thicknesses beyond, where the effect of the load has decayed
/// to e^{-2.1 8}.
struct StripMesh {
  StripMesh(double half_thickness, double contact_end) {
    const double first = contact_end / 1000;
    const double largest = half_thickness / 6;
    std::vector<double> corners = graded_towards(contact_end, first, largest);
    contact_nodes = 2 * corners.size() - 1;
    const std::vector<double> outwards = graded(8 * half_thickness, first, largest);
    for (std::size_t i = 1; i < outwards.size(); ++i) corners.push_back(contact_end + outwards[i]);
    along = with_middles(corners);
    across = with_middles(graded_towards(half_thickness, first, largest));
  }

  /// The number of the node in column i and row k; rows of midpoints have nodes in every second column only.
  [[nodiscard]] std::size_t number(std::size_t i, std::size_t k) const { return 1 + i + along.size() * k; }
  [[nodiscard]] std::size_t surface_number(std::size_t i) const { return number(i, across.size() - 1); }

  Side along, across;
  std::size_t contact_nodes;  ///< columns 0 .. contact_nodes - 1 are prescribed
};

}  // namespace nipref::verify::calculix
