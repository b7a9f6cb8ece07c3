#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/fast/half_space/internal/compliance_table.hpp>
#include <nipref/fast/number/internal/chebyshev.hpp>

namespace nipref::fast::internal {
namespace {

constexpr double pi = std::numbers::pi;

/// The angle, -pi/2 to pi/2, of the direction or of its opposite.
double angle_of(Direction psi) {
  return psi.cosine < 0 ? std::atan2(-psi.sine, -psi.cosine) : std::atan2(psi.sine, psi.cosine);
}

}  // namespace

double ComplianceTable::Piece::angle(std::size_t j) const {
  return lower + (upper - lower) * shifted_chebyshev_zero(static_cast<int>(j), points);
}

ComplianceTable::Piece::Piece(const Compliance& compliance, double from, double to) : lower(from), upper(to) {
  for (std::size_t j = 0; j < points; ++j) values[j] = compliance(Direction::of_angle(angle(j)));
}

/// Uses the barycentric formula of the second kind.
double ComplianceTable::Piece::at(double angle) const {
  static const auto nodes = [] {
    std::array<std::array<double, 2>, points> result;
    for (std::size_t j = 0; j < points; ++j) {
      const double x = shifted_chebyshev_zero(static_cast<int>(j), points);
      result[j] = {x, (j % 2 == 0 ? 1 : -1) * std::sqrt(x * (1 - x))};
    }
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

/// Whether this piece reproduces the values of a half of it to about 1e-10.
bool ComplianceTable::Piece::agrees(const Piece& half) const {
  for (std::size_t j = 0; j < points; ++j)
    if (!(std::fabs(at(half.angle(j)) - half.values[j]) <= 1e-10 * half.values[j])) return false;
  return true;
}

ComplianceTable::ComplianceTable(const Compliance& compliance) {
  constexpr std::size_t most_pieces = (1 << 13) / points;
  std::vector<Piece> pending{{compliance, -pi / 2, 0}, {compliance, 0, pi / 2}};
  for (std::size_t made = pending.size(); !pending.empty();) {
    std::vector<Piece> halves;
    for (const Piece& whole : pending) {
      const double middle = (whole.lower + whole.upper) / 2;
      const Piece left(compliance, whole.lower, middle), right(compliance, middle, whole.upper);
      const bool is_done = (whole.agrees(left) && whole.agrees(right)) || made >= most_pieces;
      std::vector<Piece>& into = is_done ? pieces_ : halves;
      into.insert(into.end(), {left, right});
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
