#pragma once
#include <functional>
#include <vector>

#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

// The places where a traction of a solved contact is largest or changes its sign. Places are dimensionless; their
// origin does not matter.

/// f'(x) by the polynomial through f at an even number of `points` within `reach` of x. It is exact for polynomials of
/// lower degree than `points`; 16 points give double accuracy for functions that are analytic well beyond `reach`.
class LocalSlope {
 public:
  explicit LocalSlope(int points = 16);
  /// The values of `f` are numbers or vectors.
  template <class Function>
  [[nodiscard]] auto operator()(const Function& f, double x, double reach) const {
    auto sum = f(x);
    sum *= 0;
    for (const auto& [place, weight] : nodes_)
      sum += weight / reach * (f(x + reach * place) - f(x - reach * place));
    return sum;
  }

  /// The sum of the weights' magnitudes: it multiplies the rounding error of f, divided by the reach.
  [[nodiscard]] double condition() const;

 private:
  struct Node {
    double place, weight;
  };
  std::vector<Node> nodes_;  ///< nodes ahead of x; the nodes behind x are their mirror images
};

/// A function of the place in the last solution: its value alone, and its value with an error estimate.
struct PlaceFunction {
  std::function<double(double)> value;
  std::function<Estimate(double)> estimate;
};

/// A zero for each change of sign between successive `places`, which rise. Places where |f| does not exceed its error
/// are left out, so that every zero is sure. Several zeros between two places count as one.
std::vector<Estimate> places_of_sure_zeros(const PlaceFunction& f, const std::vector<double>& places);

struct LocalMaximum {
  double place, value;
  double before, after;  ///< the places between which it was found
};

/// The local maxima of f >= 0 on the rising `places`; there is at least one. Each is refined between its neighbours, to
/// 2^-29 of their distance: there f differs from its maximum by about 2^-58 of its change between them.
std::vector<LocalMaximum> local_maxima(const std::function<double(double)>& f,
                                       const std::vector<double>& places);
const LocalMaximum& largest_of(const std::vector<LocalMaximum>& maxima);

/// The place of the largest of these maxima, the zero of the function's `slope`, with an error of at most `most`. If
/// another maximum may be larger, judged by the function's `estimate` at both, the error covers its place, too.
Estimate place_of_maximum(const std::vector<LocalMaximum>& maxima, const PlaceFunction& slope,
                          const std::function<Estimate(double)>& estimate, double most);

}  // namespace nipref::fast
