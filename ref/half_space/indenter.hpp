#pragma once
#include <variant>

#include <nipref/data/problem/half_space.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// A smooth rigid body at the point where it touches the plane, known exactly: its curvatures along the motion
/// and across it, 1/length, > 0.
struct Indenter {
  Exact along, across;

  /// A body given by its radii of curvature, > 0.
  static Indenter of_radii(double radius_along, double radius_across) {
    return {Exact(mpq_class(1 / mpq_class(radius_along))), Exact(mpq_class(1 / mpq_class(radius_across)))};
  }
};

/// The load on a contact; its doubles are taken as exact numbers.
using HalfSpaceLoad = std::variant<data::GivenNormalForce, data::GivenSpan>;

}  // namespace nipref::ref
