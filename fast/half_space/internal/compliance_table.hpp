#pragma once
#include <array>
#include <functional>
#include <vector>

#include <nipref/fast/half_space/direction.hpp>

namespace nipref::fast::internal {

/// A compliance in each direction, opposite ones alike.
using Compliance = std::function<double(Direction)>;

/// A compliance by interpolation between Chebyshev points of pieces, which are halved until the next points agree to about
/// 1e-10, or stand for at most 2^13 lines: for searches that ask for more directions than that.
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
