#pragma once
#include <cmath>

namespace nipref::fast::internal {

/// A sum, and the sum of its terms' magnitudes, which is larger where terms cancel.
template <class Number>
struct Sized {
  Number value = 0, size = 0;

  void add(const Number& term) {
    using std::abs;
    value += term;
    size += abs(term);
  }
  friend Sized operator+(const Sized& a, const Sized& b) { return {a.value + b.value, a.size + b.size}; }
  friend Sized operator*(const Number& factor, const Sized& a) {
    using std::abs;
    return {factor * a.value, abs(factor) * a.size};
  }
};

}  // namespace nipref::fast::internal
