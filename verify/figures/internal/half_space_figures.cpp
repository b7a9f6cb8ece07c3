#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/rolling_sphere.hpp>
#include <nipref/fast/half_space/sliding.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>
#include <nipref/verify/figures/internal/drawings.hpp>
#include <nipref/verify/replay/internal/half_space.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

// The curves on which the tables of the papers on half-spaces lie. Angles are measured from the direction of motion.

namespace nipref::verify {
namespace {

using fast::Direction;

const std::string ellipse = "exact ellipse, no friction", rule = "the paper's rule, corrected",
                  paper_formula = "the table's formula";
constexpr Direction forward_motion{1, 0}, across_motion{0, 1};

/// Two bodies of which one slides.
struct SlidingBodies {
  std::function<fast::SurfaceResponse(double speed)> surface;  ///< the response of one line to their pressure
  double critical_speed;
  std::string unit;  ///< of compliances
};

/// In units of the sphere's shear wave speed.
double critical_speed_of(const SphereOnHalfSpace& bodies, data::SymmetryAxis axis, Direction towards) {
  return std::min(fast::critical_speed(bodies.half_space, axis, towards).speed / bodies.speed_unit(),
                  fast::isotropic_rayleigh_speed(bodies.sphere.poisson));
}

SlidingBodies rigid_die(const data::Table& table) {
  const double poisson = table.parameter("poisson").value;
  return {[=](double speed) { return isotropic_surface(poisson, speed); },
          fast::isotropic_rayleigh_speed(poisson), "1/mu"};
}

SlidingBodies sphere_on(const data::Table& table, data::SymmetryAxis axis, Direction towards) {
  const SphereOnHalfSpace bodies(table);
  return {[=](double speed) { return bodies.in_contact(axis, towards, speed); },
          critical_speed_of(bodies, axis, towards), "1/GPa"};
}

std::string speed_label(double speed) { return fmt::format("c = {:g}", speed); }

/// The sliding speed of a column of the table.
double speed_of(const Replay& replay, const std::string& column) {
  return *replay.table.columns[replay.table.column_index(column)].coordinate;
}

/// Appends the cells of a table for which `placed` gives a place on the axis.
void append_cells(Panel& panel, const std::string& label, const Replay& replay,
                  const std::function<std::optional<double>(const ReplayedCell&)>& placed) {
  std::vector<PlacedCell> cells;
  for (const ReplayedCell& cell : replay.cells) {
    if (const auto place = placed(cell)) cells.push_back({&replay, cell.row, cell.column, *place, *place});
  }
  panel.series.push_back(replayed_series(label, paper_formula, cells));
  panel.series.push_back(printed_series(label, cells));
}

/// Appends the cells of a column against the first column of their rows.
void append_column(Panel& panel, const std::string& label, const Replay& replay, const std::string& column) {
  append_cells(panel, label, replay, [&](const ReplayedCell& cell) {
    return cell.column == column ? std::optional(key_of_row(replay.table, cell.row)) : std::nullopt;
  });
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
  return contour(label, ellipse, Mark::line,
                 [&](Direction line) { return contact.span_ratio(line, forward_motion).value / 2; });
}

Panel contour_panel() {
  return {{"along the motion, over the contact's span there"}, {"across the motion"}, {}, true};
}

Panel contours(const SlidingBodies& bodies, const FigureSubject& subject) {
  Panel panel = contour_panel();
  for (const double speed : subject.numbers("contour_speeds")) {
    const std::string label = speed_label(speed);
    const fast::SurfaceResponse lines = bodies.surface(speed);
    panel.series.push_back(exact_contour(label, lines));
    for (const double friction : subject.numbers("contour_frictions")) {
      const auto sliding = fast::sliding_for_span(lines, {1, 1}, friction, forward_motion, 1);
      panel.series.push_back(contour(
          friction == 0 ? label : fmt::format("{}, friction {:g}", label, friction), rule, Mark::marked_line,
          [&](Direction line) { return sliding.along(line).leading_end().value; }));
    }
  }
  return panel;
}

/// The responses of the bodies at several speeds, which are costly, for several curves.
struct SurfacesAtSpeeds {
  std::vector<double> speeds;
  std::vector<fast::SurfaceResponse> surfaces;

