#pragma once
#include <cmath>

namespace nipref::fast::internal {

/// A number, and the size of the terms that it is the sum of, which may cancel.
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
