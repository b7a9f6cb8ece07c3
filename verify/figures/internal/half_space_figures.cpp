#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/rolling_sphere.hpp>
#include <nipref/fast/half_space/sliding.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>
#include <nipref/verify/figures/internal/groups.hpp>
#include <nipref/verify/figures/internal/series.hpp>
#include <nipref/verify/replay/internal/sphere_on_half_space.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

// What is behind the tables of the papers on half-spaces. Directions count from the motion.

namespace nipref::verify {
namespace {

using fast::Direction;

const std::string ellipse = "exact ellipse, no friction", rule = "the paper's rule, corrected",
                  paper_formula = "the table's formula";
constexpr Direction forward_motion{1, 0}, across_motion{0, 1};
constexpr double nearly_critical = 0.999;

/// Bodies at a speed, what one line answers to their pressure.
using SurfaceAtSpeed = std::function<fast::SurfaceResponse(double speed)>;

/// A table's column or row as points: `place` of a cell on the axis, if it belongs to the series.
using CellPlace = std::function<std::optional<double>(const ReplayedCell&)>;

void append_cells(Panel& panel, const std::string& label, const Replay& replay, const CellPlace& place) {
  Series made{label, paper_formula, Mark::points, {}, {}}, printed{label, as_printed, Mark::bars, {}, {}};
  for (const ReplayedCell& cell : replay.cells) {
    const std::optional<double> x = place(cell);
    if (!x) continue;
    made.x.push_back(*x);
    made.y.push_back(cell.value);
    const data::TableCell& print = replay.table.cell(cell.row, cell.column);
    if (!print.is_readable() || print.is_doubtful()) continue;
    printed.x.push_back(*x);
    printed.y.push_back(print.number->value);
    printed.low.push_back(print.number->rounding.lower);
    printed.high.push_back(print.number->rounding.upper);
  }
  panel.series.push_back(std::move(made));
  panel.series.push_back(std::move(printed));
}

double speed_of_column(const Replay& replay, const std::string& column) {
  return *replay.table.columns[replay.table.column_index(column)].coordinate;
}

Series contour(const std::string& label, const std::string& role, Mark mark,
               const std::function<double(Direction)>& radius) {
  Series series{label, role, mark, {}, {}};
  for (const double angle : evenly(0, 360, 181)) {
    const Direction line = Direction::of_degrees(angle);
    const double r = radius(line);
    series.x.push_back(r * line.cosine);
    series.y.push_back(r * line.sine);
  }
  return series;
}

Series exact_contour(const std::string& label, const fast::SurfaceResponse& surface) {
  const fast::EllipticContact contact(surface, {1, 1});
  const double forwards = contact.radius_ratio(forward_motion).value;
  return contour(label, ellipse, Mark::line,
                 [&](Direction line) { return contact.radius_ratio(line).value / forwards / 2; });
}

Panel contour_panel() {
  return {{"along the motion, over the contact's span there"}, {"across the motion"}, {}, true};
}

Panel contours(const SurfaceAtSpeed& surface, const std::vector<double>& speeds,
               const std::vector<double>& frictions) {
  Panel panel = contour_panel();
  for (const double speed : speeds) {
    const std::string label = fmt::format("c = {:g}", speed);
    panel.series.push_back(exact_contour(label, surface(speed)));
    for (const double friction : frictions) {
      const auto sliding = fast::sliding_for_span(surface(speed), {1, 1}, friction, forward_motion, 1);
      panel.series.push_back(contour(
          friction == 0 ? label : fmt::format("{}, friction {:g}", label, friction), rule, Mark::marked_line,
          [&](Direction line) { return sliding.along(line).leading_end().value; }));
    }
  }
  return panel;
}

/// At each speed, which takes a while.
std::vector<fast::SurfaceResponse> surfaces_at(const SurfaceAtSpeed& surface,
                                               const std::vector<double>& speeds) {
  std::vector<fast::SurfaceResponse> all(speeds.size());
  parallel_for(speeds.size(), [&](std::size_t i) { all[i] = surface(speeds[i]); }, {});
  return all;
}

/// A number of each of them.
Series of_surfaces(const std::string& label, const std::string& role, Mark mark,
                   const std::vector<double>& speeds, const std::vector<fast::SurfaceResponse>& surfaces,
                   const std::function<double(const fast::SurfaceResponse&)>& number) {
  Series series{label, role, mark, speeds, {}};
  for (const fast::SurfaceResponse& one : surfaces) series.y.push_back(number(one));
  return series;
}

double exact_span_ratio_of(const fast::SurfaceResponse& surface, Direction line) {
  const fast::EllipticContact contact(surface, {1, 1});
  return contact.radius_ratio(line).value / contact.radius_ratio(forward_motion).value;
}

Panel compliance_by_direction(const SurfaceAtSpeed& surface, const std::vector<double>& speeds,
                              const std::string& unit) {
  Panel panel{{"direction from the motion, degrees"}, {"compliance K, " + unit}, {}};
  for (const double speed : speeds) {
    const fast::SurfaceResponse lines = surface(speed);
    panel.series.push_back(
        sampled(fmt::format("c = {:g}", speed), "compliance", Mark::line, evenly(-90, 90, 181),
                [&](double angle) { return lines(Direction::of_degrees(angle)).compliance; }));
  }
  return panel;
}

Panel compliance_by_speed(const SurfaceAtSpeed& surface, double critical, const std::vector<double>& angles,
                          const std::string& unit) {
  Panel panel{{fmt::format("speed c, up to {:g} of the critical {:.6g}", nearly_critical, critical)},
              {"compliance K, " + unit, true},
              {}};
  std::vector<double> speeds = evenly(0, 0.95 * critical, 96);
  std::ranges::copy(evenly(0.955 * critical, nearly_critical * critical, 45), std::back_inserter(speeds));
  const auto surfaces = surfaces_at(surface, speeds);
  for (const double angle : angles)
    panel.series.push_back(of_surfaces(
        fmt::format("{:g} degrees", angle), "compliance", Mark::line, speeds, surfaces,
        [&](const fast::SurfaceResponse& lines) { return lines(Direction::of_degrees(angle)).compliance; }));
  return panel;
}

/// Spans across over spans along the motion against the speed, for the table's frictions.
Panel span_ratios_by_speed(const Replay& replay, const SurfaceAtSpeed& surface, double critical,
                           const std::vector<double>& frictions) {
  Panel panel{{"speed c"}, {"span across over span along the motion"}, {}};
  const std::vector<double> speeds = evenly(0, 0.98 * critical, 50);
  const auto surfaces = surfaces_at(surface, speeds);
  panel.series.push_back(of_surfaces(
      "friction 0", ellipse, Mark::line, speeds, surfaces,
      [&](const fast::SurfaceResponse& lines) { return exact_span_ratio_of(lines, across_motion); }));
  for (const double friction : frictions) {
    const std::string label = fmt::format("friction {:g}", friction);
    panel.series.push_back(of_surfaces(
        label, rule, Mark::marked_line, speeds, surfaces, [&](const fast::SurfaceResponse& lines) {
          return fast::sliding_for_span(lines, {1, 1}, friction, forward_motion, 1)
              .span_ratio(across_motion)
              .value;
        }));
    append_cells(panel, label, replay, [&](const ReplayedCell& cell) -> std::optional<double> {
      if (key_of_row(replay.table, cell.row) != friction) return {};
      return speed_of_column(replay, cell.column);
    });
  }
  return panel;
}

std::vector<double> keys_of(const Replay& replay) {
  std::vector<double> keys;
  for (std::size_t row = 0; row < replay.table.rows.size(); ++row)
    keys.push_back(key_of_row(replay.table, row));
  return keys;
}

std::vector<Panel> sliding_die(const FigureSubject& subject) {
  const Replay replay = replay_table(subject.tables.front());
  const double poisson = replay.table.parameter("poisson").value;
  const SurfaceAtSpeed surface = [=](double speed) { return isotropic_surface(poisson, speed); };
  const double critical = fast::isotropic_rayleigh_speed(poisson);
  return {contours(surface, {0.3, 0.6}, {0, 0.3}),
          span_ratios_by_speed(replay, surface, critical, keys_of(replay)),
          compliance_by_direction(surface, {0, 0.3, 0.6, 0.9}, "1/mu"),
          compliance_by_speed(surface, critical, {0, 30, 60, 90}, "1/mu")};
}

std::vector<Panel> rolling_sphere(const FigureSubject& subject) {
  const Replay replay = replay_table(subject.tables.front());
  const double poisson = replay.table.parameter("poisson").value;
  const auto rolling = [&](double speed) {
    return fast::rolling_sphere_for_span(unit_isotropic(poisson), 1, speed, 1e-3);
  };
  Panel shapes = contour_panel();
  for (const double speed : {0.3, 0.6}) {
    const std::string label = fmt::format("c = {:g}", speed);
    const fast::RollingSphere sphere = rolling(speed);
    shapes.series.push_back(exact_contour(label, isotropic_surface(poisson, speed)));
    shapes.series.push_back(contour(label, rule, Mark::marked_line,
                                    [&](Direction line) { return sphere.span_ratio(line).value / 2; }));
  }
  Panel ratios{{"speed c"}, {"span across over span along the motion"}, {}};
  const std::vector<double> speeds = evenly(0, 0.98 * fast::isotropic_rayleigh_speed(poisson), 50);
  ratios.series.push_back(computed("no friction", ellipse, Mark::line, speeds, [&](double speed) {
    return exact_span_ratio_of(isotropic_surface(poisson, speed), across_motion);
  }));
  ratios.series.push_back(computed("rolling", rule, Mark::marked_line, speeds, [&](double speed) {
    return rolling(speed).span_ratio(across_motion).value;
  }));
  append_cells(ratios, "rolling", replay,
               [&](const ReplayedCell& cell) { return std::optional(speed_of_column(replay, cell.column)); });
  return {shapes, ratios};
}

/// In units of the sphere's shear wave speed.
double critical_speed_of(const SphereOnHalfSpace& bodies, data::SymmetryAxis axis, Direction towards) {
  return std::min(fast::critical_speed(bodies.half_space, axis, towards).speed / bodies.speed_unit(),
                  fast::isotropic_rayleigh_speed(bodies.sphere.poisson));
}

std::vector<Panel> sphere_on_normal_axis(const FigureSubject& subject) {
  const Replay replay = replay_table(subject.tables.front());
  const SphereOnHalfSpace bodies(replay.table);
  const SurfaceAtSpeed surface = [&](double speed) {
    return bodies.in_contact(data::SymmetryAxis::normal, forward_motion, speed);
  };
  const double critical = critical_speed_of(bodies, data::SymmetryAxis::normal, forward_motion);
  return {contours(surface, {0.2, 0.4}, {0, 0.5}),
          span_ratios_by_speed(replay, surface, critical, keys_of(replay)),
          compliance_by_direction(surface, {0, 0.2, 0.4, 0.6}, "1/GPa"),
          compliance_by_speed(surface, critical, {0, 30, 60, 90}, "1/GPa")};
}

std::vector<Panel> branch_speeds(const FigureSubject& subject) {
  const Replay replay = replay_table(subject.tables.front());
  const SphereOnHalfSpace bodies(replay.table);
  Panel panel{{"direction of sliding theta, degrees"}, {"speed over the sphere's shear wave speed"}, {}};
  const std::vector<double> angles = evenly(0, 90, 46);
  struct Wave {
    std::string column, label;
    fast::BranchWave wave;
  };
  for (const Wave& one : {Wave{"c_56", "transverse (46a)", fast::BranchWave::transverse},
                          Wave{"c_plus", "quasi-longitudinal (46b)", fast::BranchWave::quasi_longitudinal},
                          Wave{"c_minus", "quasi-transverse (46b)", fast::BranchWave::quasi_transverse}}) {
    panel.series.push_back(sampled(one.label, "corrected", Mark::line, angles, [&](double angle) {
      return fast::branch_speed(one.wave, bodies.half_space, Direction::of_degrees(angle)) /
             bodies.speed_unit();
    }));
    append_cells(panel, one.label, replay, [&](const ReplayedCell& cell) -> std::optional<double> {
      if (cell.column != one.column) return {};
      return key_of_row(replay.table, cell.row);
    });
  }
  panel.series.push_back(
      computed("critical on some line", "corrected", Mark::line, angles, [&](double angle) {
        return critical_speed_of(bodies, data::SymmetryAxis::in_plane, Direction::of_degrees(angle));
      }));
  return {panel};
}

std::vector<Panel> sphere_on_axis_in_plane(const FigureSubject& subject) {
  const Replay replay = replay_table(subject.tables.front());
  const SphereOnHalfSpace bodies(replay.table);
  const Direction sliding = Direction::of_degrees(replay.table.parameter("theta").value);
  const SurfaceAtSpeed surface = [&](double speed) {
    return bodies.in_contact(data::SymmetryAxis::in_plane, sliding, speed);
  };
  Panel ratios{{"direction from the motion phi, degrees"}, {"span there over span along the motion"}, {}};
  for (const data::TableColumn& column : replay.table.columns) {
    if (column.is_key) continue;
    const std::string label = fmt::format("c = {:g}", *column.coordinate);
    const fast::SurfaceResponse lines = surface(*column.coordinate);
    const fast::EllipticContact exact(lines, {1, 1});
    const auto by_rule = fast::sliding_for_span(lines, {1, 1}, 0, forward_motion, 1);
    const std::vector<double> angles = evenly(-90, 90, 181);
    ratios.series.push_back(sampled(label, ellipse, Mark::line, angles, [&](double angle) {
      return exact.span_ratio(Direction::of_degrees(angle), forward_motion).value;
    }));
    ratios.series.push_back(sampled(label, rule, Mark::marked_line, angles, [&](double angle) {
      return by_rule.span_ratio(Direction::of_degrees(angle)).value;
    }));
    append_cells(ratios, label, replay, [&](const ReplayedCell& cell) -> std::optional<double> {
      if (cell.column != column.name) return {};
      return key_of_row(replay.table, cell.row);
    });
  }
  return {contours(surface, {0.05, 0.4}, {0}), ratios,
          compliance_by_direction(surface, {0, 0.2, 0.4, 0.49}, "1/GPa"),
          compliance_by_speed(surface, critical_speed_of(bodies, data::SymmetryAxis::in_plane, sliding),
                              {-45, -20, 0, 45, 90}, "1/GPa")};
}

}  // namespace

Drawings half_space_drawings() {
  return {{"sliding die", sliding_die},
          {"rolling sphere", rolling_sphere},
          {"sphere across layers", sphere_on_normal_axis},
          {"bulk waves", branch_speeds},
          {"sphere along layers", sphere_on_axis_in_plane}};
}

}  // namespace nipref::verify
