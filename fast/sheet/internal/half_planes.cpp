#include <cmath>
#include <numbers>

#include <nipref/fast/sheet/internal/half_planes.hpp>

namespace nipref::fast::internal {
namespace {

using data::SheetLoad;

constexpr double two_over_pi = 2 * std::numbers::inv_pi;

/// Below this depth differences of the two loads' terms would lose digits. Both loads are far enough away to use
/// formulas with powers of the distances instead.
constexpr double middle = 0.5;

/// x/distance^2, without the square, which may underflow near the load.
double over_square(double x, double distance) { return x / distance / distance; }

}  // namespace

SeenFromLoads::SeenFromLoads(double along, double across)
    : alpha(along),
      depth(across),
      near_face(1 - across),
      far_face(1 + across),
      near(std::hypot(along, near_face)),
      far(std::hypot(along, far_face)),
      near_share(over_square(near_face, near)),
      far_share(over_square(far_face, far)),
      shares_apart(across < middle
                       ? 2 * across * (near_face * far_face - along * along) / (near * near * far * far)
                       : near_share - far_share) {}

SheetStresses half_plane_stresses(const SeenFromLoads& at, SheetLoad load) {
  // Each half-plane's field is a radial stress along the ray from its load. These are the direction cosines of the rays.
  const double near_cosine = at.near_face / at.near, near_sine = at.alpha / at.near;
  const double far_cosine = at.far_face / at.far, far_sine = at.alpha / at.far;
  if (load == SheetLoad::normal) {
    return {
        -two_over_pi * (at.near_share * near_cosine * near_cosine + at.far_share * far_cosine * far_cosine),
        -two_over_pi * (at.near_share * near_sine * near_sine + at.far_share * far_sine * far_sine),
        two_over_pi * at.alpha * at.shares_apart * (at.near_share + at.far_share)};
  }
  const double near_ray = at.alpha / at.near / at.near, far_ray = at.alpha / at.far / at.far;
  SheetStresses result{
      -two_over_pi * (near_ray * near_cosine * near_cosine + far_ray * far_cosine * far_cosine),
      -two_over_pi * (near_ray * near_sine * near_sine + far_ray * far_sine * far_sine),
      two_over_pi * (near_ray * near_cosine * near_sine - far_ray * far_cosine * far_sine)};
  if (at.depth < middle) {
    const double near_squared = at.near * at.near, far_squared = at.far * at.far;
    const double apart = 4 * at.near_face * (near_squared + 2 * at.depth) - near_squared * near_squared;
    const double carried = at.alpha / (near_squared * far_squared);
    result.shear = two_over_pi * carried * carried * 2 * at.depth * apart;
  }
  return result;
}

HalfPlaneParts half_plane_u(const SeenFromLoads& at, SheetLoad load) {
  if (load == SheetLoad::normal) {
    const double sine = at.alpha / at.near / at.far;
    const double logarithm = at.depth < middle ? std::log1p(4 * over_square(at.depth, at.near)) / 2
                                               : std::log(at.far) - std::log(at.near);
    return {logarithm, -4 * at.depth * sine * sine};
  }
  const double angle = std::atan2(2 * at.depth * at.alpha, at.near_face * at.far_face + at.alpha * at.alpha);
  return {angle, -at.alpha * at.shares_apart};
}

HalfPlaneParts half_plane_v(const SeenFromLoads& at, SheetLoad load) {
  if (load == SheetLoad::normal) {
    return {std::atan2(at.alpha, at.near_face) + std::atan2(at.alpha, at.far_face),
            at.alpha * (at.near_share + at.far_share)};
  }
  return {std::log(at.near) + std::log(at.far), at.near_face * at.near_share + at.far_face * at.far_share};
}

}  // namespace nipref::fast::internal
