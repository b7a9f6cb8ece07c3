#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/sliding.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/verify/bench/internal/half_space.hpp>
#include <nipref/verify/bench/internal/timed_row.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/deviation.hpp>
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {
namespace {

using fast::Direction;

constexpr auto half_space = "half-space";
constexpr std::size_t directions = 1000;
constexpr double theta_deg = 45, speed = 0.3;

/// The seed's graphite epoxy, as the catalogue has it.
Point line_point(double axis, double psi_deg) {
  return point_of(find_quantity("ti.compliance"),
                  {{"theta_deg", theta_deg}, {"psi_deg", psi_deg}, {"speed", speed}, {"axis", axis}});
}

std::vector<double> angles() {
  std::vector<double> all;
  for (std::size_t i = 0; i < directions; ++i)
    all.push_back(-90 + 180 * (static_cast<double>(i) + 0.5) / directions);
  return all;
}

struct HalfSpaceMethod {
  std::string name;
  std::function<void(std::size_t count)> run;  ///< so many values
  std::optional<double> error = {};            ///< relative, if there is something to compare with
};

void append_rows(BenchReport& report, const std::string& arguments,
                 const std::vector<HalfSpaceMethod>& methods) {
  std::vector<Contender> contenders;
  for (const HalfSpaceMethod& method : methods) contenders.push_back({method.run, 1, 100'000'000});
  const auto timings = time_interleaved(contenders);
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const std::optional<double> error = methods[i].error;
    report.rows.push_back(timed_row(half_space, arguments, methods[i].name, timings[i], timings[0]));
    report.rows.back().max_error_ulp = error ? std::optional(*error / 0x1p-52) : std::nullopt;
    report.rows.back().max_relative_error = error;
  }
}

/// Largest relative error of fast's K at a few of the angles.
double error_of(const Quantity& quantity, const std::function<Point(double psi_deg)>& point) {
  double largest = 0;
  for (const double psi : {-80.0, -30.0, 0.0, 20.0, 45.0, 70.0}) {
    const Point at = point(psi);
    const auto truth = ref_value(quantity, at, 20);
    largest = std::max(largest, std::fabs(truth.error_of(quantity.by_fast(at, {})) / truth.to_double()));
  }
  return largest;
}

/// ns of one K, which the row before the reference's has.
double bench_line(BenchReport& report, const std::string& what, const fast::SurfaceResponse& response,
                  const Quantity& quantity, const std::function<Point(double psi_deg)>& point) {
  std::vector<Direction> lines;
  for (const double angle : angles()) lines.push_back(Direction::of_degrees(angle));
  double sink = 0;
  const HalfSpaceMethod fast_K{"fast K " + what,
                               [&](std::size_t count) {
                                 for (std::size_t i = 0; i < count; ++i)
                                   sink += response(lines[i % directions]).compliance;
                               },
                               error_of(quantity, point)};
  const HalfSpaceMethod ref_K{
      "ref K " + what + ", 20 digits", [&](std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
          static_cast<void>(ref_value(quantity, point(static_cast<double>(i % 90)), 20));
      }};
  append_rows(report, "1000 directions", {fast_K, ref_K});
  return report.rows[report.rows.size() - 2].nanoseconds;
}

/// ns of a contour of 1000 directions with its force.
double bench_contour(BenchReport& report, const fast::SurfaceResponse& in_plane) {
  std::vector<Direction> lines;
  for (const double angle : angles()) lines.push_back(Direction::of_degrees(angle));
  double sink = 0;
  const Direction motion = Direction::of_degrees(theta_deg);
  append_rows(report, "axis in plane",
              {{"fast sliding contact: force and contour of 1000 directions",
                [&](std::size_t count) {
                  for (std::size_t i = 0; i < count; ++i) {
                    const auto contact = fast::sliding_for_force(in_plane, {1, 1}, 0, motion, 1);
                    for (const Direction psi : lines) sink += contact.along(psi).leading_end().value;
                  }
                }},
               {"fast exact ellipse", [&](std::size_t count) {
                  for (std::size_t i = 0; i < count; ++i)
                    sink += fast::EllipticContact(in_plane, {1, 1}).for_force(1).semi_major.value;
                }}});
  return report.rows[report.rows.size() - 2].nanoseconds;
}

}  // namespace

BenchReport bench_half_space(const BenchProgress& progress) {
  BenchReport report;
  progress("lines");
  const Quantity& transverse = find_quantity("ti.compliance");
  const Point normal = line_point(0, 0), in_plane = line_point(1, 0);
  const auto normal_surface = transverse_surface_of({transverse.arguments, normal});
  const auto in_plane_surface = transverse_surface_of({transverse.arguments, in_plane});
  const fast::SurfaceResponse in_plane_response = [&](Direction psi) { return in_plane_surface.along(psi); };
  bench_line(report, "isotropic", isotropic_surface(0.3, 0.5), find_quantity("halfspace.compliance"),
             [](double psi) {
               return Point{0.3, 0.5, psi};
             });
  bench_line(
      report, "axis normal", [&](Direction psi) { return normal_surface.along(psi); }, transverse,
      [](double psi) { return line_point(0, psi); });
  const double one_K = bench_line(report, "axis in plane", in_plane_response, transverse,
                                  [](double psi) { return line_point(1, psi); });
  progress("contacts");
  const double contour = bench_contour(report, in_plane_response);
  report.ratios.push_back({"200 ns over fast K with the axis in the plane", 200 / one_K, 1});
  report.ratios.push_back({"1 ms over a sliding contact's force and 1000 directions", 1e6 / contour, 1});
  return report;
}

}  // namespace nipref::verify
