#pragma once
#include <functional>
#include <vector>

namespace nipref::fast {

/// The search for the places of the greatest shear inside the sheet of a contact. Lengths are in half-thicknesses. In a
/// symmetric contact only y >= 0 is searched.
class ShearSearch {
 public:
  /// y from the contact's middle, 0 <= depth <= 1 from the middle plane.
  struct Point {
    double y, depth;
  };
  /// The shear at a point by quadrature to a relative tolerance.
  using Shear = std::function<double(const Point& point, double tolerance)>;

  ShearSearch(double half_length, bool is_symmetric, Shear shear);

  /// The maxima found: each maximum on a grid, followed by ever smaller steps. The grid is as deep as 2.5 half-lengths
  /// and denser at the ends, beside which full friction may cause the largest shear.
  [[nodiscard]] std::vector<Point> maxima() const;
  /// The distances in both directions from a maximum within which the shear falls by no more than `slack`. Beside the
  /// maximum it is taken for a paraboloid.
  [[nodiscard]] Point flat_part(const Point& maximum, double slack) const;

 private:
  [[nodiscard]] std::vector<Point> maxima_on_grid() const;
  [[nodiscard]] Point climb(Point best) const;
  /// The scale on which the shear changes about a point: its distance from the contact's end, or what is smaller.
  [[nodiscard]] double scale(const Point& point) const;
  /// The smallest step of a search that ends at a point.
  [[nodiscard]] double last_step(const Point& point) const;

  double half_length_, reach_;
  bool is_symmetric_;
  Shear shear_;
};

}  // namespace nipref::fast
