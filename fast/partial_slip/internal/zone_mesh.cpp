#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/fast/partial_slip/internal/zone_mesh.hpp>

namespace nipref::fast {
namespace {

using std::numbers::pi;

/// Half-thicknesses. The kernels less their Cauchy parts are analytic for |Im alpha| < 2, or |Im s| < 2 atan(4/length)
/// from the middle of a panel. For a length of 4 this is pi/2, with which the rule of this step has the error e^-nats.
constexpr double longest_panel = 4;

/// a of the powers of t, times the sign of the slip.
double shift_of_power(int sign, const PartialSlipTask& task) {
  return std::atan(task.beta * task.friction * sign) / pi;
}

/// A step from 0 to 1, flat at both ends; it begins like x^2.
double smooth_step(double x) { return x * x * (3 - 2 * x); }

}  // namespace

ZoneMesh::ZoneMesh(const Zones& zones, const PartialSlipTask& task, double nats)
    : nats_(nats), step_(pi * pi / nats), friction_(task.friction) {
  cut(zones);
  set_ends(task);
  number_unknowns();
  measure_gaps();
  at_nodes_ = rows(nodes_.size(), [this](std::size_t i) { return nodes_[i]; });
  at_midpoints_ = rows(midpoints_.size(), [this](std::size_t i) { return midpoints_[i]; });
}

void ZoneMesh::measure_gaps() {
  gaps_.assign(panels_.size(), std::vector<double>(panels_.size(), 0.0));
  for (std::size_t a = 0; a < panels_.size(); ++a)
    for (std::size_t b = a + 2; b < panels_.size(); ++b)
      gaps_[a][b] = gaps_[a][b - 1] + panels_[b - 1].length;
}

void ZoneMesh::cut(const Zones& zones) {
  for (std::size_t z = 0; z < zones.size(); ++z) {
    const int panels = std::max(1, static_cast<int>(std::ceil(zones[z].length / longest_panel)));
    const auto sign_of = [&](std::size_t zone) { return zone < zones.size() ? zones[zone].sign : 0; };
    for (int number = 0; number < panels; ++number) {
      panels_.push_back({.zone = static_cast<int>(z),
                         .sign = zones[z].sign,
                         .number_in_zone = number,
                         .panels_of_zone = panels,
                         .length = zones[z].length / panels,
                         .sign_before = static_cast<double>(sign_of(z - 1)),
                         .sign_after = static_cast<double>(sign_of(z + 1))});
    }
  }
}

void ZoneMesh::stretch_to(const Zones& zones) {
  for (Panel& panel : panels_) panel.length = zones[at(panel.zone)].length / panel.panels_of_zone;
  measure_gaps();
}

void ZoneMesh::set_ends(const PartialSlipTask& task) {
  for (std::size_t k = 0; k < panels_.size(); ++k) {
    Panel& panel = panels_[k];
    panel.left = end(k, false, task);
    panel.right = end(k, true, task);
    const auto nodes_to = [&](double s) { return static_cast<int>(std::ceil(s / step_)); };
    panel.first_node = -nodes_to(panel.left.reach);
    panel.last_node = nodes_to(panel.right.reach);
    panel.first_of_all = -nodes_to(panel.left.depth);
    panel.last_of_all = nodes_to(panel.right.depth);
    panel.first_checked = -nodes_to(panel.left.checked) - 1;
    panel.last_checked = nodes_to(panel.right.checked) + 1;
  }
}

ZoneMesh::PanelEnd ZoneMesh::end(std::size_t panel, bool is_right, const PartialSlipTask& task) const {
  const bool is_of_contact = is_right ? panel + 1 == panels_.size() : panel == 0;
  const Panel& own = panels_[panel];
  return is_of_contact ? end_of_contact(own, is_right, task)
                       : boundary(own, panels_[is_right ? panel + 1 : panel - 1], is_right, task);
}

ZoneMesh::TractionEnd ZoneMesh::traction_end(const Tail::Powers& powers, double reach) const {
  // In the last node the envelope is e^(-0.2 nats) or more. Next to a boundary where slip turns into stick it is about
  // t^(1/2), and the error of the interpolation is that of a boundary which is wrong by e^-nats. A smaller envelope
  // would carry errors of the tractions there to the other nodes.
  const double least = powers.minCoeff(), of_envelope = std::min(least, 0.2 * smooth_nats() / reach);
  return {least, of_envelope, Tail(powers - of_envelope, step_)};
}

ZoneMesh::PanelEnd ZoneMesh::end_of_contact(const Panel& own, bool is_right,
                                            const PartialSlipTask& task) const {
  PanelEnd end;
  const double power = 0.5 + (is_right ? 1 : -1) * shift_of_power(own.sign, task);
  // At `reach` the first power that the tail leaves out, with the tail's factor e^6, is e^-nats. Where the end sticks,
  // nodes up to nats show a missing zone of slip, which is left out if it is shorter than the accuracy.
  end.reach = own.sign == 0 && task.beta > 0 ? nats_ : (nats_ + 6) / (power + 4);
  end.pressure = end.shear = traction_end({power, power + 1, power + 2, power + 3}, end.reach);
  end.depth = (nats_ + 1.5 * end.reach) / (1 + power);
  // Where slip turns around nearer to the end than this, zones that are left out change the creep by less than e^-nats.
  end.checked = std::max(nats_, 1.25 * end.reach);
  return end;
}

ZoneMesh::PanelEnd ZoneMesh::boundary(const Panel& own, const Panel& other, bool is_right,
                                      const PartialSlipTask& task) const {
  PanelEnd end;
  // At `reach` the first power that a tail leaves out, with the tail's factor, e^3 for powers 1/2 apart, is e^-nats.
  // The place of a boundary where slip turns into stick is determined by the absence of t^(1/2 + a). Its error is the
  // ratio of t^3, which is left out, to this power. As |a| < 1/2, it falls like e^(-2 nats/3) or faster.
  if (other.zone == own.zone) {
    end.reach = (nats_ + 6) / 5;
    end.pressure = end.shear = traction_end({1, 2, 3, 4}, end.reach);
  } else {
    const bool sticks_then_slips = (own.sign == 0) == is_right;
    const double a = shift_of_power(own.sign + other.sign, task),
                 power = sticks_then_slips ? 0.5 - a : 1.5 + a;
    end.reach = sticks_then_slips ? (nats_ + 3) / (power + 2) : (smooth_nats() + 3) / 3;
    end.shear = traction_end({power, power + 1, 2, sticks_then_slips ? power + 2 : 3}, end.reach);
    end.pressure = traction_end({1, power, power + 1, 2}, end.reach);
    end.has_extra_equation = own.sign == 0 && !sticks_then_slips;
  }
  // At the last unknown, t_0 = e^-reach, a shift of the boundary by e^-nats changes tractions by e^-nats t_0^(1/2). So
  // do forces beyond `depth`, t^(1 + least power), by Cauchy's kernel 1/t_0, and those of the boundary's value, for
  // which the last node stands with a first moment that is wrong by t^2, by the derivative 1/t_0^2.
  end.depth =
      std::max((nats_ + 1.5 * end.reach) / (1 + end.pressure.least_power), nats_ / 2 + 1.25 * end.reach);
  end.next_length = std::min(1.0, other.length / own.length);
  end.reach -= std::log(end.next_length);
  end.depth -= std::log(end.next_length);
  // Beyond this, t = e^(-1.25 reach), zones that are left out have the forces t^(1 + power), or between panels of a
  // zone t^3, as the shear there exceeds friction by the square of their length. Up to 45 nats both are less than
  // e^(-2 nats/3).
  end.checked = 1.25 * end.reach;
  return end;
}

void ZoneMesh::number_unknowns() {
  for (std::size_t k = 0; k < panels_.size(); ++k) {
    Panel& panel = panels_[k];
    const int count = panel.last_node - panel.first_node + 1;
    panel.pressure = unknowns_;
    panel.shear = unknowns_ + count;
    unknowns_ += panel.sign == 0 ? 2 * count : count;
    add_points(panel, static_cast<int>(k));
  }
  for (std::size_t k = 1; k < panels_.size(); ++k) {
    panels_[k].left.value = panels_[k - 1].right.value = unknowns_++;
    if (panels_[k].zone == panels_[k - 1].zone && panels_[k].sign == 0)
      panels_[k].left.shear_value = panels_[k - 1].right.shear_value = unknowns_++;
  }
}

void ZoneMesh::add_points(const Panel& panel, int index) {
  for (int j = panel.first_of_all; j <= panel.last_of_all; ++j) nodes_.push_back({index, j * step_});
  const int first = panel.first_node - (panel.left.has_extra_equation ? 1 : 0);
  for (int j = panel.first_checked; j <= panel.last_checked; ++j) {
    const bool is_before_end = j <= panel.last_node + 1;
    midpoints_.push_back({{index, (j - 0.5) * step_},
                          j >= panel.first_node && is_before_end,
                          panel.sign == 0 && j >= first && is_before_end});
  }
}

ZoneMesh::Rows ZoneMesh::rows(std::size_t count, const auto& point) const {
  std::vector<Eigen::Triplet<double>> pressure, shear;
  for (std::size_t i = 0; i < count; ++i) {
    for (const Share& share : shares(point(i))) {
      pressure.emplace_back(i, share.unknown, share.pressure);
      shear.emplace_back(i, share.unknown, share.shear);
    }
  }
  Rows rows{{static_cast<long>(count), unknowns_}, {static_cast<long>(count), unknowns_}};
  rows.pressure.setFromTriplets(pressure.begin(), pressure.end());
  rows.shear.setFromTriplets(shear.begin(), shear.end());
  return rows;
}

Eigen::VectorXd ZoneMesh::unknowns_of(const std::function<Traction(const Point&)>& traction) const {
  Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(unknowns_);
  // Sets an unknown such that it adds what the unknowns set before it leave of a traction.
  const auto set = [&](int unknown, const Point& point, double whole, double Share::*part) {
    double of_one = 0;
    for (const Share& share : shares(point)) {
      if (share.unknown == unknown)
        of_one += share.*part;
      else
        whole -= share.*part * unknowns(share.unknown);
    }
    unknowns(unknown) = whole / of_one;
  };
  const auto set_both = [&](const Point& point, int pressure, int shear) {
    const Traction whole = traction(point);
    set(pressure, point, whole.pressure, &Share::pressure);
    if (shear >= 0) set(shear, point, whole.shear, &Share::shear);
  };
  for (std::size_t k = 1; k < panels_.size(); ++k)
    set_both({static_cast<int>(k), -farthest}, panels_[k].left.value, panels_[k].left.shear_value);
  for (std::size_t k = 0; k < panels_.size(); ++k) {
    const Panel& panel = panels_[k];
    for (int j = panel.first_node; j <= panel.last_node; ++j) {
      const int number = j - panel.first_node;
      set_both({static_cast<int>(k), j * step_}, panel.pressure + number,
               panel.sign == 0 ? panel.shear + number : -1);
    }
  }
  return unknowns;
}

double ZoneMesh::weight(const Point& point) const {
  return step_ * panels_[at(point.panel)].length * point.left * point.right;
}

double ZoneMesh::distance(const Point& a, const Point& b) const {
  if (a.panel > b.panel) return -distance(b, a);
  const double length = panels_[at(a.panel)].length;
  if (a.panel == b.panel) return length * (a.power - b.power) * a.right * b.right;
  return -(length * a.right + gaps_[at(a.panel)][at(b.panel)] + panels_[at(b.panel)].length * b.left);
}

void ZoneMesh::set_cauchy_kernels(Eigen::MatrixXd& kernels) const {
  const auto of_midpoints = [&](double Point::*part) {
    return Eigen::ArrayXd::NullaryExpr(std::ssize(midpoints_),
                                       [&](Eigen::Index i) { return midpoints_[at(i)].*part; })
        .eval();
  };
  const Eigen::ArrayXd power = of_midpoints(&Point::power), left = of_midpoints(&Point::left),
                       right = of_midpoints(&Point::right);
  kernels.resize(std::ssize(midpoints_), std::ssize(nodes_));
  for (std::size_t a = 0; a < panels_.size(); ++a) {
    const auto own = std::ranges::equal_range(midpoints_, static_cast<int>(a), {}, &Midpoint::panel);
    const auto rows = Eigen::seqN(own.begin() - midpoints_.begin(), std::ssize(own));
    const double length = panels_[a].length;
    for (Eigen::Index j = 0; j < kernels.cols(); ++j) {
      const Point& node = nodes_[at(j)];
      const std::size_t b = at(node.panel);
      const double nodes_length = panels_[b].length;
      auto column = kernels.col(j)(rows).array();
      if (a == b)
        column = -1 / ((pi * length * node.right) * (power(rows) - node.power) * right(rows));
      else if (a < b)
        column = 1 / (pi * length * right(rows) + pi * (gaps_[a][b] + nodes_length * node.left));
      else
        column = -1 / (pi * length * left(rows) + pi * (gaps_[b][a] + nodes_length * node.right));
    }
  }
}

double ZoneMesh::from_end(const Point& point, bool right) const {
  const Panel& own = panels_[at(point.panel)];
  return own.length * (right ? own.panels_of_zone - own.number_in_zone - 1 + point.right
                             : own.number_in_zone + point.left);
}

double ZoneMesh::extent(int zone, const Point& point) const {
  const int own = this->zone(point);
  if (own == zone) return from_end(point, false);
  double sum = 0;
  if (zone < own)
    for (const Panel& panel : panels_) sum += panel.zone == zone ? panel.length : 0;
  return sum;
}

double ZoneMesh::place(const Point& point) const {
  double start = 0;
  for (int k = 0; k < point.panel; ++k) start += panels_[at(k)].length;
  return start + panels_[at(point.panel)].length * point.left;
}

ZoneMesh::Point ZoneMesh::point_at(double e) const {
  std::size_t k = 0;
  while (k + 1 < panels_.size() && e > panels_[k].length) e -= panels_[k++].length;
  return {static_cast<int>(k),
          std::clamp(std::log(e / std::max(panels_[k].length - e, 0.0)), -farthest, farthest)};
}

double ZoneMesh::hat_factor(const Panel& panel, const Point& point) const {
  const bool is_last = point.s == panel.first_of_all * step_ || point.s == panel.last_of_all * step_;
  return is_last ? 1 / (1 - std::exp(-step_)) : 1;
}

ZoneMesh::Traction ZoneMesh::envelope(const Panel& panel, const Point& point) {
  const auto fall = [](const PanelEnd& end, double t) {
    return end.is_of_contact() ? t : t / (t + end.next_length);
  };
  const double left = fall(panel.left, point.left), right = fall(panel.right, point.right);
  const auto of_powers = [&](TractionEnd PanelEnd::*part) {
    return std::pow(left, (panel.left.*part).envelope_power) *
           std::pow(right, (panel.right.*part).envelope_power);
  };
  return {of_powers(&PanelEnd::pressure), of_powers(&PanelEnd::shear)};
}

void ZoneMesh::add_hats(const Panel& panel, const Point& point, Shares& shares) const {
  const double factor = hat_factor(panel, point);
  const auto add = [&](const PanelEnd& end, const PanelEnd& other, double from_other) {
    if (end.value >= 0) shares.push_back({end.value, factor * std::pow(from_other, other.hat_power()), 0});
    if (end.shear_value >= 0)
      shares.push_back({end.shear_value, 0, factor * std::pow(from_other, other.shear.least_power)});
  };
  add(panel.left, panel.right, point.right);
  add(panel.right, panel.left, point.left);
}

void ZoneMesh::add_nodes(const Panel& panel, const Point& point, Shares& shares) const {
  const double steps = point.s / step_;
  const Traction size = envelope(panel, point);
  const auto add = [&](int node, double pressure, double shear) {
    const int number = node - panel.first_node;
    shares.push_back({panel.pressure + number, size.pressure * pressure, 0});
    if (panel.sign == 0) shares.push_back({panel.shear + number, 0, size.shear * shear});
  };
  const auto add_tail = [&](const PanelEnd& end, int last, int inwards, const auto& parts_of) {
    const Tail::Parts pressure = parts_of(end.pressure.tail), shear = parts_of(end.shear.tail);
    for (int k = 0; k < Tail::terms; ++k)
      add(last + k * inwards * end.pressure.tail.spacing(), pressure(k), shear(k));
  };
  const double before = panel.first_node - steps, beyond = steps - panel.last_node;
  if (before > 0)
    return add_tail(panel.left, panel.first_node, 1, [&](const Tail& tail) { return tail.parts(before); });
  if (beyond > 0)
    return add_tail(panel.right, panel.last_node, -1, [&](const Tail& tail) { return tail.parts(beyond); });
  if (steps == std::round(steps)) return add(static_cast<int>(steps), 1, 1);
  const auto nearest = static_cast<int>(std::lround(steps));
  const double sine = std::sin(pi * (steps - nearest)) / pi;
  for (int node = panel.first_node; node <= panel.last_node; ++node) {
    const double sinc = ((node - nearest) % 2 == 0 ? sine : -sine) / (steps - node);
    add(node, sinc, sinc);
  }
  add_tail(panel.left, panel.first_node, 1, [&](const Tail& tail) { return tail.sinc_sum(-before); });
  add_tail(panel.right, panel.last_node, -1, [&](const Tail& tail) { return tail.sinc_sum(-beyond); });
}

void ZoneMesh::add_shear_of_step(const Panel& panel, const Point& point, Shares& shares) const {
  const double place_in_zone = (panel.number_in_zone + point.left) / panel.panels_of_zone;
  const double of_step =
      panel.sign_before + (panel.sign_after - panel.sign_before) * smooth_step(place_in_zone);
  const double sign = panel.sign != 0 ? panel.sign : of_step;
  for (Share& share : shares) share.shear += friction_ * sign * share.pressure;
}

ZoneMesh::Shares ZoneMesh::shares(const Point& point) const {
  const Panel& panel = panels_[at(point.panel)];
  Shares shares;
  add_hats(panel, point, shares);
  if (std::isfinite(point.s)) add_nodes(panel, point, shares);  // at an end itself tractions are its values
  add_shear_of_step(panel, point, shares);
  return shares;
}

}  // namespace nipref::fast
