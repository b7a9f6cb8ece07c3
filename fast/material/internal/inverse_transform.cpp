#include <algorithm>
#include <cmath>

#include <nipref/fast/material/internal/inverse_transform.hpp>

namespace nipref::fast::internal {
namespace {

using Points = std::vector<OctupleComplex>;

OctupleComplex octuple_exp(const OctupleComplex& a) {
  const Octuple size = exp(a.re);
  return a.im == 0 ? OctupleComplex{size, 0} : OctupleComplex{size * cos(a.im), size * sin(a.im)};
}

/// Divided difference of e^x over points that are within 1 of each other: e^mean times the series in what they are
/// beside it, whose coefficients are their complete symmetric polynomials.
OctupleComplex near_difference(const Points& x) {
  OctupleComplex mean;
  for (const OctupleComplex& point : x) mean = mean + point;
  mean = (1 / Octuple(x.size())) * mean;
  constexpr int most_terms = 70;
  std::vector<OctupleComplex> symmetric(most_terms);
  symmetric[0] = {1, 0};
  for (const OctupleComplex& point : x) {
    for (std::size_t m = 1; m < symmetric.size(); ++m)
      symmetric[m] = symmetric[m] + (point - mean) * symmetric[m - 1];
  }
  Octuple over = 1;
  for (std::size_t k = 2; k < x.size(); ++k) over /= Octuple(k);
  OctupleComplex sum;
  for (std::size_t m = 0; m < symmetric.size(); ++m) {
    if (m > 0) over /= Octuple(m + x.size() - 1);
    sum = sum + over * symmetric[m];
  }
  return octuple_exp(mean) * sum;
}

/// Divided difference of e^x, points in any order: by the two farthest, unless all are near each other.
OctupleComplex exponential_difference(const Points& x) {
  if (x.size() == 1) return octuple_exp(x.front());
  std::size_t first = 0, second = 1;
  Octuple farthest = -1;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = i + 1; j < x.size(); ++j) {
      const Octuple apart = size_of(x[i] - x[j]);
      if (apart > farthest) {
        farthest = apart;
        first = i;
        second = j;
      }
    }
  }
  if (farthest <= 1) return near_difference(x);
  const auto without = [&](std::size_t i) {
    Points others = x;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    return exponential_difference(others);
  };
  return (without(second) - without(first)) / (x[first] - x[second]);
}

/// What is left of a polynomial beside a multiple of another.
Polynomial remainder(Polynomial a, const Polynomial& by) {
  while (a.size() >= by.size()) {
    const Octuple factor = a.back() / by.back();
    for (std::size_t k = 0; k + 1 < by.size(); ++k) a[a.size() - by.size() + k] -= factor * by[k];
    a.pop_back();
  }
  return a;
}

}  // namespace

Sized<Octuple> inverse_transform(const Rational& transform, double t) {
  Points roots;
  Polynomial denominator{1};
  for (const Polynomial& factor : transform.denominator) {
    const Points more = roots_of(factor);
    roots.insert(roots.end(), more.begin(), more.end());
    denominator = product(denominator, factor);
  }
  const Polynomial proper = remainder(transform.numerator, denominator);
  // Divided differences of a product, from the first root to the last: of the polynomial from the first to the k-th by
  // synthetic division, of the exponential from the k-th on.
  Points rest, faded = roots;
  for (const Octuple& c : proper) rest.push_back({c / denominator.back(), 0});
  for (OctupleComplex& root : faded) root = Octuple(t) * root;
  Octuple slowest = roots.empty() ? Octuple(0) : faded.front().re, value = 0, size = 0;
  for (const OctupleComplex& root : faded) slowest = std::max(slowest, root.re);
  for (std::size_t k = 0; k < roots.size() && !rest.empty(); ++k) {
    for (std::size_t i = rest.size() - 1; i-- > 0;) rest[i] = rest[i] + roots[k] * rest[i + 1];
    Octuple scale = 1, over = 1;
    for (std::size_t n = 1; n < faded.size(); ++n) {
      scale *= t;
      over *= static_cast<double>(n);
    }
    const OctupleComplex term = scale * (rest.front() * exponential_difference(faded));
    value += term.re;
    size += scale / over * size_of(rest.front()) * exp(slowest);
    rest.erase(rest.begin());
    faded.erase(faded.begin());
  }
  return {value, size};
}

}  // namespace nipref::fast::internal
