#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <nipref/fast/number/internal/linear_system.hpp>
#include <nipref/fast/partial_slip/internal/zone_contact.hpp>
#include <nipref/fast/sheet/field.hpp>
#include <nipref/fast/sheet/kernels.hpp>

namespace nipref::fast {
namespace {

using Eigen::Index;
using std::numbers::pi;

/// Of |s|: weights beyond are e^-36 of a panel.
constexpr double far = 36;

}  // namespace

ZoneContact::ZoneContact(const PartialSlipTask& task, const std::vector<Zone>& zones, double nats)
    : task_(task), zones_(zones), mesh_(zones, task, nats), kernels_(3 * length_of(zones)) {}

bool ZoneContact::sticks_everywhere() const {
  return zones_.size() == 1 && zones_.front().sign == 0 && task_.traction == 0.0;
}

double ZoneContact::length() const { return length_of(zones_); }

ZoneContact::Traction ZoneContact::traction_at(const ZoneMesh::Point& point) const {
  Traction sum{0, 0};
  for (const ZoneMesh::Share& share : mesh_.shares(point)) {
    sum.pressure += share.pressure * unknowns_(share.unknown);
    sum.shear += share.shear * unknowns_(share.unknown);
  }
  return sum;
}

ZoneContact::Strains ZoneContact::strains() const {
  const auto& midpoints = mesh_.midpoints();
  const auto rows = static_cast<Index>(midpoints.size());
  Strains of{Eigen::MatrixXd::Zero(rows, mesh_.unknowns()), Eigen::MatrixXd::Zero(rows, mesh_.unknowns())};
  Eigen::Array<double, 4, Eigen::Dynamic> slopes(4, rows);
  for (const ZoneMesh::Point& node : mesh_.nodes()) {
    for (Index i = 0; i < rows; ++i)
      slopes.col(i) =
          mesh_.weight(node) * kernels_.at(mesh_.distance(midpoints[static_cast<std::size_t>(i)], node));
    for (const ZoneMesh::Share& share : mesh_.shares(node)) {
      of.normal.col(share.unknown).array() +=
          (share.pressure * slopes.row(0) - share.shear * slopes.row(1)).transpose();
      of.along.col(share.unknown).array() +=
          (share.pressure * slopes.row(1) + share.shear * slopes.row(2)).transpose();
    }
  }
  for (Index i = 0; i < rows; ++i) {
    for (const ZoneMesh::Share& share : mesh_.shares(midpoints[static_cast<std::size_t>(i)])) {
      of.normal(i, share.unknown) += task_.beta * share.shear;
      of.along(i, share.unknown) -= task_.beta * share.pressure;
    }
  }
  return of;
}

void ZoneContact::add_integrals(Equations& equations, Index row) const {
  const Index creep = mesh_.unknowns() + 1;
  const bool is_driven = task_.traction && !sticks_everywhere();
  for (const ZoneMesh::Point& node : mesh_.nodes()) {
    for (const ZoneMesh::Share& share : mesh_.shares(node)) {
      if (task_.load) equations.matrix(row, share.unknown) += mesh_.weight(node) * share.pressure;
      if (is_driven) equations.matrix(row + 1, share.unknown) += mesh_.weight(node) * share.shear;
    }
  }
  equations.right(row) = task_.load ? *task_.load : *task_.length - length();
  if (sticks_everywhere()) return;
  if (task_.creep) equations.matrix(row + 1, creep) = 1;
  equations.right(row + 1) = task_.creep ? *task_.creep : *task_.traction;
}

ZoneContact::Equations ZoneContact::equations() const {
  const auto& midpoints = mesh_.midpoints();
  const Index unknowns = mesh_.unknowns(), rows = unknowns + 2 + static_cast<Index>(zones_.size());
  const Strains of = strains();
  Equations equations{Eigen::MatrixXd::Zero(rows, unknowns + 2), Eigen::VectorXd::Zero(rows)};
  Index row = 0;
  for (std::size_t i = 0; i < midpoints.size(); ++i) {
    if (!mesh_.matches_normal(i)) continue;
    equations.matrix.row(row).head(unknowns) = of.normal.row(static_cast<Index>(i));
    equations.matrix(row, unknowns) = -2;
    equations.right(row++) = -2 * mesh_.place(midpoints[i]);
  }
  for (std::size_t i = 0; i < midpoints.size(); ++i) {
    if (mesh_.sign(midpoints[i]) != 0) continue;
    equations.matrix.row(row).head(unknowns) = of.along.row(static_cast<Index>(i));
    equations.matrix(row++, unknowns + 1) = -1;
  }
  if (row + (sticks_everywhere() ? 1 : 2) != rows) return {};
  add_integrals(equations, row);
  return equations;
}

Eigen::MatrixXd ZoneContact::by_lengths() const {
  const auto& midpoints = mesh_.midpoints();
  const auto& nodes = mesh_.nodes();
  const auto count = static_cast<Index>(zones_.size());
  const auto extents_of = [&](const ZoneMesh::Point& point) {
    Eigen::ArrayXd extents(count);
    for (Index z = 0; z < count; ++z) extents(z) = mesh_.extent(static_cast<int>(z), point);
    return extents;
  };
  struct Load {
    double pressure, shear;  ///< times the weight
    Eigen::ArrayXd extents;
  };
  std::vector<Load> loads;
  for (const ZoneMesh::Point& node : nodes) {
    const auto [p, q] = traction_at(node);
    loads.push_back({mesh_.weight(node) * p, mesh_.weight(node) * q, extents_of(node)});
  }
  const Index rows = mesh_.unknowns() + 2 + count, load_row = rows - (sticks_everywhere() ? 1 : 2);
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(rows, count);
  Index normal_row = 0,
        along_row = static_cast<Index>(std::ranges::count_if(
            midpoints, [&, i = std::size_t{0}](const auto&) mutable { return mesh_.matches_normal(i++); }));
  for (std::size_t i = 0; i < midpoints.size(); ++i) {
    const Eigen::ArrayXd own = extents_of(midpoints[i]);
    Eigen::ArrayXd normal = 2 * own, along = Eigen::ArrayXd::Zero(count);
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const auto& [p, q, extents] = loads[j];
      const double distance = mesh_.distance(midpoints[i], nodes[j]);
      const SlopeKernels::Values value = kernels_.at(distance), slope = kernels_.derivatives(distance);
      normal += (slope(0) * p - slope(1) * q) * (own - extents);
      along += (slope(1) * p + slope(2) * q) * (own - extents);
      normal(mesh_.zone(nodes[j])) += value(0) * p - value(1) * q;
      along(mesh_.zone(nodes[j])) += value(1) * p + value(2) * q;
    }
    if (mesh_.matches_normal(i)) columns.row(normal_row++) = normal;
    if (mesh_.sign(midpoints[i]) == 0) columns.row(along_row++) = along;
  }
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    if (task_.load) columns(load_row, mesh_.zone(nodes[j])) += loads[j].pressure;
    if (task_.traction && !sticks_everywhere()) columns(rows - 1, mesh_.zone(nodes[j])) += loads[j].shear;
  }
  if (task_.length)
    for (Index z = 0; z < count; ++z) columns(load_row, z) = zones_[static_cast<std::size_t>(z)].length;
  return columns;
}

