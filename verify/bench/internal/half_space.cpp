#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/sliding.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/verify/bench/internal/groups.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>

namespace nipref::verify {
namespace {

using fast::Direction;
using PointOfAngle = std::function<Point(double psi_deg)>;

constexpr auto half_space = "half-space";
constexpr std::size_t direction_count = 1000, most_evaluations = 100'000'000;
constexpr double theta_deg = 45, sliding_speed = 0.3;

/// The arguments for one line of the seed's graphite epoxy, as the catalogue has it.
Point line_point(double axis, double psi_deg) {
  return point_of(find_quantity("ti.compliance"),
                  {{"theta_deg", theta_deg}, {"psi_deg", psi_deg}, {"speed", sliding_speed}, {"axis", axis}});
}

/// The response of the epoxy's surface; the symmetry axis is normal (0) or in the plane (1).
fast::SurfaceResponse epoxy_surface(double axis) {
  const auto surface = std::make_shared<const fast::TransverselyIsotropicHalfSpace>(
      transverse_surface_of({find_quantity("ti.compliance").arguments, line_point(axis, 0)}));
  return [surface](Direction psi) { return surface->along(psi); };
}

std::vector<Direction> directions() {
  return mapped(std::views::iota(std::size_t{0}, direction_count), [](std::size_t i) {
    return Direction::of_degrees(-90 + 180 * (static_cast<double>(i) + 0.5) / direction_count);
  });
}

/// Times the compliance K of one line.
std::vector<BenchRow> lines(const std::string& what, const fast::SurfaceResponse& response,
                            const Quantity& quantity, const PointOfAngle& point) {
  const auto by_fast = [&, all = directions()](std::size_t i) {
    return response(all[i % direction_count]).compliance;
  };
  const auto by_ref = [&](double psi) { return ref_value(quantity, point(psi), 20); };
  const auto error = [&] {
    double largest = 0;
    for (const double psi : {-80.0, -30.0, 0.0, 20.0, 45.0, 70.0}) {
      const auto truth = by_ref(psi);
      largest =
          std::max(largest, std::fabs(truth.error_of(quantity.by_fast(point(psi), {})) / truth.to_double()));
    }
    return of_relative(largest);
  };
  return timed_rows(
      half_space, "1000 directions",
      {{"fast K " + what, repeated(by_fast, most_evaluations), error},
       {"ref K " + what + ", 20 digits",
        repeated([&](std::size_t i) { return by_ref(static_cast<double>(i % 90)); }, most_evaluations)}});
}

std::vector<BenchRow> contacts() {
  const fast::SurfaceResponse in_plane = epoxy_surface(1);
  const auto contour = [&, all = directions()](std::size_t) {
    const auto contact = fast::sliding_for_force(in_plane, {1, 1}, 0, Direction::of_degrees(theta_deg), 1);
    double sum = 0;
    for (const Direction psi : all) sum += contact.along(psi).leading_end().value;
    return sum;
  };
  const auto ellipse = [&](std::size_t) {
    return fast::EllipticContact(in_plane, {1, 1}).for_force(1).semi_major.value;
  };
  return timed_rows(
      half_space, "axis in plane",
      {{"fast sliding contact: force and contour of 1000 directions", repeated(contour, most_evaluations)},
       {"fast exact ellipse", repeated(ellipse, most_evaluations)}});
}

}  // namespace

std::vector<BenchPart> half_space_bench() {
  const auto isotropic = [] {
    return lines("isotropic", isotropic_surface(0.3, 0.5), find_quantity("halfspace.compliance"),
                 [](double psi) {
                   return Point{0.3, 0.5, psi};
                 });
  };
  const auto transverse = [](const char* what, double axis) {
    return BenchPart{std::string("lines, ") + what, [=] {
                       return lines(what, epoxy_surface(axis), find_quantity("ti.compliance"),
                                    [=](double psi) { return line_point(axis, psi); });
                     }};
  };
  return {{"lines, isotropic", isotropic},
          transverse("axis normal", 0),
          transverse("axis in plane", 1),
          {"contacts", contacts}};
}

}  // namespace nipref::verify
