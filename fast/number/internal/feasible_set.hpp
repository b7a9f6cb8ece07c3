#pragma once
#include <limits>
#include <vector>

namespace nipref::fast {

/// constant + slope x.
struct Affine {
  double constant;
  double slope;
};

/// constant + linear x + square x^2.
struct Quadratic {
  double constant;
  double linear;
  double square;
};

inline Affine operator*(double factor, const Affine& a) { return {factor * a.constant, factor * a.slope}; }
inline Quadratic operator*(double factor, const Quadratic& a) {
  return {factor * a.constant, factor * a.linear, factor * a.square};
}
inline Quadratic operator*(const Affine& a, const Affine& b) {
  return {a.constant * b.constant, a.constant * b.slope + a.slope * b.constant, a.slope * b.slope};
}
inline Quadratic operator-(const Quadratic& a, const Quadratic& b) {
  return {a.constant - b.constant, a.linear - b.linear, a.square - b.square};
}

/// The real numbers that meet a list of conditions: disjoint closed intervals, rising; all numbers before
/// there is a condition.
class FeasibleSet {
 public:
  struct Part {
    double lower;
    double upper;
  };

  void require_not_negative(const Affine& function) {
    require_not_negative(Quadratic{function.constant, function.slope, 0});
  }
  void require_not_negative(const Quadratic& function);
  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }

 private:
  std::vector<Part> parts_{
      {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}};
};

}  // namespace nipref::fast
