#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/fast/material/internal/inverse_transform.hpp>

namespace nipref::fast::internal {
namespace {

struct WideComplex {
  Wide re = 0, im = 0;

  friend WideComplex operator+(const WideComplex& a, const WideComplex& b) {
    return {a.re + b.re, a.im + b.im};
  }
  friend WideComplex operator-(const WideComplex& a, const WideComplex& b) {
    return {a.re - b.re, a.im - b.im};
  }
  friend WideComplex operator*(const WideComplex& a, const WideComplex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend WideComplex operator*(const Wide& a, const WideComplex& b) { return {a * b.re, a * b.im}; }
  friend WideComplex operator/(const WideComplex& a, const WideComplex& b) {
    const Wide square = b.re * b.re + b.im * b.im;
    return {(a.re * b.re + a.im * b.im) / square, (a.im * b.re - a.re * b.im) / square};
  }
};
using Points = std::vector<WideComplex>;

Wide size_of(const WideComplex& a) { return sqrt(a.re * a.re + a.im * a.im); }

WideComplex wide_exp(const WideComplex& a) {
  const Wide size = exp(a.re);
  return a.im == 0 ? WideComplex{size, 0} : WideComplex{size * cos(a.im), size * sin(a.im)};
}

/// c + b p + a p^2, without the cancellation of -b + sqrt(b^2 - 4 a c).
Points quadratic_roots(const Wide& c, const Wide& b, const Wide& a) {
  const Wide square = b * b - 4 * a * c;
  if (square < 0) {
    const WideComplex root{-b / (2 * a), sqrt(Wide(-square)) / (2 * a)};
    return {root, {root.re, -root.im}};
  }
  const Wide q = -(b + (b < 0 ? -1 : 1) * sqrt(square)) / 2;
  if (q == 0) return {{}, {}};
  return {{q / a, 0}, {c / q, 0}};
}

/// All at once by the method of Ehrlich and Aberth, from points on a circle that holds them (Fujiwara), until
/// each makes the polynomial as small as its rounding.
Points aberth_roots(const Polynomial& p) {
  const std::size_t degree = p.size() - 1;
  const auto order = static_cast<double>(degree);
  Wide radius = 0;
  for (std::size_t k = 0; k < degree; ++k) {
    if (p[k] != 0)
      radius = std::max<Wide>(radius,
                              2 * pow(Wide(abs(p[k] / p.back())), 1 / Wide(order - static_cast<double>(k))));
  }
  Points roots;
  for (std::size_t k = 0; k < degree; ++k) {  // turned a little: no two start as each other's conjugates
    const double angle = 2 * std::numbers::pi * (static_cast<double>(k) + 0.2) / order;
    roots.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  const Wide rounding = ldexp(Wide(1), -232);
  constexpr int most_rounds = 1000;
  bool moves = true;
  for (int round = 0; round < most_rounds && moves; ++round) {
    moves = false;
    for (WideComplex& root : roots) {
      WideComplex value, slope;
      Wide parts = 0;
      const Wide size = size_of(root);
      for (auto c = p.rbegin(); c != p.rend(); ++c) {
        slope = slope * root + value;
        value = value * root + WideComplex{*c, 0};
        parts = parts * size + abs(*c);
      }
      if (size_of(value) <= rounding * parts) continue;
      WideComplex push;
      for (const WideComplex& other : roots) {
        const WideComplex apart = root - other;
        if (apart.re != 0 || apart.im != 0) push = push + WideComplex{1, 0} / apart;
      }
      const WideComplex turned = slope - value * push;
      if (turned.re == 0 && turned.im == 0) continue;
      const WideComplex step = value / turned;
      root = root - step;
      moves = moves || size_of(step) > rounding * size_of(root);
    }
  }
  return roots;
}

Points roots_of(Polynomial p) {
  Points roots;
  while (p.size() > 1 && p.front() == 0) {
    p.erase(p.begin());
    roots.emplace_back();
  }
  Points others;
  if (p.size() == 2) others = {{-p[0] / p[1], 0}};
  if (p.size() == 3) others = quadratic_roots(p[0], p[1], p[2]);
  if (p.size() > 3) others = aberth_roots(p);
  roots.insert(roots.end(), others.begin(), others.end());
  return roots;
}

/// Divided difference of e^x over points that are within 1 of each other: e^mean times the series in what they are
/// beside it, whose coefficients are their complete symmetric polynomials.
WideComplex near_difference(const Points& x) {
  WideComplex mean;
  for (const WideComplex& point : x) mean = mean + point;
  mean = (1 / Wide(x.size())) * mean;
  constexpr int most_terms = 70;
  std::vector<WideComplex> symmetric(most_terms);
  symmetric[0] = {1, 0};
  for (const WideComplex& point : x) {
    for (std::size_t m = 1; m < symmetric.size(); ++m)
      symmetric[m] = symmetric[m] + (point - mean) * symmetric[m - 1];
  }
  Wide over = 1;
  for (std::size_t k = 2; k < x.size(); ++k) over /= Wide(k);
  WideComplex sum;
  for (std::size_t m = 0; m < symmetric.size(); ++m) {
    if (m > 0) over /= Wide(m + x.size() - 1);
    sum = sum + over * symmetric[m];
  }
  return wide_exp(mean) * sum;
}

/// Divided difference of e^x, points in any order: by the two farthest, unless all are near each other.
WideComplex exponential_difference(const Points& x) {
  if (x.size() == 1) return wide_exp(x.front());
  std::size_t first = 0, second = 1;
  Wide farthest = -1;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = i + 1; j < x.size(); ++j) {
      const Wide apart = size_of(x[i] - x[j]);
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
    const Wide factor = a.back() / by.back();
    for (std::size_t k = 0; k + 1 < by.size(); ++k) a[a.size() - by.size() + k] -= factor * by[k];
    a.pop_back();
  }
  return a;
}

}  // namespace

Polynomial trimmed(Polynomial a) {
  while (!a.empty() && a.back() == 0) a.pop_back();
  return a;
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
  if (a.empty() || b.empty()) return {};
  Polynomial c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) c[i + k] += a[i] * b[k];
  }
  return c;
}

