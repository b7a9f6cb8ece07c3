#pragma once
#include <array>
#include <functional>
#include <vector>

#include <nipref/fast/half_space/direction.hpp>

namespace nipref::fast::internal {

/// A compliance as a function of the direction; opposite directions have the same compliance.
using Compliance = std::function<double(Direction)>;

/// A compliance by interpolation between the Chebyshev points of pieces, for searches that need many directions. A piece
/// is halved until it agrees to about 1e-10 with the points of its halves, or until 2^13 lines have been computed.
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
    [[nodiscard]] double angle(std::size_t j) const;  ///< angle of value j
    [[nodiscard]] double at(double angle) const;
    [[nodiscard]] bool agrees(const Piece& half) const;
  };

  std::vector<Piece> pieces_;  ///< in ascending order, from -pi/2 to pi/2
};

}  // namespace nipref::fast::internal
