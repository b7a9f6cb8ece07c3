#pragma once
#include <functional>
#include <vector>

#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

// Where a traction of a solved contact is largest or changes its sign. Places are dimensionless and of any origin.

/// f'(x) by the polynomial through `points` places, an even number, within `reach` around x: of polynomials of a lower
/// degree, and by 16 points of what is analytic well beyond `reach`.
class LocalSlope {
 public:
  explicit LocalSlope(int points = 16);
  [[nodiscard]] double operator()(const std::function<double(double)>& f, double x, double reach) const;

 private:
  struct Node {
    double place, weight;
  };
  std::vector<Node> nodes_;  ///< ahead of x; those behind are their mirror images
};

/// A number at a place of the last solution, and the same with an estimate of its error.
struct PlaceFunction {
  std::function<double(double)> value;
  std::function<Estimate(double)> estimate;
};

/// The zero of `f` between a < b, where it has different signs. What f may be off by at its zero moves it: the error is
/// how far from it f is larger than that, on both sides, `most` at the utmost.
Estimate place_of_zero(const PlaceFunction& f, double a, double b, double most);

/// A zero for every change of sign from one of `places` to the next, both rising, of those where f is larger than its
/// error: no change that is not sure, and one for several between two places.
std::vector<Estimate> places_of_sure_zeros(const PlaceFunction& f, const std::vector<double>& places);

/// Where f >= 0 has its largest value within `places`, rising, by the zero of `slope` of f next to the largest of them.
/// Where another maximum may be the larger one, as `difference` of two places tells, the error reaches to that as well:
/// then the place is not known.
Estimate place_of_maximum(const std::function<double(double)>& f, const PlaceFunction& slope,
                          const std::function<Estimate(double, double)>& difference,
                          const std::vector<double>& places);

}  // namespace nipref::fast
