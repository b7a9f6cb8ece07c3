#pragma once
#include <functional>
#include <vector>

#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

// The places where a traction of a solved contact is largest or changes its sign. Places are dimensionless; their
// origin does not matter.

/// f'(x) by the polynomial through an even number of `points` within `reach` of x. It is exact for polynomials of a
/// lower degree; 16 points give double accuracy for functions that are analytic well beyond `reach`.
class LocalSlope {
 public:
  explicit LocalSlope(int points = 16);
  /// Of a function with numbers or vectors as values.
  template <class Function>
  [[nodiscard]] auto operator()(const Function& f, double x, double reach) const {
    auto sum = f(x);
    sum *= 0;
    for (const auto& [place, weight] : nodes_)
      sum += weight / reach * (f(x + reach * place) - f(x - reach * place));
    return sum;
  }

  /// The sum of the weights' magnitudes: what multiplies the rounding of f over the reach.
  [[nodiscard]] double condition() const;

 private:
  struct Node {
    double place, weight;
  };
  std::vector<Node> nodes_;  ///< ahead of x; those behind are their mirror images
};

/// A function of the place on the last solution, without and with an estimate of its error.
struct PlaceFunction {
  std::function<double(double)> value;
  std::function<Estimate(double)> estimate;
};

/// A zero for each change of sign between successive ones of the rising `places`. Places where f does not exceed its
/// error are left out, so that every zero is sure; several zeros between two places count as one.
std::vector<Estimate> places_of_sure_zeros(const PlaceFunction& f, const std::vector<double>& places);

struct LocalMaximum {
  double place, value;
  double before, after;  ///< the places between which it was found
};

/// The local maxima of f >= 0 on the rising `places`, each refined between its neighbours; there is at least one.
std::vector<LocalMaximum> local_maxima(const std::function<double(double)>& f,
                                       const std::vector<double>& places);
const LocalMaximum& largest_of(const std::vector<LocalMaximum>& maxima);

/// The place of the largest of these maxima: the zero of the function's `slope`. If another one may be larger, judged by the
/// function's `estimate` at both, the error reaches to that one too; it is at most `most`.
Estimate place_of_maximum(const std::vector<LocalMaximum>& maxima, const PlaceFunction& slope,
                          const std::function<Estimate(double)>& estimate, double most);

}  // namespace nipref::fast
