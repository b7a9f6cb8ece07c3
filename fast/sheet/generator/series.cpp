#include <nipref/fast/sheet/generator/series.hpp>

namespace nipref::fast::generator {

Real value(const Series& p, const Real& x) {
  Real sum = 0;
  for (auto c = p.rbegin(); c != p.rend(); ++c) sum = sum * x + *c;
  return sum;
}

/// Uses Newton's divided differences.
Series interpolated(const std::function<Real(const Real&)>& f, const Real& low, const Real& high,
                    int degree) {
  const auto count = static_cast<std::size_t>(degree) + 1;
  std::vector<Real> nodes, difference;
  for (std::size_t j = 0; j < count; ++j) {
    const Real angle = pi() * (2 * j + 1) / (2 * count);
    nodes.push_back((low + high) / 2 + (high - low) / 2 * cos(angle));
    difference.push_back(f(nodes.back()));
  }
  for (std::size_t order = 1; order < count; ++order) {
    for (std::size_t j = count - 1; j >= order; --j)
      difference[j] = (difference[j] - difference[j - 1]) / (nodes[j] - nodes[j - order]);
  }
  Series powers{difference.back()};
  for (std::size_t j = count - 1; j-- > 0;) {  // powers = powers * (x - node_j) + difference_j
    powers.insert(powers.begin(), Real(0));
    for (std::size_t k = 0; k + 1 < powers.size(); ++k) powers[k] -= nodes[j] * powers[k + 1];
    powers.front() += difference[j];
  }
  return powers;
}

}  // namespace nipref::fast::generator
