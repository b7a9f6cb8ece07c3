// Tables of brock2012 and brock2013: rigid bodies on an isotropic half-space, a sphere on a transversely isotropic one.

#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/rolling_sphere.hpp>
#include <nipref/fast/half_space/sliding.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>
#include <nipref/verify/replay/internal/half_space.hpp>

namespace nipref::verify {
namespace {

constexpr fast::Direction forwards{1, 0}, sideways{0, 1};

/// The C11/mu_0 from which the paper computed its c_plus and c_minus: a misprint of 0.18005.
constexpr double printed_d1 = 0.1803;

/// Spans of the contact at the angle phi, divided by the span along the motion: as (43) has them, and corrected.
class InPlaneSpans {
 public:
  explicit InPlaneSpans(const data::Table& table) : bodies_(table), theta_(table.parameter("theta").value) {}

  /// By (43) with this sign of its first term: 1 as printed, -1 as in the table.
  [[nodiscard]] double by(double sign, double phi, double speed) const {
    return printed("in_plane_span_ratio", {sign, theta_, phi, speed}, bodies_.scaled);
  }
  [[nodiscard]] double corrected(double phi, double speed) {
    return contact(speed).by_rule.span_ratio(fast::Direction::of_degrees(phi)).value;
  }
  [[nodiscard]] double exact(double phi, double speed) {
    return contact(speed).exact.span_ratio(fast::Direction::of_degrees(phi), forwards).value;
  }

