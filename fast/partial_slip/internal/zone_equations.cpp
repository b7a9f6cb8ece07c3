#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <nipref/fast/number/internal/linear_system.hpp>
#include <nipref/fast/partial_slip/internal/zone_equations.hpp>

namespace nipref::fast {
namespace {

using Eigen::ArrayXd, Eigen::Index;
using std::numbers::pi;

}  // namespace

ZoneEquations::ZoneEquations(const PartialSlipTask& task, const std::vector<Zone>& zones, double nats)
    : task_(task),
      zones_(zones),
      mesh_(zones, task, nats),
      unknowns_(Eigen::VectorXd::Zero(mesh_.unknowns() + 2)) {}

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

bool ZoneEquations::sticks_everywhere() const {
  return zones_.size() == 1 && zones_.front().sign == 0 && task_.traction == 0.0;
}

ZoneEquations::Forces ZoneEquations::forces() const {
  const auto tractions = unknowns_.head(mesh_.unknowns());
  Forces forces{mesh_.at_nodes().pressure * tractions, mesh_.at_nodes().shear * tractions};
  for (std::size_t j = 0; j < mesh_.nodes().size(); ++j) {
    const double weight = mesh_.weight(mesh_.nodes()[j]);
    forces.normal(static_cast<Index>(j)) *= weight;
    forces.tangential(static_cast<Index>(j)) *= weight;
  }
  return forces;
}

Eigen::ArrayXXd ZoneEquations::cauchy() const {
  Eigen::ArrayXXd kernels(mesh_.midpoints().size(), mesh_.nodes().size());
  for (Index j = 0; j < kernels.cols(); ++j)
    for (Index i = 0; i < kernels.rows(); ++i)
      kernels(i, j) = mesh_.distance(mesh_.midpoints()[static_cast<std::size_t>(i)],
                                     mesh_.nodes()[static_cast<std::size_t>(j)]);
  return -1 / (pi * kernels);
}

SlopeKernels ZoneEquations::rests() const {
  return {length(), places(mesh_.midpoints()), places(mesh_.nodes())};
}

ZoneEquations::Misfits ZoneEquations::misfits() const {
  const auto tractions = unknowns_.head(mesh_.unknowns());
  const Eigen::VectorXd p_here = mesh_.at_midpoints().pressure * tractions,
                        q_here = mesh_.at_midpoints().shear * tractions;
  const auto [normal, tangential] = forces();
  const Eigen::MatrixXd kernels = cauchy();
  const auto [rest_across, rest_along] = rests().values(normal.matrix(), tangential.matrix());
  const Eigen::VectorXd across = kernels * normal.matrix() + rest_across + task_.beta * q_here,
                        along = kernels * tangential.matrix() + rest_along - task_.beta * p_here;
  return {across.array() - 2 * (leading_length() - places(mesh_.midpoints())), along.array() - creep()};
}

ArrayXd ZoneEquations::extents(Index zone, const auto& points) const {
  return ArrayXd::NullaryExpr(static_cast<Index>(points.size()), [&](Index i) {
    return mesh_.extent(static_cast<int>(zone), points[static_cast<std::size_t>(i)]);
  });
}

ZoneEquations::Rows ZoneEquations::rows() const {
  const auto& nodes = mesh_.nodes();
  const Index unknowns = mesh_.unknowns(), zones = static_cast<Index>(zones_.size());
  const Eigen::VectorXd weights =
      Eigen::VectorXd::NullaryExpr(static_cast<Index>(nodes.size()),
                                   [&](Index j) { return mesh_.weight(nodes[static_cast<std::size_t>(j)]); });
  const Eigen::SparseMatrix<double> pressure = weights.asDiagonal() * mesh_.at_nodes().pressure,
                                    shear = weights.asDiagonal() * mesh_.at_nodes().shear;
  const Eigen::MatrixXd kernels = cauchy();
  const SlopeKernels rest = rests();
  const auto [rest_across, rest_along] = rest.values(pressure, shear);
  Rows rows{Eigen::MatrixXd(kernels.rows(), unknowns + zones),
            Eigen::MatrixXd(kernels.rows(), unknowns + zones)};
  rows.normal.leftCols(unknowns) = kernels * pressure + rest_across;
  rows.normal.leftCols(unknowns) += task_.beta * mesh_.at_midpoints().shear;
  rows.along.leftCols(unknowns) = kernels * shear + rest_along;
  rows.along.leftCols(unknowns) -= task_.beta * mesh_.at_midpoints().pressure;
  for (Index z = 0; z < zones; ++z) add_length(z, kernels, rest, rows);
  return rows;
}

void ZoneEquations::add_length(Index zone, const Eigen::MatrixXd& kernels, const SlopeKernels& rest,
                               Rows& rows) const {
  // The length moves midpoints and nodes, and changes the weights of its nodes.
  const auto [normal, tangential] = forces();
  const ArrayXd own = extents(zone, mesh_.midpoints()), moves = extents(zone, mesh_.nodes());
  ArrayXd p_of_zone = normal, q_of_zone = tangential, across = 2 * own, along = ArrayXd::Zero(own.size());
  for (Index j = 0; j < moves.size(); ++j) {
    const ZoneMesh::Point& node = mesh_.nodes()[static_cast<std::size_t>(j)];
    const ArrayXd stretches = ArrayXd::NullaryExpr(own.size(), [&](Index i) {
      return mesh_.stretch(static_cast<int>(zone), mesh_.midpoints()[static_cast<std::size_t>(i)], node);
    });
    const auto slope = pi * kernels.col(j).array().square() * stretches;
    across += normal(j) * slope;
    along += tangential(j) * slope;
    if (mesh_.zone(node) != zone) p_of_zone(j) = q_of_zone(j) = 0;
  }
  const auto [here, here_along] = rest.slopes(normal.matrix(), tangential.matrix());
  const auto [moved, moved_along] = rest.slopes((normal * moves).matrix(), (tangential * moves).matrix());
  const auto [by_weight, by_weight_along] = rest.values(p_of_zone.matrix(), q_of_zone.matrix());
  across += own * here.array() - moved.array();
  along += own * here_along.array() - moved_along.array();
  const Index column = mesh_.unknowns() + zone;
  rows.normal.col(column) = across.matrix() + kernels * p_of_zone.matrix() + by_weight;
  rows.along.col(column) = along.matrix() + kernels * q_of_zone.matrix() + by_weight_along;
}

bool ZoneEquations::is_square() const {
  Index equations = sticks_everywhere() ? 1 : 2;
  for (const ZoneMesh::Midpoint& midpoint : mesh_.midpoints())
    equations += (midpoint.matches_normal ? 1 : 0) + (midpoint.matches_along ? 1 : 0);
  return equations == unknowns_.size() + static_cast<Index>(zones_.size());
}

Eigen::VectorXd ZoneEquations::residual() const {
  const auto [normal, along] = misfits();
  std::vector<double> residual;
  for (Index i = 0; i < normal.size(); ++i)
    if (mesh_.midpoints()[static_cast<std::size_t>(i)].matches_normal) residual.push_back(normal(i));
  for (Index i = 0; i < along.size(); ++i)
    if (mesh_.midpoints()[static_cast<std::size_t>(i)].matches_along) residual.push_back(along(i));
  residual.push_back(task_.load ? forces().normal.sum() - *task_.load : length() - *task_.length);
  if (!sticks_everywhere())
    residual.push_back(task_.creep ? creep() - *task_.creep : forces().tangential.sum() - *task_.traction);
  return Eigen::Map<Eigen::VectorXd>(residual.data(), static_cast<Index>(residual.size()));
}

Eigen::MatrixXd ZoneEquations::jacobian() const {
  const Index unknowns = mesh_.unknowns(), lengths = unknowns + 2, zones = static_cast<Index>(zones_.size());
  const Rows of = rows();
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(lengths + zones, lengths + zones);
  Index row = 0;
  const auto add = [&](const Eigen::MatrixXd& rows, bool ZoneMesh::Midpoint::*matches, Index further,
                       double slope) {
    for (Index i = 0; i < rows.rows(); ++i) {
      if (!(mesh_.midpoints()[static_cast<std::size_t>(i)].*matches)) continue;
      jacobian.row(row).head(unknowns) = rows.row(i).head(unknowns);
      jacobian.row(row).tail(zones) = rows.row(i).tail(zones);
      jacobian(row++, further) = slope;
    }
  };
  add(of.normal, &ZoneMesh::Midpoint::matches_normal, unknowns, -2);
  add(of.along, &ZoneMesh::Midpoint::matches_along, unknowns + 1, -1);
  const auto add_integral = [&](const Eigen::SparseMatrix<double>& tractions, const ArrayXd& forces) {
    for (Index j = 0; j < forces.size(); ++j) {
      const ZoneMesh::Point& node = mesh_.nodes()[static_cast<std::size_t>(j)];
      jacobian.row(row).head(unknowns) += mesh_.weight(node) * tractions.row(j);
      jacobian(row, lengths + mesh_.zone(node)) += forces(j);
    }
    ++row;
  };
  const auto [normal, tangential] = forces();
  if (task_.load)
    add_integral(mesh_.at_nodes().pressure, normal);
  else
    for (Index z = 0; z < zones; ++z) jacobian(row, lengths + z) = zones_[static_cast<std::size_t>(z)].length;
  if (task_.length) ++row;
  if (sticks_everywhere()) return jacobian;
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
  // Further than this the zones' order does not last; Newton's steps are cut to it.
  constexpr double longest_step = 0.7, least_part = 1.0 / 64;
  // After a shorter step the same derivatives do.
  constexpr double short_step = 1e-3;
  constexpr int most_steps = 30;
  const double longest = 2 * length();
  const auto size_of = [&](const Eigen::VectorXd& change) {
    return change.tail(static_cast<Index>(zones_.size())).cwiseAbs().maxCoeff();
  };
  double last_step = std::numeric_limits<double>::infinity();
  Eigen::PartialPivLU<Eigen::MatrixXd> derivatives;
  Eigen::VectorXd remains = residual();
  for (int number = 0; number < most_steps; ++number) {
    if (last_step > short_step) {
      derivatives.compute(jacobian());
      ++task_.work->systems;
      task_.work->unknowns = std::max(task_.work->unknowns, static_cast<int>(derivatives.rows()));
    }
    const Eigen::VectorXd change = derivatives.solve(remains);
    const double size = size_of(change);
    if (!std::isfinite(size)) return false;
    // Steps shrink until rounding rules.
    if (last_step < short_step && size > last_step / 2) return true;
    // The part of the step after which the same derivatives ask for a shorter one (Deuflhard 2004, 3.3).
    const Eigen::VectorXd unknowns = unknowns_;
    const std::vector<Zone> zones = zones_;
    for (double part = std::min(1.0, longest_step / size);; part /= 2) {
      unknowns_ = unknowns;
      zones_ = zones;
      step(change, part);
      if (length() > longest ||
          std::ranges::any_of(zones_, [&](const Zone& zone) { return zone.length < 1e-13 * length(); }))
        return false;
      remains = residual();
      if (size < short_step || size_of(derivatives.solve(remains)) < (1 - part / 4) * size) break;
      if (part < least_part) return false;
    }
    if (size < 1e-11) return true;
    last_step = size;
  }
  return false;
}

}  // namespace nipref::fast
