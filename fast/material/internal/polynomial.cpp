#include <algorithm>
#include <numbers>
#include <utility>

#include <nipref/fast/material/internal/polynomial.hpp>

namespace nipref::fast::internal {
namespace {

using Points = std::vector<OctupleComplex>;

/// The roots of c + b p + a p^2, without the cancellation in -b + sqrt(b^2 - 4 a c).
Points quadratic_roots(const Octuple& c, const Octuple& b, const Octuple& a) {
  const Octuple square = b * b - 4 * a * c;
  if (square < 0) {
    const OctupleComplex root(-b / (2 * a), sqrt(Octuple(-square)) / (2 * a));
    return {root, conj(root)};
  }
  const Octuple q = -(b + (b < 0 ? -1 : 1) * sqrt(square)) / 2;
  if (q == 0) return {0, 0};
  return {q / a, c / q};
}

/// Finds all roots at once by the Ehrlich-Aberth method. It starts from points on a circle that encloses the roots
/// (Fujiwara's bound) and ends when the polynomial at each point is as small as its rounding error.
Points aberth_roots(const Polynomial& p) {
  const std::size_t degree = p.size() - 1;
  const auto order = static_cast<double>(degree);
  Octuple radius = 0;
  for (std::size_t k = 0; k < degree; ++k) {
    if (p[k] != 0)
      radius = std::max<Octuple>(
          radius, 2 * pow(Octuple(abs(p[k] / p[degree])), 1 / Octuple(order - static_cast<double>(k))));
  }
  Points roots;
  for (std::size_t k = 0; k < degree; ++k) {  // with 0.2 no two points are conjugates of each other
    const double angle = 2 * std::numbers::pi * (static_cast<double>(k) + 0.2) / order;
    roots.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  const Octuple rounding = ldexp(Octuple(1), -232);
  constexpr int most_rounds = 1000;
  bool moves = true;
  for (int round = 0; round < most_rounds && moves; ++round) {
    moves = false;
    for (OctupleComplex& root : roots) {
      OctupleComplex value, slope;
      Octuple parts = 0;
      const Octuple size = abs(root);
      for (auto c = p.data().rbegin(); c != p.data().rend(); ++c) {
        slope = slope * root + value;
        value = value * root + *c;
        parts = parts * size + abs(*c);
      }
      if (abs(value) <= rounding * parts) continue;
      OctupleComplex push;
      for (const OctupleComplex& other : roots) {
        const OctupleComplex apart = root - other;
        if (apart != 0) push += 1 / apart;
      }
      const OctupleComplex turned = slope - value * push;
      if (turned == 0) continue;
      const OctupleComplex step = value / turned;
      root -= step;
      moves = moves || abs(step) > rounding * abs(root);
    }
  }
  return roots;
}

}  // namespace

Polynomial sum(const Polynomial& a, const Polynomial& b) {
  const Octuple nothing = ldexp(Octuple(1), -200);
  std::vector<Octuple> c(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Octuple x = i < a.size() ? a[i] : Octuple(0), y = i < b.size() ? b[i] : Octuple(0);
    c[i] = abs(x + y) <= nothing * (abs(x) + abs(y)) ? Octuple(0) : x + y;
  }
  return c;
}

Polynomial product(const std::vector<Polynomial>& factors) {
  Polynomial all{1};
  for (const Polynomial& factor : factors) all *= factor;
  return all;
}

std::vector<OctupleComplex> roots_of(Polynomial p) {
  Points roots;
  for (; p.size() > 1 && p[0] == 0; p >>= 1) roots.emplace_back();
  Points others;
  if (p.size() == 2) others = {-p[0] / p[1]};
  if (p.size() == 3) others = quadratic_roots(p[0], p[1], p[2]);
  if (p.size() > 3) others = aberth_roots(p);
  roots.insert(roots.end(), others.begin(), others.end());
  return roots;
}

std::vector<OctupleComplex> paired_roots_of(const Polynomial& p) {
  constexpr double real_to = 1e-13;
  std::vector<OctupleComplex> result;
  for (const OctupleComplex& root : roots_of(p)) {
    if (abs(root.imag()) <= real_to * abs(root))
      result.emplace_back(root.real());
    else if (root.imag() > 0)
      result.insert(result.end(), {root, conj(root)});
  }
  return result;
}

}  // namespace nipref::fast::internal
