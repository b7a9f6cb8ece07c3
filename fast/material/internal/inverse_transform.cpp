#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/material/internal/inverse_transform.hpp>

namespace nipref::fast::internal {
namespace {

using Points = std::vector<OctupleComplex>;

/// Divided difference of e^x over points that are within 1 of each other: e^mean times the series in what they are
/// beside it, whose coefficients are their complete symmetric polynomials.
OctupleComplex near_difference(const Points& x) {
  OctupleComplex mean;
  for (const OctupleComplex& point : x) mean += point;
  mean /= x.size();
  constexpr int most_terms = 70;
  std::vector<OctupleComplex> symmetric(most_terms);
  symmetric[0] = 1;
  for (const OctupleComplex& point : x) {
    for (std::size_t m = 1; m < symmetric.size(); ++m) symmetric[m] += (point - mean) * symmetric[m - 1];
  }
  Octuple over = 1;
  for (std::size_t k = 2; k < x.size(); ++k) over /= Octuple(k);
  OctupleComplex sum;
  for (std::size_t m = 0; m < symmetric.size(); ++m) {
    if (m > 0) over /= Octuple(m + x.size() - 1);
    sum += over * symmetric[m];
  }
  return exp(mean) * sum;
}

/// Divided differences of e^x over some of the points, by the two that are farthest from each other, unless all are near
/// each other; each is computed once, as the ways to many points lead through the same few.
class ExponentialDifferences {
 public:
  using Numbers = std::vector<std::size_t>;

  explicit ExponentialDifferences(Points x) : x_(std::move(x)) {}

  /// Over the points of these numbers.
  const OctupleComplex& over(const Numbers& some) {
    const auto found = found_.find(some);
    return found != found_.end() ? found->second : found_.emplace(some, computed(some)).first->second;
  }

 private:
  OctupleComplex computed(const Numbers& some) {
    std::size_t first = 0, second = 0;
    Octuple farthest = 0;
    for (std::size_t i = 0; i < some.size(); ++i) {
      for (std::size_t j = i + 1; j < some.size(); ++j) {
        const Octuple square = norm(x_[some[i]] - x_[some[j]]);
        if (square > farthest) {
          farthest = square;
          first = i;
          second = j;
        }
      }
    }
    if (farthest <= 1) {
      Points near;
      for (const std::size_t i : some) near.push_back(x_[i]);
      return near_difference(near);
    }
    const auto without = [&](std::size_t i) {
      Numbers others = some;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      return over(others);
    };
    return (without(second) - without(first)) / (x_[some[first]] - x_[some[second]]);
  }

  Points x_;
  std::map<Numbers, OctupleComplex> found_;
};

/// BadInput where five roots of a factor are within 1e-9 of each other: they are found to a fifth of the digits.
void check_apart(const Points& roots) {
  for (const OctupleComplex& root : roots) {
    const auto near = std::ranges::count_if(
        roots, [&](const OctupleComplex& other) { return abs(other - root) <= 1e-9 * abs(root); });
    if (near >= 5)
      throw data::BadInput("material", "(its rates)", "must not have five rates within 1e-9 of each other");
  }
}

}  // namespace

Sized<Octuple> inverse_transform(const Rational& transform, double t) {
  Points roots;
  for (const Polynomial& factor : transform.denominator) {
    const Points more = roots_of(factor);
    check_apart(more);
    roots.insert(roots.end(), more.begin(), more.end());
  }
  const Polynomial denominator = product(transform.denominator);
  const Polynomial proper = product(transform.numerator) % denominator;
  // Divided differences of a product, from the first root to the last: of the polynomial from the first to the k-th by
  // synthetic division, of the exponential from the k-th on.
  Points rest, faded = roots;
  for (const Octuple& c : proper.data()) rest.emplace_back(c / denominator.data().back());
  for (OctupleComplex& root : faded) root *= t;
  Octuple slowest = roots.empty() ? Octuple(0) : faded.front().real(), value = 0, size = 0;
  for (const OctupleComplex& root : faded) slowest = std::max<Octuple>(slowest, root.real());
  ExponentialDifferences differences(std::move(faded));
  ExponentialDifferences::Numbers left(roots.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  for (std::size_t k = 0; k < roots.size() && !rest.empty(); ++k) {
    for (std::size_t i = rest.size() - 1; i-- > 0;) rest[i] += roots[k] * rest[i + 1];
    Octuple scale = 1, over = 1;
    for (std::size_t n = 1; n < left.size(); ++n) {
      scale *= t;
      over *= static_cast<double>(n);
    }
    value += scale * OctupleComplex(rest.front() * differences.over(left)).real();
    size += scale / over * abs(rest.front()) * exp(slowest);
    rest.erase(rest.begin());
    left.erase(left.begin());
  }
  return {value, size};
}

}  // namespace nipref::fast::internal
