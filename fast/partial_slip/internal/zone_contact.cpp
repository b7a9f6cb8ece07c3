#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include <nipref/fast/nip/internal/places.hpp>
#include <nipref/fast/partial_slip/internal/zone_contact.hpp>
#include <nipref/fast/sheet/field.hpp>
#include <nipref/fast/sheet/kernels.hpp>

namespace nipref::fast {
namespace {

using Eigen::ArrayXd, Eigen::Index;
using std::numbers::pi;

/// |s| beyond which weights are less than e^-36 of a panel, about 2^-52.
constexpr double far = 36;

}  // namespace

ZoneContact::ZoneContact(std::shared_ptr<const ZoneEquations> solved)
    : equations_(std::move(solved)), forces_(equations_->forces()) {
  const auto tractions = equations_->unknowns().head(mesh().unknowns());
  const ArrayXd pressure = mesh().at_midpoints().pressure * tractions,
                shear = mesh().at_midpoints().shear * tractions, slip = equations_->misfits().along;
  for (const ZoneMesh::Midpoint& point : mesh().midpoints()) {
    const auto i = static_cast<Index>(samples_.size());
    samples_.push_back({point, mesh().zone(point), mesh().sign(point), mesh().place(point),
                        mesh().weight(point), pressure(i), shear(i), slip(i),
                        std::max(ratio_after(point), std::fabs(shear(i) / pressure(i)))});
  }
}

double ZoneContact::ratio_after(const ZoneMesh::Point& point) const {
  // In the middle of a panel samples are up to a sixth of it apart; a zone of slip may be shorter than that.
  constexpr int between = 8;
  double largest = 0;
  for (int i = 1; i < (mesh().sign(point) == 0 ? between : 1); ++i) {
    const auto [p, q] = traction_at({point.panel, point.s + i * mesh().step() / between});
    largest = std::max(largest, std::fabs(q / p));
  }
  return largest;
}

bool ZoneContact::is_like(const ZoneContact& other) const {
  const Zones &here = zones(), &there = other.zones();
  if (!in_same_order(here, there)) return false;
  for (std::size_t z = 0; z < here.size(); ++z) {
    double longest = here[z].length;
    if (z > 0) longest = std::max(longest, here[z - 1].length);
    if (z + 1 < here.size()) longest = std::max(longest, here[z + 1].length);
    const double apart = std::fabs(here[z].length - there[z].length);
    if (apart > std::max(0.5 * std::min(here[z].length, there[z].length),
                         std::exp(-std::min(nats(), other.nats()) / 2) * longest))
      return false;
  }
  return true;
}

std::optional<ZoneContact> ZoneContact::solved(const PartialSlipTask& task, const Zones& zones, double nats) {
  const auto equations = std::make_shared<ZoneEquations>(task, zones, nats);
  if (!equations->solve()) return std::nullopt;
  return ZoneContact(equations);
}

std::optional<ZoneContact> ZoneContact::solved(const PartialSlipTask& task, const ZoneContact& near,
                                               double nats) {
  const auto equations = std::make_shared<ZoneEquations>(task, near.zones(), nats);
  Eigen::VectorXd unknowns = equations->unknowns();
  unknowns << equations->mesh().unknowns_of([&](const ZoneMesh::Point& point) {
    return near.traction_at(near.mesh().point_at(equations->mesh().place(point)));
  }),
      near.leading_length(), near.creep();
  if (!equations->solve_from(unknowns)) return std::nullopt;
  return ZoneContact(equations);
}

double ZoneContact::corresponding_place(const ZoneContact& other, double e) const {
  double mine = 0, others = 0, left = 0, left_of_other = 0;
  for (std::size_t z = 0; z < zones().size(); ++z) {
    mine += zones()[z].length;
    others += other.zones()[z].length;
    const bool is_last = z + 1 == zones().size();
    if (!is_last && zones()[z].sign != 0) continue;
    if (is_last || e < others) break;
    left = mine;
    left_of_other = others;
  }
  return left + (e - left_of_other) * (mine - left) / (others - left_of_other);
}

ZoneContact::Traction ZoneContact::sum_of_terms(const ZoneMesh::Point& point, const auto& of_term) const {
  Traction sum{0, 0};
  for (const ZoneMesh::Share& share : mesh().shares(point)) {
    const double unknown = equations_->unknowns()(share.unknown);
    sum.pressure += of_term(share.pressure * unknown);
    sum.shear += of_term(share.shear * unknown);
  }
  return sum;
}

ZoneContact::Traction ZoneContact::traction_at(const ZoneMesh::Point& point) const {
  return sum_of_terms(point, std::identity());
}

ZoneContact::Traction ZoneContact::sizes_at(double e) const {
  if (!(e > 0 && e < length())) return {0, 0};
  return sum_of_terms(mesh().point_at(e), [](double term) { return std::fabs(term); });
}

double ZoneContact::moment() const {
  return (forces_.normal * (leading_length() - equations_->places(mesh().nodes()))).sum();
}

ZoneContact::Traction ZoneContact::traction(double e) const {
  if (!(e > 0 && e < length())) return {0, 0};
  return traction_at(mesh().point_at(e));
}

ZoneContact::Displacement ZoneContact::displacement_under(double distance, const Traction& load) const {
  // I3/pi less its jump, whose derivative is the local term of the strains.
  const double coupling = (I3(distance) - std::copysign(equations_->task().beta * pi / 2, distance)) / pi;
  return {I1(distance) / pi * load.pressure - coupling * load.shear,
          coupling * load.pressure + I6(distance, 0) / pi * load.shear};
}

double ZoneContact::strain_under(double distance, const Traction& load) {
  constexpr auto first = data::Derivative::first;
  return vn_slope(distance, first) * load.pressure + vs_slope(distance, first) * load.shear;
}

template <class Add>
void ZoneContact::for_nodes_beyond(int panel, double e, const Add& add) const {
  for (std::size_t j = 0; j < mesh().nodes().size(); ++j) {
    // The nodes next to the trailing end are rounded to it; their weights are negligible.
    const double distance = e - mesh().place(mesh().nodes()[j]);
    const auto node = static_cast<Index>(j);
    if (mesh().nodes()[j].panel != panel && distance != 0)
      add(distance, Traction{forces_.normal(node), forces_.tangential(node)});
  }
}

double ZoneContact::strain(double e) const {
  double strain = 0;
  const auto add = [&](double distance, const Traction& load) { strain += strain_under(distance, load); };
  if (!(e > 0 && e < length())) {
    for_nodes_beyond(-1, e, add);
    return strain;
  }
  const ZoneMesh::Point point = mesh().point_at(e);
  if (mesh().sign(point) == 0) return creep();
  for (std::size_t j = 0; j < mesh().nodes().size(); ++j) {
    const ZoneMesh::Point& node = mesh().nodes()[j];
    const auto of = static_cast<Index>(j);
    if (node.panel != point.panel)
      add(mesh().distance(point, node), {forces_.normal(of), forces_.tangential(of)});
  }
  // The nodes are placed such that the place lies midway between two of them. At the place's distance e^-|s| from an
  // end of the panel, forces count that are as small in proportion.
  const double farthest = far + std::fabs(point.s);
  for (const int side : {-1, 1}) {
    for (double s = point.s + side * mesh().step() / 2; std::fabs(s) < farthest; s += side * mesh().step()) {
      const ZoneMesh::Point node{point.panel, s};
      add(mesh().distance(point, node), mesh().weight(node) * traction_at(node));
    }
  }
  return strain - equations_->task().beta * traction_at(point).pressure;
}

int ZoneContact::sign(double e) const { return mesh().sign(mesh().point_at(e)); }

double ZoneContact::start_of_zone(double e) const {
  const int zone = mesh().zone(mesh().point_at(e));
  double start = 0;
  for (int z = 0; z < zone; ++z) start += zones()[static_cast<std::size_t>(z)].length;
  return start;
}

ZoneContact::Displacement ZoneContact::displacement_by_nodes(double e, int but_of_panel) const {
  Displacement sum{0, 0};
  for_nodes_beyond(but_of_panel, e,
                   [&](double distance, const Traction& load) { sum += displacement_under(distance, load); });
  return sum;
}

ZoneContact::Displacement ZoneContact::displacement(double e) const {
  if (!(e > 0 && e < length())) return displacement_by_nodes(e, -1);
  const double normal = approach() - std::pow(leading_length() - e, 2);
  const int panel = mesh().point_at(e).panel;
  if (sign(e) == 0) {
    const double start = start_of_zone(e);
    return {normal, displacement_by_nodes(start, -1).along + creep() * (e - start)};
  }
  Displacement sum = displacement_by_nodes(e, panel);
  // The logarithm at the place needs nodes that become dense there from both sides.
  for (const double end : {mesh().place({panel, -2 * far}), mesh().place({panel, 2 * far})}) {
    const double length = std::fabs(end - e);
    for (double s = -far; length > 0 && s < far; s += mesh().step()) {
      const ZoneMesh::Point node{panel, s};
      sum += displacement_under(
          std::copysign(length * node.left, e - end),
          length * mesh().step() * node.left * node.right * traction(e + (end - e) * node.left));
    }
  }
  return {normal, sum.along};
}

double ZoneContact::dissipation() const {
  const auto term = [&](std::size_t i) {
    const Sample& sample = samples_[i];
    return sample.sign == 0 ? 0 : -sample.weight * sample.shear * sample.slip;
  };
  const auto ends_at = [&](std::size_t i, std::size_t next) {
    return next >= samples_.size() || samples_[next].point.panel != samples_[i].point.panel;
  };
  // The terms that would follow the last one of a panel are a geometric series, as those of a power of t are.
  const auto beyond = [&](std::size_t last, std::size_t before) {
    const double ratio = term(last) / term(before);
    return ratio > 0 && ratio < 1 ? term(last) * ratio / (1 - ratio) : 0;
  };
  double sum = 0;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    sum += term(i);
    if (ends_at(i, i - 1)) sum += beyond(i, i + 1);
    if (ends_at(i, i + 1)) sum += beyond(i, i - 1);
  }
  return sum;
}

