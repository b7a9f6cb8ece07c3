#pragma once
#include <cmath>

namespace nipref::fast {

/// A number and the size of what may cancel in it.
struct Sized {
  double value = 0, size = 0;

  void add(double part) {
    value += part;
    size += std::fabs(part);
  }
  friend Sized operator+(const Sized& a, const Sized& b) { return {a.value + b.value, a.size + b.size}; }
  friend Sized operator*(double factor, const Sized& a) {
    return {factor * a.value, std::fabs(factor) * a.size};
  }
};

}  // namespace nipref::fast
