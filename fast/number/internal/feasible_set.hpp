#pragma once
#include <limits>
#include <vector>

namespace nipref::fast {

/// constant + linear x + square x^2.
struct Quadratic {
  double constant;
  double linear;
  double square = 0;
};

inline Quadratic operator*(double factor, const Quadratic& a) {
  return {factor * a.constant, factor * a.linear, factor * a.square};
}
/// The product of two functions without a square term.
inline Quadratic operator*(const Quadratic& a, const Quadratic& b) {
  return {a.constant * b.constant, a.constant * b.linear + a.linear * b.constant, a.linear * b.linear};
}
inline Quadratic operator-(const Quadratic& a, const Quadratic& b) {
  return {a.constant - b.constant, a.linear - b.linear, a.square - b.square};
}

/// The set of real numbers that meet all conditions required so far, as disjoint closed intervals in ascending order.
/// Before the first condition it is the whole real line.
class FeasibleSet {
 public:
  struct Part {
    double lower;
    double upper;
  };

  void require_not_negative(const Quadratic& function);
  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }

 private:
  std::vector<Part> parts_{
      {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}};
};

}  // namespace nipref::fast