Polynomial sum(const Polynomial& a, const Polynomial& b) {
  const Wide nothing = ldexp(Wide(1), -200);
  Polynomial c(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Wide x = i < a.size() ? a[i] : Wide(0), y = i < b.size() ? b[i] : Wide(0);
    c[i] = x + y;
    if (abs(c[i]) <= nothing * (abs(x) + abs(y))) c[i] = 0;
  }
  return trimmed(std::move(c));
}

Polynomial times(const Wide& factor, Polynomial a) {
  for (Wide& c : a) c *= factor;
  return a;
}

Sized inverse_transform(const Rational& transform, double t) {
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
  for (const Wide& c : proper) rest.push_back({c / denominator.back(), 0});
  for (WideComplex& root : faded) root = Wide(t) * root;
  Wide slowest = roots.empty() ? Wide(0) : faded.front().re, value = 0, size = 0;
  for (const WideComplex& root : faded) slowest = std::max(slowest, root.re);
  for (std::size_t k = 0; k < roots.size() && !rest.empty(); ++k) {
    for (std::size_t i = rest.size() - 1; i-- > 0;) rest[i] = rest[i] + roots[k] * rest[i + 1];
    Wide scale = 1, over = 1;
    for (std::size_t n = 1; n < faded.size(); ++n) {
      scale *= t;
      over *= static_cast<double>(n);
    }
    const WideComplex term = scale * (rest.front() * exponential_difference(faded));
    value += term.re;
    size += scale / over * size_of(rest.front()) * exp(slowest);
    rest.erase(rest.begin());
    faded.erase(faded.begin());
  }
  return {value, size};
}

}  // namespace nipref::fast::internal