std::vector<ZoneContact::Peak> ZoneContact::peaks(double Traction::*part) const {
  // Peaks are sought in s, because a peak may be very near to a boundary.
  std::vector<Peak> found;
  for (auto sample = samples_.begin(); sample != samples_.end();) {
    const int panel = sample->point.panel;
    // Next to a boundary a traction may be like A t - B t^(3/2), with a maximum at any s, also beyond the samples.
    std::vector<double> places, beyond;
    for (double s = -ZoneMesh::farthest; s < sample->point.s; ++s) places.push_back(s);
    for (; sample != samples_.end() && sample->point.panel == panel; ++sample)
      places.push_back(sample->point.s);
    for (double s = ZoneMesh::farthest; s > places.back(); --s) beyond.push_back(s);
    places.insert(places.end(), beyond.rbegin(), beyond.rend());
    // A cusp at a boundary may be like a small power of t; therefore the farthest places stand for the boundary itself.
    const auto size_at = [&](double s) {
      if (std::fabs(s) >= ZoneMesh::farthest) s = std::copysign(std::numeric_limits<double>::infinity(), s);
      return std::fabs(traction_at({panel, s}).*part);
    };
    for (const LocalMaximum& maximum : local_maxima(size_at, places)) {
      const ZoneMesh::Point point{panel, maximum.place};
      found.push_back({maximum.value, mesh().place(point), point});
    }
  }
  return found;
}

double ZoneContact::slope(const ZoneMesh::Point& point, double Traction::*part) const {
  // Tractions are analytic for |Im s| < pi.
  constexpr double reach = 1;
  static const LocalSlope local_slope;
  const auto at = [&](double s) { return traction_at({point.panel, s}).*part; };
  return std::copysign(1, at(point.s)) * local_slope(at, point.s, reach);
}

double ZoneContact::place_of(const Peak& peak, double Traction::*part) const {
  constexpr double found_to = 1e-3;
  constexpr int bits = 48;
  const auto slope_at = [&](double s) { return slope(ZoneMesh::Point{peak.point.panel, s}, part); };
  const double left = peak.point.s - found_to, right = peak.point.s + found_to;
  const double before = slope_at(left), after = slope_at(right);
  if (!(before > 0 && after < 0)) return peak.e;
  std::uintmax_t most = 100;
  const auto [low, high] = boost::math::tools::toms748_solve(
      slope_at, left, right, before, after, boost::math::tools::eps_tolerance<double>(bits), most);
  return mesh().place({peak.point.panel, (low + high) / 2});
}

}  // namespace nipref::fast