bool ZoneContact::iterate() {
  // Further than this the zones' order does not last; Newton's steps are cut to it.
  constexpr double longest_step = 0.7;
  Equations now = equations();
  if (now.matrix.size() == 0) return false;
  const double longest = 2 * length();
  unknowns_ = least_squares(now.matrix, now.right);
  double last_step = std::numeric_limits<double>::infinity();
  task_.work->unknowns = std::max(task_.work->unknowns, static_cast<int>(now.matrix.rows()));
  for (int iteration = 0; iteration < 30; ++iteration) {
    ++task_.work->systems;
    const Index own = unknowns_.size();
    Eigen::MatrixXd jacobian(now.matrix.rows(), now.matrix.rows());
    jacobian << now.matrix, by_lengths();
    const Eigen::VectorXd change =
        linear_solution(jacobian, Eigen::VectorXd(now.right - now.matrix * unknowns_));
    const double step = change.tail(change.size() - own).cwiseAbs().maxCoeff();
    if (!std::isfinite(step)) return false;
    const double part = std::min(1.0, longest_step / step);
    unknowns_ += part * change.head(own);
    for (std::size_t z = 0; z < zones_.size(); ++z)
      zones_[z].length *= std::exp(part * change(own + static_cast<Index>(z)));
    if (std::ranges::any_of(zones_, [&](const Zone& zone) { return zone.length < 1e-9 * length(); }) ||
        length() > longest)
      return false;
    mesh_.stretch_to(zones_);
    // Newton's steps shrink by their squares until rounding rules.
    if (step < 1e-11 || (step < 1e-3 && step > last_step / 2)) return true;
    last_step = step;
    now = equations();
  }
  return false;
}

std::optional<ZoneContact> ZoneContact::solved(const PartialSlipTask& task, const std::vector<Zone>& zones,
                                               double nats, std::vector<Zone>* last) {
  ZoneContact contact(task, zones, nats);
  const bool found = contact.iterate();
  if (last != nullptr) *last = contact.zones_;
  if (!found) return std::nullopt;
  contact.take_samples();
  return contact;
}

