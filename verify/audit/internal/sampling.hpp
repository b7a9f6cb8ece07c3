#pragma once
#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/catalogue/ranges.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/random.hpp>

namespace nipref::verify {

// The points of an audit. Positions range over +-[1e-300, 700]. Only a few per cent of them are beyond 50, where ref is
// slow, and half of them are in [1e-3, 50], where all regimes of fast begin or end. An argument with a range is drawn
// evenly over the range, in the range's own spacing; an argument without a range is drawn from its whole domain.

/// The items number index, index + of, index + 2 of, ... of a list.
struct Part {
  std::size_t index = 0, of = 1;

  /// The number of items of this part in a list of `count`.
  [[nodiscard]] std::size_t size(std::size_t count) const {
    return index < count ? (count - index - 1) / of + 1 : 0;
  }
  [[nodiscard]] std::vector<Point> taken(const std::vector<Point>& points) const;
};

/// A random value of an argument. Positions are log-uniform: half of them over the whole domain, half over its middle.
double draw(ArgumentKind kind, Random& random);

/// One random point. A second position is related to the first in a part of the draws: equal, opposite,
/// close, 0, of another order of magnitude.
Point draw_point(const Quantity& quantity, const Ranges& ranges, Random& random);
/// Moves the point to where the quantity is finite and has a reference, unless this place is outside the ranges.
Point kept_off(const Quantity& quantity, const Ranges& ranges, Point point);

/// At most `limit` of the points, taken evenly.
std::vector<Point> thinned(std::vector<Point> points, std::size_t limit);

/// Points at each hard value of each argument and at each end of its range; the other arguments are random. Of two
/// positions there are also points at which both have the same hard value.
std::vector<Point> hard_points(const Quantity& quantity, const Ranges& ranges, Random& random);

/// Points with a position at a multiple of 1/4 up to +-50, where codes that interpolate have knots; the rest is random.
std::vector<Point> round_points(const Quantity& quantity, const Ranges& ranges, Random& random);

/// A part of `count` points whose first argument is spread evenly over the logarithm of its whole domain, one in each
/// of `count` cells. Each argument with a range is spread over its range in the same way.
std::vector<Point> dense_points(const Quantity& quantity, const Ranges& ranges, std::size_t count,
                                Random& random, Part part = {});

/// `count` random points.
std::vector<Point> random_points(const Quantity& quantity, const Ranges& ranges, std::size_t count,
                                 Random& random);

/// A point near `point` for the local search: one argument moved by a few neighbours or by a small relative
/// step, but not out of its range.
Point perturbed(const Quantity& quantity, const Ranges& ranges, const Point& point, Random& random);

/// Points at and beside the sign changes of fast's value along its position arguments, found on a grid over
/// [1e-3, 700] that is finer than the kernels' half period (2.8) and bisected down to adjacent doubles; other
/// arguments are random, all in their ranges. At most `limit` points, thinned evenly.
std::vector<Point> zero_points(const Quantity& quantity, const Ranges& ranges, std::size_t limit,
                               Random& random);

}  // namespace nipref::verify
