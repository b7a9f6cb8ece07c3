#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/fast/half_space/internal/compliance_table.hpp>

namespace nipref::fast::internal {
namespace {

constexpr double pi = std::numbers::pi;

/// The angle, -pi/2 to pi/2, of the direction or of its opposite.
double angle_of(Direction psi) {
  return psi.cosine < 0 ? std::atan2(-psi.sine, -psi.cosine) : std::atan2(psi.sine, psi.cosine);
}

double half_angle_of_point(std::size_t j, std::size_t points) {
  return (2 * static_cast<double>(j) + 1) * pi / (4 * static_cast<double>(points));
}

/// Of the interval [0, 1].
double chebyshev_point(std::size_t j, std::size_t points) {
  return std::pow(std::sin(half_angle_of_point(j, points)), 2);
}

}  // namespace

ComplianceTable::Piece ComplianceTable::piece(const Compliance& compliance, double lower, double upper) {
  Piece result{lower, upper, {}};
  for (std::size_t j = 0; j < points; ++j)
    result.values[j] = compliance(Direction::of_angle(lower + (upper - lower) * chebyshev_point(j, points)));
  return result;
}

/// The barycentric formula of the second kind.
double ComplianceTable::Piece::at(double angle) const {
  static const auto nodes = [] {
    std::array<std::array<double, 2>, points> result;
    for (std::size_t j = 0; j < points; ++j)
      result[j] = {chebyshev_point(j, points),
                   std::sin(2 * half_angle_of_point(j, points)) * (j % 2 == 0 ? 1 : -1)};
    return result;
  }();
  const double x = (angle - lower) / (upper - lower);
  double above = 0, below = 0;
  for (std::size_t j = 0; j < points; ++j) {
    const auto& [node, weight] = nodes[j];
    if (x == node) return values[j];
    above += weight / (x - node) * values[j];
    below += weight / (x - node);
  }
  return above / below;
}

ComplianceTable::ComplianceTable(const Compliance& compliance) {
  constexpr double tolerance = 1e-10;
  constexpr std::size_t most_pieces = (1 << 13) / points;
  std::vector<Piece> pending{piece(compliance, -pi / 2, 0), piece(compliance, 0, pi / 2)};
  for (std::size_t made = pending.size(); !pending.empty();) {
    std::vector<Piece> halves;
    for (const Piece& whole : pending) {
      const double middle = (whole.lower + whole.upper) / 2;
      const Piece left = piece(compliance, whole.lower, middle),
                  right = piece(compliance, middle, whole.upper);
      const auto agrees = [&](const Piece& half) {
        for (std::size_t j = 0; j < points; ++j) {
          const double angle = half.lower + (half.upper - half.lower) * chebyshev_point(j, points);
          if (!(std::fabs(whole.at(angle) - half.values[j]) <= tolerance * half.values[j])) return false;
        }
        return true;
      };
      const bool is_done = (agrees(left) && agrees(right)) || made >= most_pieces;
      (is_done ? pieces_ : halves).insert((is_done ? pieces_ : halves).end(), {left, right});
      made += 2;
    }
    pending = std::move(halves);
  }
  std::ranges::sort(pieces_, {}, &Piece::lower);
}

double ComplianceTable::operator()(Direction psi) const {
  const double angle = angle_of(psi);
  const auto after = std::ranges::upper_bound(pieces_, angle, {}, &Piece::lower);
  return std::prev(std::max(after, std::next(pieces_.begin())))->at(angle);
}

}  // namespace nipref::fast::internal
