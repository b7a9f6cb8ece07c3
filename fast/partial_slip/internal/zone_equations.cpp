#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <nipref/fast/partial_slip/internal/zone_equations.hpp>

namespace nipref::fast {
namespace {

using Eigen::ArrayXd, Eigen::Index;
using Sparse = Eigen::SparseMatrix<double>;
using std::numbers::pi;

/// The midpoints at which an equation holds.
std::vector<Index> matched(const std::vector<ZoneMesh::Midpoint>& midpoints,
                           bool ZoneMesh::Midpoint::*matches) {
  std::vector<Index> all;
  for (std::size_t i = 0; i < midpoints.size(); ++i)
    if (midpoints[i].*matches) all.push_back(static_cast<Index>(i));
  return all;
}

Sparse rows_of(const Sparse& matrix, const std::vector<Index>& rows) {
  Sparse choice(std::ssize(rows), matrix.rows());
  for (std::size_t i = 0; i < rows.size(); ++i) choice.insert(static_cast<Index>(i), rows[i]) = 1;
  return choice * matrix;
}

}  // namespace

ZoneEquations::ZoneEquations(const PartialSlipTask& task, const Zones& zones, double nats)
    : task_(task),
      zones_(zones),
      mesh_(zones, task, nats),
      normal_(matched(mesh_.midpoints(), &ZoneMesh::Midpoint::matches_normal)),
      along_(matched(mesh_.midpoints(), &ZoneMesh::Midpoint::matches_along)),
      shear_here_(rows_of(mesh_.at_midpoints().shear, normal_)),
      pressure_here_(rows_of(mesh_.at_midpoints().pressure, along_)),
      unknowns_(Eigen::VectorXd::Zero(mesh_.unknowns() + 2)) {
  set_kernels();
}

bool ZoneEquations::solve() {
  if (!is_square()) return false;
  // For given lengths the equations are linear.
  unknowns_ = least_squares(jacobian().leftCols(unknowns_.size()), -residual());
  return iterate();
}

bool ZoneEquations::solve_from(const Eigen::VectorXd& unknowns) {
  if (!is_square()) return false;
  unknowns_ = unknowns;
  return iterate();
}

Eigen::VectorXd ZoneEquations::weights() const {
  return Eigen::VectorXd::NullaryExpr(static_cast<Index>(mesh_.nodes().size()), [&](Index j) {
    return mesh_.weight(mesh_.nodes()[static_cast<std::size_t>(j)]);
  });
}

ZoneEquations::Forces ZoneEquations::forces() const {
  const auto tractions = unknowns_.head(mesh_.unknowns());
  const Eigen::VectorXd weights = this->weights();
  return {weights.cwiseProduct(mesh_.at_nodes().pressure * tractions),
          weights.cwiseProduct(mesh_.at_nodes().shear * tractions)};
}

void ZoneEquations::set_kernels() {
  mesh_.set_cauchy_kernels(kernels_.cauchy);
  kernels_.rest = {length(), places(mesh_.midpoints()), places(mesh_.nodes())};
}

ZoneEquations::Misfits ZoneEquations::misfits() const {
  const auto tractions = unknowns_.head(mesh_.unknowns());
  const Eigen::VectorXd p_here = mesh_.at_midpoints().pressure * tractions,
                        q_here = mesh_.at_midpoints().shear * tractions;
  const Forces forces = this->forces();
  const Eigen::VectorXd normal = forces.normal, tangential = forces.tangential;
  const Rows rest = kernels_.rest.values(normal, tangential);
  Eigen::VectorXd across = kernels_.cauchy * normal, along = kernels_.cauchy * tangential;
  across += rest.normal + task_.beta * q_here;
  along += rest.along - task_.beta * p_here;
  return {across.array() - 2 * (leading_length() - places(mesh_.midpoints())), along.array() - creep()};
}

Eigen::MatrixXd ZoneEquations::extents(const auto& points) const {
  return of_points(points, [&](const ZoneMesh::Point& point, Index zone) {
    return mesh_.extent(static_cast<int>(zone), point);
  });
}

ZoneEquations::Rows ZoneEquations::by_lengths() const {
  const auto& [cauchy, rest] = kernels_;
  // The length of a zone moves midpoints and nodes, and changes the weights of the zone's nodes.
  const Forces forces = this->forces();
  const Eigen::VectorXd normal = forces.normal, tangential = forces.tangential;
  const Eigen::MatrixXd own = extents(mesh_.midpoints()), moves = extents(mesh_.nodes());
  const Eigen::MatrixXd in_zone = of_points(mesh_.nodes(), [&](const ZoneMesh::Point& node, Index zone) {
    return mesh_.zone(node) == zone ? 1.0 : 0.0;
  });
  const Eigen::MatrixXd p_of_zones = normal.asDiagonal() * in_zone,
                        q_of_zones = tangential.asDiagonal() * in_zone;
  const Eigen::MatrixXd moved_p = normal.asDiagonal() * moves, moved_q = tangential.asDiagonal() * moves;
  const Rows here = rest.slopes(normal, tangential), moved = rest.slopes(moved_p, moved_q),
             by_weight = rest.values(p_of_zones, q_of_zones);
  Rows rows{2 * own + here.normal.asDiagonal() * own - moved.normal + by_weight.normal,
            here.along.asDiagonal() * own - moved.along + by_weight.along};
  add_of_cauchy(cauchy, normal, rows.normal);
  add_of_cauchy(cauchy, tangential, rows.along);
  return rows;
}

/// Between points in one zone nothing changes, because the kernel falls as the weights grow. For points outside the
/// zone of the nodes, the weights grow with the length of this zone, and the distance d grows by the part of each zone
/// that lies between; d(-1/(pi d))/dd = 1/(pi d^2).
void ZoneEquations::add_of_cauchy(const Eigen::MatrixXd& cauchy, const Eigen::VectorXd& forces,
                                  Eigen::MatrixXd& by_lengths) const {
  const auto zones = static_cast<Index>(zones_.size());
  for (Index b = 0; b < zones; ++b) {
    const auto [node, nodes] = range_of(b, mesh_.nodes());
    const auto [first, own] = range_of(b, mesh_.midpoints());
    const auto force = forces.segment(node, nodes);
    // The midpoints behind the zone, and those ahead of it.
    for (const bool ahead : {false, true}) {
      const Index row = ahead ? 0 : first + own, rows = ahead ? first : cauchy.rows() - row;
      const auto kernel = cauchy.block(row, node, rows, nodes);
      auto of_zone = by_lengths.col(b).segment(row, rows).array();
      ArrayXd sums = ArrayXd::Zero(rows);
      for (Index j = 0; j < nodes; ++j) {
        const double within = mesh_.from_end(mesh_.nodes()[static_cast<std::size_t>(node + j)], !ahead);
        const ArrayXd by_distance = ((ahead ? -pi : pi) * force(j)) * kernel.col(j).array().square();
        of_zone += force(j) * kernel.col(j).array() + within * by_distance;
        sums += by_distance;
      }
      for (Index i = 0; i < rows; ++i) {
        const ZoneMesh::Point& here = mesh_.midpoints()[static_cast<std::size_t>(row + i)];
        const Index a = mesh_.zone(here);
        by_lengths(row + i, a) += sums(i) * mesh_.from_end(here, ahead);
        for (Index z = std::min(a, b) + 1; z < std::max(a, b); ++z)
          by_lengths(row + i, z) += sums(i) * zones_[static_cast<std::size_t>(z)].length;
      }
    }
  }
}

ZoneEquations::Index ZoneEquations::equations() const {
  return std::ssize(normal_) + std::ssize(along_) + (sticks_everywhere(task_, zones_) ? 1 : 2);
}

bool ZoneEquations::is_square() const { return equations() == unknowns_.size() + std::ssize(zones_); }

Eigen::VectorXd ZoneEquations::of_equations(const Misfits& at_midpoints, double of_load,
                                            double of_creep) const {
  Eigen::VectorXd numbers(equations());
  const Eigen::Vector2d further(of_load, of_creep);
  numbers << at_midpoints.normal(normal_), at_midpoints.along(along_),
      further.head(sticks_everywhere(task_, zones_) ? 1 : 2);
  return numbers;
}

Eigen::VectorXd ZoneEquations::residual() const {
  const Forces of = forces();
  return of_equations(misfits(), task_.load ? of.normal.sum() - *task_.load : length() - *task_.length,
                      task_.creep ? creep() - *task_.creep : of.tangential.sum() - *task_.traction);
}

ZoneEquations::Rounding ZoneEquations::rounding() const {
  constexpr double largest_rest = 0.25;  // that of S far away
  const Forces forces = this->forces();
  const Eigen::VectorXd normal = forces.normal.abs(), tangential = forces.tangential.abs();
  const auto tractions = unknowns_.head(mesh_.unknowns());
  const Eigen::VectorXd p_here = mesh_.at_midpoints().pressure * tractions,
                        q_here = mesh_.at_midpoints().shear * tractions;
  const Eigen::MatrixXd cauchy = kernels_.cauchy.cwiseAbs();
  const Eigen::VectorXd across = cauchy * normal, along = cauchy * tangential;
  const double rest = largest_rest * (normal.sum() + tangential.sum());
  const Eigen::VectorXd sizes =
      of_equations({across.array() + rest + task_.beta * q_here.array().abs() +
                        2 * (leading_length() - places(mesh_.midpoints())).abs(),
                    along.array() + rest + task_.beta * p_here.array().abs() + std::fabs(creep())},
                   task_.load ? normal.sum() : length(), task_.creep ? std::fabs(creep()) : tangential.sum());
  const Index zones = std::ssize(zones_);
  Eigen::MatrixXd by_equations = by_equations_;
  for (Index z = 0; z < zones; ++z) {
    by_equations.col(z) *= zones_[static_cast<std::size_t>(z)].length;
    if (z > 0) by_equations.col(z) += by_equations.col(z - 1);
  }
  const Eigen::VectorXd all = rounding_of_term * (by_equations.cwiseAbs().transpose() * sizes);
  return {all.head(zones), all(zones), all(zones + 1)};
}

Eigen::MatrixXd ZoneEquations::jacobian() const {
  const Index unknowns = mesh_.unknowns(), lengths = unknowns + 2, zones = static_cast<Index>(zones_.size());
  const Eigen::VectorXd weights = this->weights();
  const Sparse pressure = weights.asDiagonal() * mesh_.at_nodes().pressure,
               shear = weights.asDiagonal() * mesh_.at_nodes().shear;
  const Rows rest = kernels_.rest.at_points(pressure, shear), by_lengths = this->by_lengths();
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(lengths + zones, lengths + zones);
  Index row = 0;
  const auto add = [&](const std::vector<Index>& matched, const Sparse& forces,
                       const Eigen::MatrixXd& rest_at_points, const Sparse& here,
                       const Eigen::MatrixXd& of_lengths) {
    const Eigen::MatrixXd cauchy = kernels_.cauchy(matched, Eigen::all);
    auto rows = jacobian.middleRows(row, std::ssize(matched));
    auto by_tractions = rows.leftCols(unknowns);
    add_product(cauchy, forces, by_tractions);
    add_product(kernels_.rest.to_targets(matched), rest_at_points, by_tractions);
    by_tractions += here;
    rows.rightCols(zones) = of_lengths(matched, Eigen::all);
    row += rows.rows();
  };
  add(normal_, pressure, rest.normal, task_.beta * shear_here_, by_lengths.normal);
  jacobian.col(unknowns).head(row).setConstant(-2);
  add(along_, shear, rest.along, -task_.beta * pressure_here_, by_lengths.along);
  jacobian.col(unknowns + 1).segment(std::ssize(normal_), std::ssize(along_)).setConstant(-1);
  const auto add_integral = [&](const Sparse& tractions, const ArrayXd& forces) {
    jacobian.row(row).head(unknowns) = weights.transpose() * tractions;
    for (Index j = 0; j < forces.size(); ++j)
      jacobian(row, lengths + mesh_.zone(mesh_.nodes()[static_cast<std::size_t>(j)])) += forces(j);
    ++row;
  };
  const auto [normal, tangential] = forces();
  if (task_.load)
    add_integral(mesh_.at_nodes().pressure, normal);
  else
    for (Index z = 0; z < zones; ++z) jacobian(row, lengths + z) = zones_[static_cast<std::size_t>(z)].length;
  if (task_.length) ++row;
  if (sticks_everywhere(task_, zones_)) return jacobian;
  if (task_.creep)
    jacobian(row, unknowns + 1) = 1;
  else
    add_integral(mesh_.at_nodes().shear, tangential);
  return jacobian;
}

void ZoneEquations::step(const Eigen::VectorXd& change, double part) {
  unknowns_ -= part * change.head(unknowns_.size());
  for (std::size_t z = 0; z < zones_.size(); ++z)
    zones_[z].length *= std::exp(-part * change(unknowns_.size() + static_cast<Index>(z)));
  mesh_.stretch_to(zones_);
}

bool ZoneEquations::iterate() {
  Elimination derivatives;
  if (!converges(derivatives)) return false;
  const Index zones = std::ssize(zones_);
  by_equations_.resize(derivatives.size(), zones + 2);
  const Index lengths = unknowns_.size(), creep = lengths - 1, leading_length = lengths - 2;
  for (Index k = 0; k < zones + 2; ++k) {
    const Index unknown = k < zones ? lengths + k : k == zones ? creep : leading_length;
    by_equations_.col(k) = derivatives.solve_transposed(Eigen::VectorXd::Unit(derivatives.size(), unknown));
  }
  return true;
}

bool ZoneEquations::converges(Elimination& derivatives) {
  // Longer steps may not keep the zones' order; Newton's steps are cut to this length.
  constexpr double longest_step = 0.7, least_part = 1.0 / 64;
  // After a shorter step the derivatives are not computed again.
  constexpr double short_step = 1e-3;
  constexpr int most_steps = 30;
  // Over the contact length, e^-39: no accuracy in double resolves shorter zones.
  constexpr double shortest_zone = 1e-17;
  const double longest = 2 * length();
  const auto size_of = [&](const Eigen::VectorXd& change) {
    return change.tail(static_cast<Index>(zones_.size())).cwiseAbs().maxCoeff();
  };
  double last_step = std::numeric_limits<double>::infinity();
  Eigen::VectorXd remains = residual();
  for (int number = 0; number < most_steps; ++number) {
    if (last_step > short_step) {
      derivatives = Elimination(jacobian());
      ++task_.work->systems;
      task_.work->unknowns = std::max(task_.work->unknowns, static_cast<int>(derivatives.size()));
    }
    const Eigen::VectorXd change = derivatives.solve(remains);
    const double size = size_of(change);
    if (!std::isfinite(size)) return false;
    // Steps shrink until rounding dominates.
    if (last_step < short_step && size > last_step / 2) return true;
    // The step is halved until the next one by the same derivatives is shorter (Deuflhard 2004, 3.3).
    const Eigen::VectorXd unknowns = unknowns_;
    const Zones zones = zones_;
    for (double part = std::min(1.0, longest_step / size);; part /= 2) {
      unknowns_ = unknowns;
      zones_ = zones;
      step(change, part);
      if (length() > longest || std::ranges::any_of(zones_, [&](const Zone& zone) {
            return zone.length < shortest_zone * length();
          }))
        return false;
      set_kernels();
      remains = residual();
      if (size < short_step || size_of(derivatives.solve(remains)) < (1 - part / 4) * size) break;
      if (part < least_part) return false;
    }
    // Steps by the same derivatives shrink to about the part short_step: the next one would be less than rounding.
    if (size < 1e-11) return true;
    last_step = size;
  }
  return false;
}

}  // namespace nipref::fast
