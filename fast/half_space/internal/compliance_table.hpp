#pragma once
#include <array>
#include <functional>
#include <vector>

#include <nipref/fast/half_space/direction.hpp>

namespace nipref::fast::internal {

/// A compliance in each direction, opposite ones alike.
using Compliance = std::function<double(Direction)>;

/// A compliance by interpolation between Chebyshev points of pieces, for searches that ask for many directions. Pieces are
/// halved until they agree to about 1e-10 with the points of their halves, or 2^13 lines have been computed.
class ComplianceTable {
 public:
  explicit ComplianceTable(const Compliance& compliance);
  [[nodiscard]] double operator()(Direction psi) const;

 private:
  static constexpr std::size_t points = 16;
  struct Piece {
    double lower, upper;  ///< angles
    std::array<double, points> values;

    Piece(const Compliance& compliance, double from, double to);
    [[nodiscard]] double angle(std::size_t j) const;  ///< of a value
    [[nodiscard]] double at(double angle) const;
    [[nodiscard]] bool agrees(const Piece& half) const;
  };

  std::vector<Piece> pieces_;  ///< rising, from -pi/2 to pi/2
};

}  // namespace nipref::fast::internal
