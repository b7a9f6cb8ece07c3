// Tables 1 and 2 of brock2012: rigid bodies on an isotropic half-space.
#include <fmt/format.h>

#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/rolling_sphere.hpp>
#include <nipref/fast/half_space/sliding.hpp>
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>
#include <nipref/verify/catalogue/half_space/internal/printed.hpp>
#include <nipref/verify/replay/internal/half_space.hpp>

namespace nipref::verify {
namespace {

constexpr fast::Direction forwards{1, 0}, sideways{0, 1};

/// The span across the motion over the span along it, of the exact frictionless contact of a sphere.
double exact_span_ratio(const fast::SurfaceResponse& surface) {
  const fast::EllipticContact contact(surface, {1, 1});
  return contact.radius_ratio(sideways).value / contact.radius_ratio(forwards).value;
}

}  // namespace

std::vector<HalfSpaceCell> sliding_die_cells(const data::Table& table) {
  const double poisson = table.parameter("poisson").value;
  std::vector<HalfSpaceCell> cells;
  for_each_value(table, [&](std::size_t row, const data::TableColumn& column) {
    const double friction = table.cell(row, "gamma").number->value, speed = *column.coordinate;
    const fast::SurfaceResponse surface = isotropic_surface(poisson, speed);
    const double corrected =
        fast::sliding_for_span(surface, {1, 1}, friction, forwards, 1).span_ratio(sideways).value;
    const double exact_roots = die_span_ratio_as_tabulated(poisson, friction, speed, std::nullopt);
    const double rounded_roots = die_span_ratio_as_tabulated(poisson, friction, speed, table_root_decimals);
    const std::string error = fmt::format(
        "(35) with friction where there is none (sqrt(c_D^4 + gamma^2)) and none where there is "
        "(Delta_1, Q_1); as printed it gives {:.5f}",
        die_span_ratio_as_printed(poisson, friction, speed));
    cells.push_back({row,
                     column.name,
                     corrected,
                     {{data::Interval::only(exact_roots), Verdict::match, "reproduced so"},
                      {data::Interval::only(rounded_roots), Verdict::match,
                       "reproduced so with w_S and w_D to five decimals"}},
                     error,
                     "",
                     exact_span_ratio(surface)});
  });
  return cells;
}

std::vector<HalfSpaceCell> rolling_sphere_cells(const data::Table& table) {
  const double poisson = table.parameter("poisson").value;
  std::vector<HalfSpaceCell> cells;
  for (const data::TableColumn& column : table.columns) {
    const double speed = *column.coordinate;
    const double corrected =
        fast::rolling_sphere_for_span(unit_isotropic(poisson), 1, speed, 1e-3).span_ratio(sideways).value;
    const double rounded_roots = rolling_span_ratio_as_tabulated(poisson, speed, table_root_decimals);
    const std::string loss = fmt::format(
        "lost digits: (53b), without the c_D under its root with which it gives {:.5f}, is {:.5f}, "
        "but {:.5f} with w_S and w_D to five decimals",
        rolling_span_ratio_as_printed(poisson, speed), corrected, rounded_roots);
    cells.push_back({0,
                     column.name,
                     corrected,
                     {{data::Interval::only(corrected), Verdict::match, "to the digits printed"},
                      {data::Interval::only(rounded_roots), Verdict::match, loss}},
                     ""});
  }
  return cells;
}

}  // namespace nipref::verify
