#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/fast/partial_slip/internal/zone_mesh.hpp>

namespace nipref::fast {
namespace {

using std::numbers::pi;

/// Half-thicknesses: the kernels less their Cauchy parts are analytic for |Im alpha| < 2.
constexpr double longest_panel = 3;
/// Of s: e^-72 of a panel from its end.
constexpr double farthest = 72;

/// Steps from 0 to 1, flat at both.
double smooth_step(double x) { return x * x * (3 - 2 * x); }

double interpolation_weight(double steps, double window) {
  if (steps == 0) return 1;
  return std::sin(pi * steps) / (pi * steps) * std::exp(-steps * steps / (2 * window * window));
}

}  // namespace

ZoneMesh::ZoneMesh(const std::vector<Zone>& zones, const PartialSlipTask& task, double nats)
    // 0.7 of the frequencies below Nyquist's pass to erfc(0.3 pi window/sqrt 2), about e^(-2 nats).
    : step_(0.7 * pi * pi / nats), window_(2 * std::sqrt(nats) / (0.3 * pi)), friction_(task.friction) {
  cut(zones);
  set_ends(task, nats);
  number();
  measure_gaps();
}

void ZoneMesh::measure_gaps() {
  gaps_.assign(panels_.size(), std::vector<double>(panels_.size(), 0.0));
  for (std::size_t a = 0; a < panels_.size(); ++a)
    for (std::size_t b = a + 2; b < panels_.size(); ++b)
      gaps_[a][b] = gaps_[a][b - 1] + panels_[b - 1].length;
}

void ZoneMesh::cut(const std::vector<Zone>& zones) {
  for (std::size_t z = 0; z < zones.size(); ++z) {
    const int parts = std::max(1, static_cast<int>(std::ceil(zones[z].length / longest_panel)));
    const auto sign_of = [&](std::size_t zone) { return zone < zones.size() ? zones[zone].sign : 0; };
    for (int part = 0; part < parts; ++part) {
      panels_.push_back({static_cast<int>(z),
                         zones[z].sign,
                         part,
                         parts,
                         zones[z].length / parts,
                         {},
                         {},
                         0,
                         0,
                         0,
                         0,
                         static_cast<double>(sign_of(z - 1)),
                         static_cast<double>(sign_of(z + 1))});
    }
  }
}

void ZoneMesh::stretch_to(const std::vector<Zone>& zones) {
  for (Panel& panel : panels_) panel.length = zones[at(panel.zone)].length / panel.parts;
  measure_gaps();
}

void ZoneMesh::set_ends(const PartialSlipTask& task, double nats) {
  for (std::size_t k = 0; k < panels_.size(); ++k) {
    panels_[k].left = end(k, false, task, nats);
    panels_[k].right = end(k, true, task, nats);
  }
}

ZoneMesh::PanelEnd ZoneMesh::end(std::size_t panel, bool is_right, const PartialSlipTask& task,
                                 double nats) const {
  const auto shift = [&](int sign) { return std::atan(task.beta * task.friction * sign) / pi; };
  const Panel& own = panels_[panel];
  const bool at_end = is_right ? panel + 1 == panels_.size() : panel == 0;
  // What the powers leave out is smaller than they are by t.
  PanelEnd result{1, 1, 0.9 * nats, -1, -1, false};
  if (at_end) {
    result.pressure_power = result.shear_power = 0.5 + (is_right ? 1 : -1) * shift(own.sign);
    // The zone of slip at the end, which is left out where it is shorter than the accuracy, shall be seen.
    if (own.sign == 0 && task.beta > 0) result.reach = nats;
    return result;
  }
  const Panel& other = panels_[is_right ? panel + 1 : panel - 1];
  const double next_to_shorter = std::max(0.0, std::log(own.length / other.length));
  const bool sticks_then_slips = other.zone != own.zone && (own.sign == 0) == is_right;
  if (!sticks_then_slips) result.reach = smooth_reach(nats);
  result.reach += next_to_shorter;
  if (other.zone == own.zone) return result;
  const double a = shift(own.sign + other.sign);
  if (sticks_then_slips)
    result.pressure_power = result.shear_power = 0.5 - a;
  else
    result.shear_power = 1.5 + a;
  result.extra = own.sign == 0 && !sticks_then_slips;
  return result;
}

double ZoneMesh::smooth_reach(double nats) { return std::min(0.9 * nats, 16.0); }

void ZoneMesh::number() {
  const int beyond = nodes_beyond();
  for (std::size_t k = 0; k < panels_.size(); ++k) {
    Panel& panel = panels_[k];
    const int index = static_cast<int>(k);
    panel.first_node = -static_cast<int>(std::ceil(panel.left.reach / step_));
    panel.last_node = static_cast<int>(std::ceil(panel.right.reach / step_));
    for (int j = panel.first_node - beyond; j <= panel.last_node + beyond; ++j)
      nodes_.push_back({index, j * step_});
    for (int j = panel.first_node - (panel.left.extra ? 1 : 0); j <= panel.last_node + 1; ++j) {
      midpoints_.push_back({index, (j - 0.5) * step_});
      extra_.push_back(j < panel.first_node);
    }
    const int count = panel.last_node - panel.first_node + 1;
    panel.pressure = unknowns_;
    panel.shear = unknowns_ + count;
    unknowns_ += panel.sign == 0 ? 2 * count : count;
  }
  for (std::size_t k = 1; k < panels_.size(); ++k) {
    panels_[k].left.value = panels_[k - 1].right.value = unknowns_++;
    if (panels_[k].zone == panels_[k - 1].zone && panels_[k].sign == 0)
      panels_[k].left.shear_value = panels_[k - 1].right.shear_value = unknowns_++;
  }
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

double ZoneMesh::extent(int zone, const Point& point) const {
  const Panel& own = panels_[at(point.panel)];
  if (own.zone == zone) return own.length * (own.part + point.left);
  double sum = 0;
  if (zone < own.zone)
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

int ZoneMesh::nodes_beyond() const { return static_cast<int>(std::ceil(16 / step_)); }

void ZoneMesh::add_hats(const Panel& panel, const Point& point, Shares& shares) const {
  // The first and the last of all nodes stand for what would follow: sum_k e^(-k h).
  const bool is_last = std::round(point.s / step_) == panel.last_node + nodes_beyond() ||
                       std::round(point.s / step_) == panel.first_node - nodes_beyond();
  const double rest = is_last ? 1 / (1 - std::exp(-step_)) : 1;
  for (const auto& [end, shape] :
       {std::pair(&panel.left, point.right), std::pair(&panel.right, point.left)}) {
    if (end->value >= 0) shares.push_back({end->value, rest * shape, 0});
    if (end->shear_value >= 0) shares.push_back({end->shear_value, 0, rest * smooth_step(shape)});
  }
}

void ZoneMesh::add_node(const Panel& panel, int node, double factor, Shares& shares) const {
  const int nearest = std::clamp(node, panel.first_node, panel.last_node);
  const PanelEnd& end = node < nearest ? panel.left : panel.right;
  const double beyond = std::abs(node - nearest) * step_;
  const int number = nearest - panel.first_node;
  shares.push_back({panel.pressure + number, factor * std::exp(-end.pressure_power * beyond), 0});
  if (panel.sign == 0)
    shares.push_back({panel.shear + number, 0, factor * std::exp(-end.shear_power * beyond)});
}

void ZoneMesh::add_shear_of_step(const Panel& panel, const Point& point, Shares& shares) const {
  const double sign = panel.sign != 0 ? panel.sign
                                      : panel.from + (panel.to - panel.from) *
                                                         smooth_step((panel.part + point.left) / panel.parts);
  for (Share& share : shares) share.shear += friction_ * sign * share.pressure;
}

ZoneMesh::Shares ZoneMesh::shares(const Point& point) const {
  const Panel& panel = panels_[at(point.panel)];
  Shares shares;
  add_hats(panel, point, shares);
  const double steps = point.s / step_;
  const int nearest = static_cast<int>(std::lround(steps));
  if (std::fabs(steps - nearest) < 1e-9) {
    add_node(panel, nearest, 1, shares);
  } else {
    // Here the Gaussian has fallen to e^(-2 nats), too.
    const int most = static_cast<int>(std::ceil(0.3 * pi * window_ * window_));
    for (int j = nearest - most; j <= nearest + most; ++j)
      add_node(panel, j, interpolation_weight(steps - j, window_), shares);
  }
  add_shear_of_step(panel, point, shares);
  return shares;
}

}  // namespace nipref::fast