  SurfacesAtSpeeds(const SlidingBodies& bodies, std::vector<double> at)
      : speeds(std::move(at)),
        surfaces(parallel_mapped(speeds.size(), [&](std::size_t i) { return bodies.surface(speeds[i]); })) {}

  [[nodiscard]] Series curve(const std::string& label, const std::string& role, Mark mark,
                             const std::function<double(const fast::SurfaceResponse&)>& number) const {
    Series series{label, role, mark, speeds, {}};
    for (const fast::SurfaceResponse& one : surfaces) series.y.push_back(number(one));
    return series;
  }
  /// The span across over that along the motion, of ellipses.
  [[nodiscard]] Series exact_span_ratios(const std::string& label) const {
    return curve(label, ellipse, Mark::line, [](const fast::SurfaceResponse& lines) {
      return fast::EllipticContact(lines, {1, 1}).span_ratio(across_motion, forward_motion).value;
    });
  }
};

Panel compliance_by_direction(const SlidingBodies& bodies, const FigureSubject& subject) {
  Panel panel{{"direction from the motion, degrees"}, {"compliance K, " + bodies.unit}, {}};
  for (const double speed : subject.numbers("speeds")) {
    const fast::SurfaceResponse lines = bodies.surface(speed);
    panel.series.push_back(
        sampled(speed_label(speed), "compliance", Mark::line, subject.numbers("directions"),
                [&](double angle) { return lines(Direction::of_degrees(angle)).compliance; }));
  }
  return panel;
}

Panel compliance_by_speed(const SlidingBodies& bodies, const FigureSubject& subject) {
  Panel panel{{fmt::format("speed c, up to {:g} of the critical {:.6g}",
                           subject.numbers("to_critical").back(), bodies.critical_speed)},
              {"compliance K, " + bodies.unit, true},
              {}};
  const SurfacesAtSpeeds surfaces(bodies, subject.numbers("to_critical", bodies.critical_speed));
  for (const double angle : subject.numbers("angles"))
    panel.series.push_back(surfaces.curve(
        fmt::format("{:g} degrees", angle), "compliance", Mark::line,
        [&](const fast::SurfaceResponse& lines) { return lines(Direction::of_degrees(angle)).compliance; }));
  return panel;
}

/// Spans across over spans along the motion against the speed, for the frictions of the table's rows.
Panel span_ratios_by_speed(const Replay& replay, const SlidingBodies& bodies, const FigureSubject& subject) {
  Panel panel{{"speed c"}, {"span across over span along the motion"}, {}};
  const SurfacesAtSpeeds surfaces(bodies, subject.numbers("span_speeds", bodies.critical_speed));
  panel.series.push_back(surfaces.exact_span_ratios("friction 0"));
  for (std::size_t row = 0; row < replay.table.rows.size(); ++row) {
    const double friction = key_of_row(replay.table, row);
    const std::string label = fmt::format("friction {:g}", friction);
    panel.series.push_back(
        surfaces.curve(label, rule, Mark::marked_line, [&](const fast::SurfaceResponse& lines) {
          return fast::sliding_for_span(lines, {1, 1}, friction, forward_motion, 1)
              .span_ratio(across_motion)
              .value;
        }));
    append_cells(panel, label, replay, [&](const ReplayedCell& cell) {
      return cell.row == row ? std::optional(speed_of(replay, cell.column)) : std::nullopt;
    });
  }
  return panel;
}

/// Spans in a direction over spans along the motion, for the speeds of the table's columns.
Panel span_ratios_by_direction(const Replay& replay, const SlidingBodies& bodies,
                               const FigureSubject& subject) {
  Panel panel{{"direction from the motion phi, degrees"}, {"span there over span along the motion"}, {}};
  for (const data::TableColumn& column : replay.table.columns) {
    if (column.is_key) continue;
    const std::string label = speed_label(*column.coordinate);
    const fast::SurfaceResponse lines = bodies.surface(*column.coordinate);
    const fast::EllipticContact exact(lines, {1, 1});
    const auto by_rule = fast::sliding_for_span(lines, {1, 1}, 0, forward_motion, 1);
    const std::vector<double> angles = subject.numbers("directions");
    panel.series.push_back(sampled(label, ellipse, Mark::line, angles, [&](double angle) {
      return exact.span_ratio(Direction::of_degrees(angle), forward_motion).value;
    }));
    panel.series.push_back(sampled(label, rule, Mark::marked_line, angles, [&](double angle) {
      return by_rule.span_ratio(Direction::of_degrees(angle)).value;
    }));
    append_column(panel, label, replay, column.name);
  }
  return panel;
}

std::vector<Panel> sliding(const FigureSubject& subject) {
  const Replay replay = std::move(subject.replays().front());
  const data::Table& table = replay.table;
  const bool in_plane = subject.text == "sphere, axis in the plane";
  const SlidingBodies bodies = in_plane ? sphere_on(table, data::SymmetryAxis::in_plane,
                                                    Direction::of_degrees(table.parameter("theta").value))
                               : subject.text == "sphere, axis normal"
                                   ? sphere_on(table, data::SymmetryAxis::normal, forward_motion)
                                   : rigid_die(table);
  return {contours(bodies, subject),
          in_plane ? span_ratios_by_direction(replay, bodies, subject)
                   : span_ratios_by_speed(replay, bodies, subject),
          compliance_by_direction(bodies, subject), compliance_by_speed(bodies, subject)};
}

std::vector<Panel> rolling_sphere(const FigureSubject& subject) {
  const Replay replay = std::move(subject.replays().front());
  const double poisson = replay.table.parameter("poisson").value;
  const SlidingBodies bodies = rigid_die(replay.table);
  const auto rolling = [&](double speed) {
    return fast::rolling_sphere_for_span(unit_isotropic(poisson), 1, speed, 1e-3);
  };
  Panel shapes = contour_panel();
  for (const double speed : subject.numbers("contour_speeds")) {
    const std::string label = speed_label(speed);
    const fast::RollingSphere sphere = rolling(speed);
    shapes.series.push_back(exact_contour(label, bodies.surface(speed)));
    shapes.series.push_back(contour(label, rule, Mark::marked_line,
                                    [&](Direction line) { return sphere.span_ratio(line).value / 2; }));
  }
  Panel ratios{{"speed c"}, {"span across over span along the motion"}, {}};
  const SurfacesAtSpeeds surfaces(bodies, subject.numbers("span_speeds", bodies.critical_speed));
  ratios.series.push_back(surfaces.exact_span_ratios("no friction"));
  ratios.series.push_back(computed("rolling", rule, Mark::marked_line, surfaces.speeds, [&](double speed) {
    return rolling(speed).span_ratio(across_motion).value;
  }));
  append_cells(ratios, "rolling", replay,
               [&](const ReplayedCell& cell) { return std::optional(speed_of(replay, cell.column)); });
  return {shapes, ratios};
}

std::vector<Panel> branch_speeds(const FigureSubject& subject) {
  const Replay replay = std::move(subject.replays().front());
  const SphereOnHalfSpace bodies(replay.table);
  const std::vector<double> angles = subject.numbers("directions");
  struct Wave {
    std::string column, label;
    fast::BranchWave wave;
  };
  Panel panel{{"direction of sliding theta, degrees"}, {"speed over the sphere's shear wave speed"}, {}};
  for (const Wave& one : {Wave{"c_56", "transverse (46a)", fast::BranchWave::transverse},
                          Wave{"c_plus", "quasi-longitudinal (46b)", fast::BranchWave::quasi_longitudinal},
                          Wave{"c_minus", "quasi-transverse (46b)", fast::BranchWave::quasi_transverse}}) {
    panel.series.push_back(sampled(one.label, "corrected", Mark::line, angles, [&](double angle) {
      return fast::branch_speed(one.wave, bodies.half_space, Direction::of_degrees(angle)) /
             bodies.speed_unit();
    }));
    append_column(panel, one.label, replay, one.column);
  }
  panel.series.push_back(
      computed("critical on some line", "corrected", Mark::line, angles, [&](double angle) {
        return critical_speed_of(bodies, data::SymmetryAxis::in_plane, Direction::of_degrees(angle));
      }));
  return {panel};
}

}  // namespace

Drawings half_space_drawings() {
  return {{"sliding", sliding}, {"rolling sphere", rolling_sphere}, {"bulk waves", branch_speeds}};
}

}  // namespace nipref::verify