 private:
  struct Contact {
    fast::SlidingContact by_rule;
    fast::EllipticContact exact;
  };
  const Contact& contact(double speed) {
    if (const auto found = contacts_.find(speed); found != contacts_.end()) return found->second;
    const auto surface =
        bodies_.in_contact(data::SymmetryAxis::in_plane, fast::Direction::of_degrees(theta_), speed);
    const Contact solved{fast::sliding_for_span(surface, {1, 1}, 0, forwards, 1), {surface, {1, 1}}};
    return contacts_.emplace(speed, solved).first->second;
  }
  SphereOnHalfSpace bodies_;
  double theta_;
  std::map<double, Contact> contacts_;  ///< one for each column
};

/// A proof from the symmetry of K that the cell is wrong; empty if the symmetry proves nothing.
std::string in_plane_proof(const data::Table& table, std::size_t row, const std::string& column) {
  const double phi = key_of_row(table, row);
  const data::TableCell& cell = table.cell(row, column);
  const data::TableCell& opposite = table.cell(0, column);
  if (phi == -90) {
    return fmt::format(
        "K depends on psi through sin^2, cos^2 and c_X only, and c_X = 0 at phi = +-90, so this must equal "
        "the {} of phi = 90 (one wrong K(-90) in all columns; the second term of M without its sin^2(psi) "
        "comes within 3 units of it)",
        opposite.printed);
  }
  if (phi == 90 && cell.number->rounding.lower > 1) {
    return "L_90/L_X = K at rest/K_X < 1 because c_X = 0 at phi = 90, K is the same at 45 and 135 degrees, "
           "and K_X grows with speed: the column's K_X is too small";
  }
  return "";
}

/// The table's formula at phi, divided by the K_X that follows from the column's cell in another row.
Attempt with_the_columns_unit(const InPlaneSpans& spans, const data::Table& table, double phi,
                              std::size_t other_row, const data::TableColumn& column) {
  const auto tabulated = [&](double at) { return spans.by(-1, at, *column.coordinate); };
  const double other = key_of_row(table, other_row);
  return {table.cell(other_row, column.name).number->rounding.times(tabulated(phi) / tabulated(other)),
          Verdict::seed_error,
          fmt::format("with the K_X by which the column's cell of phi = {:g} was divided", other)};
}

/// The span across the motion divided by the span along it, by the papers' rule and exactly.
HalfSpaceCell of_sliding(std::size_t row, const data::TableColumn& column,
                         const fast::SurfaceResponse& surface, double friction,
                         const std::vector<Attempt>& attempts, const std::string& error,
                         const std::string& proof) {
  const auto by_rule = fast::sliding_for_span(surface, {1, 1}, friction, forwards, 1).span_ratio(sideways);
  const auto exact = fast::EllipticContact(surface, {1, 1}).span_ratio(sideways, forwards);
  return {row, column.name, by_rule.value, attempts, error, proof, exact.value};
}

}  // namespace

CellOf sliding_die_cells(const data::Table& table) {
  return [&table](std::size_t row, const data::TableColumn& column) {
    const double poisson = table.parameter("poisson").value, speed = *column.coordinate,
                 friction = table.cell(row, "gamma").number->value;
    const auto tabulated = [&](double decimals) {
      return printed("die_span_ratio_tabulated", {poisson, friction, speed, decimals});
    };
    const double exact_roots = tabulated(0), rounded_roots = tabulated(table_root_decimals);
    const std::string error = fmt::format(
        "(35) with friction where there is none (sqrt(c_D^4 + gamma^2)) and none where there is "
        "(Delta_1, Q_1); as printed it gives {:.5f}",
        printed("die_span_ratio_printed", {poisson, friction, speed}));
    return of_sliding(row, column, isotropic_surface(poisson, speed), friction,
                      {{data::Interval::only(exact_roots), Verdict::match, "reproduced so"},
                       {data::Interval::only(rounded_roots), Verdict::match,
                        "reproduced so with w_S and w_D to five decimals"}},
                      error, "");
  };
}

CellOf rolling_sphere_cells(const data::Table& table) {
  return [&table](std::size_t row, const data::TableColumn& column) -> HalfSpaceCell {
    const double poisson = table.parameter("poisson").value, speed = *column.coordinate;
    const double corrected =
        fast::rolling_sphere_for_span(unit_isotropic(poisson), 1, speed, 1e-3).span_ratio(sideways).value;
    const double rounded_roots =
        printed("rolling_span_ratio_tabulated", {poisson, speed, table_root_decimals});
    const std::string loss = fmt::format(
        "lost digits: (53b), without the c_D under its root with which it gives {:.5f}, is {:.5f}, "
        "but {:.5f} with w_S and w_D to five decimals",
        printed("rolling_span_ratio_printed", {poisson, speed}), corrected, rounded_roots);
    return {row,
            column.name,
            corrected,
            {{data::Interval::only(corrected), Verdict::match, "to the digits printed"},
             {data::Interval::only(rounded_roots), Verdict::match, loss}},
            ""};
  };
}

CellOf sphere_on_normal_axis_cells(const data::Table& table) {
  return [&table, bodies = SphereOnHalfSpace(table)](std::size_t row, const data::TableColumn& column) {
    const double friction = key_of_row(table, row), speed = *column.coordinate;
    const std::string error = fmt::format(
        "(35) divides the half-space's term by c_D^2 - 1 too: {:.4f} at rest without friction, where the "
        "circle demands 1; and (25c) adds the couplings, which subtract",
        printed("sphere_span_ratio_printed", {0, 0}, bodies.scaled));
    const double made = printed("sphere_span_ratio_printed", {friction, speed}, bodies.scaled);
    return of_sliding(row, column, bodies.in_contact(data::SymmetryAxis::normal, forwards, speed), friction,
                      {{data::Interval::only(made), Verdict::seed_error, "reproduced so"}}, error, error);
  };
}

CellOf branch_speed_cells(const data::Table& table) {
  const SphereOnHalfSpace bodies(table);
  data::TransverselyIsotropicSolid with_printed_d1 = bodies.half_space;
  with_printed_d1.c11 = printed_d1 * bodies.sphere.shear;
  return [=, &table](std::size_t row, const data::TableColumn& column) -> HalfSpaceCell {
    const fast::Direction motion = fast::Direction::of_degrees(key_of_row(table, row));
    const bool is_transverse = column.name == "c_56";
    const auto wave = is_transverse             ? fast::BranchWave::transverse
                      : column.name == "c_plus" ? fast::BranchWave::quasi_longitudinal
                                                : fast::BranchWave::quasi_transverse;
    const auto speed = [&](const data::TransverselyIsotropicSolid& solid) {
      return fast::branch_speed(wave, solid, motion) / bodies.speed_unit();
    };
    const double made = speed(is_transverse ? bodies.half_space : with_printed_d1);
    const std::string how =
        fmt::format("with d1 = {} for {:.5f}; P6 as printed leaves {:.3f} under the root", printed_d1,
                    bodies.half_space.c11 / bodies.sphere.shear,
                    printed("branch_radicand_printed", {key_of_row(table, row)}, bodies.scaled));
    return {row,
            column.name,
            speed(bodies.half_space),
            {{data::Interval::only(made), Verdict::match, is_transverse ? "" : how}},
            ""};
  };
}

CellOf sphere_on_axis_in_plane_cells(const data::Table& table) {
  return [&table, spans = InPlaneSpans(table)](std::size_t row, const data::TableColumn& column) mutable {
    const double phi = key_of_row(table, row), speed = *column.coordinate;
    const double tabulated = spans.by(-1, phi, speed);
    HalfSpaceCell cell{row,
                       column.name,
                       spans.corrected(phi, speed),
                       {{data::Interval::only(tabulated), Verdict::match, "reproduced so"}},
                       fmt::format("M of (43b) without its last term; as printed, with the sign of the first "
                                   "wrong too, {:.4f}",
                                   spans.by(1, phi, speed)),
                       in_plane_proof(table, row, column.name),
                       spans.exact(phi, speed)};
    constexpr std::size_t row_of_90 = 0, row_of_45 = 2;
    if (cell.proof.empty())
      cell.attempts.push_back(
          with_the_columns_unit(spans, table, phi, row == row_of_90 ? row_of_45 : row_of_90, column));
    return cell;
  };
}

}  // namespace nipref::verify