double ZoneContact::load() const {
  double sum = 0;
  for (const ZoneMesh::Point& node : mesh_.nodes()) sum += mesh_.weight(node) * traction_at(node).pressure;
  return sum;
}

double ZoneContact::tangential_load() const {
  double sum = 0;
  for (const ZoneMesh::Point& node : mesh_.nodes()) sum += mesh_.weight(node) * traction_at(node).shear;
  return sum;
}

double ZoneContact::moment() const {
  double sum = 0;
  for (const ZoneMesh::Point& node : mesh_.nodes())
    sum += mesh_.weight(node) * traction_at(node).pressure * (leading_length() - mesh_.place(node));
  return sum;
}

ZoneContact::Traction ZoneContact::traction(double e) const {
  if (!(e > 0 && e < length())) return {0, 0};
  return traction_at(mesh_.point_at(e));
}

ZoneContact::Displacement ZoneContact::displacement_under(double distance, const Traction& load) const {
  // I3/pi less its jump, whose derivative is the local term of the strains.
  const double coupling = (I3(distance) - std::copysign(task_.beta * pi / 2, distance)) / pi;
  return {I1(distance) / pi * load.pressure - coupling * load.shear,
          coupling * load.pressure + I6(distance, 0) / pi * load.shear};
}

double ZoneContact::strain_under(double distance, const Traction& load) {
  constexpr auto first = data::Derivative::first;
  return vn_slope(distance, first) * load.pressure + vs_slope(distance, first) * load.shear;
}

template <class Add>
void ZoneContact::for_nodes_beyond(int panel, double e, const Add& add) const {
  for (const ZoneMesh::Point& node : mesh_.nodes()) {
    // The nodes next to the trailing end round to it; their weights are nothing.
    const double distance = e - mesh_.place(node);
    if (node.panel != panel && distance != 0) add(distance, mesh_.weight(node) * traction_at(node));
  }
}

double ZoneContact::strain(double e) const {
  double strain = 0;
  const auto add = [&](double distance, const Traction& load) { strain += strain_under(distance, load); };
  if (!(e > 0 && e < length())) {
    for_nodes_beyond(-1, e, add);
    return strain;
  }
  const ZoneMesh::Point point = mesh_.point_at(e);
  if (mesh_.sign(point) == 0) return creep();
  for_nodes_beyond(point.panel, e, add);
  // Nodes on both sides of the place, so that it lies midway between two.
  for (const int side : {-1, 1}) {
    for (int j = 0; j * mesh_.step() < 2 * far; ++j) {
      const ZoneMesh::Point node{point.panel, point.s + side * (j + 0.5) * mesh_.step()};
      if (std::fabs(node.s) < far) add(mesh_.distance(point, node), mesh_.weight(node) * traction_at(node));
    }
  }
  return strain - task_.beta * traction_at(point).pressure;
}

ZoneContact::Displacement ZoneContact::displacement(double e) const {
  Displacement sum{0, 0};
  const auto add = [&](double distance, const Traction& load) {
    const Displacement part = displacement_under(distance, load);
    sum.normal += part.normal;
    sum.along += part.along;
  };
  const bool is_inside = e > 0 && e < length();
  const int panel = is_inside ? mesh_.point_at(e).panel : -1;
  for_nodes_beyond(panel, e, add);
  if (!is_inside) return sum;
  // The logarithm at the place asks for nodes that crowd there from both sides.
  for (const double end : {mesh_.place({panel, -2 * far}), mesh_.place({panel, 2 * far})}) {
    const double length = std::fabs(end - e);
    for (double s = -far; length > 0 && s < far; s += mesh_.step()) {
      const ZoneMesh::Point node{panel, s};
      add(std::copysign(length * node.left, e - end),
          length * mesh_.step() * node.left * node.right * traction(e + (end - e) * node.left));
    }
  }
  return sum;
}

void ZoneContact::take_samples() {
  const Eigen::VectorXd along = strains().along * unknowns_.head(mesh_.unknowns());
  for (std::size_t i = 0; i < mesh_.midpoints().size(); ++i) {
    const ZoneMesh::Point point = mesh_.midpoints()[i];
    const auto [p, q] = traction_at(point);
    samples_.push_back({point, mesh_.zone(point), mesh_.sign(point), mesh_.place(point), mesh_.weight(point),
                        p, q, along(static_cast<Index>(i)) - creep()});
  }
}

double ZoneContact::dissipation() const {
  double sum = 0;
  for (const Sample& sample : samples_)
    if (sample.sign != 0) sum -= sample.weight * sample.shear * sample.slip;
  return sum;
}

}  // namespace nipref::fast
