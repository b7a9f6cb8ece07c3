#include <nipref/fast/sheet/generator/series.hpp>

namespace nipref::fast::generator {

Real value(const Series& p, const Real& x) {
  Real sum = 0;
  for (auto c = p.rbegin(); c != p.rend(); ++c) sum = sum * x + *c;
  return sum;
}

Series shifted(const Series& p, const Real& shift, int length) {
  Series result;
  Series rest = p;
  // Repeated synthetic division by (y - shift): the remainders are the coefficients about shift.
  for (int k = 0; k < length; ++k) {
    for (std::size_t i = rest.size() - 1; i > 0; --i) rest[i - 1] += shift * rest[i];
    result.push_back(rest.front());
    rest.erase(rest.begin());
  }
  return result;
}

Series divided_by_argument(const Series& p, const Real& centre) {
  Series quotient;
  Real previous = 0;
  for (const Real& c : p) {
    previous = (c - previous) / centre;
    quotient.push_back(previous);
  }
  return quotient;
}

Series logarithm(const Real& centre, int length) {
  Series result{log(centre)};
  Real power = -1;
  for (int k = 1; k < length; ++k) {
    power /= -centre;
    result.push_back(power / k);
  }
  return result;
}

namespace {

std::vector<Real> chebyshev_nodes(const Real& low, const Real& high, int count) {
  std::vector<Real> nodes;
  for (int j = 0; j < count; ++j) {
    const Real angle = pi() * (2 * j + 1) / (2 * count);
    nodes.push_back((low + high) / 2 + (high - low) / 2 * cos(angle));
  }
  return nodes;
}

/// Newton's divided differences, in place of the values.
void divide_differences(const std::vector<Real>& nodes, std::vector<Real>& values) {
  for (std::size_t order = 1; order < nodes.size(); ++order) {
    for (std::size_t j = nodes.size() - 1; j >= order; --j) {
      values[j] = (values[j] - values[j - 1]) / (nodes[j] - nodes[j - order]);
    }
  }
}

}  // namespace

Series economised(const Series& p, const Real& low, const Real& high, int degree) {
  const std::vector<Real> nodes = chebyshev_nodes(low, high, degree + 1);
  std::vector<Real> difference;
  for (const Real& node : nodes) difference.push_back(value(p, node));
  divide_differences(nodes, difference);
  Series powers{difference.back()};
  for (int j = degree - 1; j >= 0; --j) {  // powers = powers * (x - node_j) + difference_j
    powers.insert(powers.begin(), Real(0));
    for (std::size_t k = 0; k + 1 < powers.size(); ++k)
      powers[k] -= nodes[static_cast<std::size_t>(j)] * powers[k + 1];
    powers.front() += difference[static_cast<std::size_t>(j)];
  }
  return powers;
}

}  // namespace nipref::fast::generator
