#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>
#include <nipref/fast/partial_slip/internal/plain_zones.hpp>
#include <nipref/fast/partial_slip/internal/slope_kernels.hpp>

namespace nipref::fast {
namespace {

using Eigen::ArrayXd, Eigen::MatrixXd, Eigen::VectorXd;

/// The tractions of a contact of a given length at the nodes of the Gauss-Chebyshev rule for functions like the square
/// root of the distance from both ends, e = L sin^2(theta/2), theta = pi k/(n + 1), k = 1 to n. The equations hold
/// midway between the nodes in theta, where the rule is as accurate for Cauchy's kernel as for a smooth function. The
/// equation of u' determines the pressures p = p0 + P q for any shear q, so that the strains are v' = v0 + V q. An
/// element is the part about a node. Its sign is that of the shear if it slips, 0 if it sticks.
class Elements {
 public:
  Elements(const PartialSlipTask& task, double length, int count)
      : task_(task), count_(count), length_(length), signs_(static_cast<std::size_t>(count)) {
    const double step = std::numbers::pi / (count + 1);
    const ArrayXd angles = ArrayXd::LinSpaced(count, step, count * step),
                  edges = length *
                          ArrayXd::LinSpaced(count + 1, step / 4, (count + 0.5) * step / 2).sin().square(),
                  nodes = length * (angles / 2).sin().square();
    weights_ = length / 2 * step * angles.sin();
    const MatrixXd forces = weights_.asDiagonal(), none = MatrixXd::Zero(count, count);
    const SlopeKernels rests(length, edges, nodes);
    const auto [normal_rest, coupling_rest] = rests.values(forces, none);
    const MatrixXd along_rest = rests.values(none, forces).along;
    MatrixXd normal(count + 1, count + 1), coupling = coupling_rest, along(count + 1, count);
    for (int i = 0; i < count; ++i) {
      const VectorXd cauchy = -weights_(i) / (std::numbers::pi * (edges - nodes(i)));
      normal.col(i) = normal_rest.col(i) + cauchy;
      along.col(i) = along_rest.col(i) + cauchy;
      coupling.col(i).segment(i, 2).array() -= task.beta / 2;
    }
    normal.col(count).setConstant(-2);  // times L1
    MatrixXd right(count + 1, count + 1);
    right << coupling, -2 * edges.matrix();
    const MatrixXd pressures = Elimination(std::move(normal)).solve_columns(right);
    pressure_by_shear_ = pressures.topLeftCorner(count, count);
    pressure_without_ = pressures.col(count).head(count);
    strain_by_shear_ = along + product(coupling, pressure_by_shear_);
    strain_without_ = coupling * pressure_without_;
    edges_ = edges;
    edges_(0) = 0;
    edges_(count) = length;
  }

  /// Changes signs until none violates its condition, from `signs` and, if no creep is given, from `creep`.
  void settle(const std::vector<int>& signs, double creep) {
    least_creep_ = sliding(-1).minCoeff();
    most_creep_ = sliding(1).maxCoeff();
    for (std::size_t i = 0; i < signs_.size(); ++i) signs_[i] = signs[i * signs.size() / signs_.size()];
    creep_ = task_.creep ? *task_.creep : creep;
    is_settled_ = task_.creep ? settles_anyhow() : settles_for_traction();
  }
  [[nodiscard]] bool is_settled() const { return is_settled_; }
  [[nodiscard]] const std::vector<int>& signs() const { return signs_; }
  [[nodiscard]] double creep() const { return creep_; }
  /// The place where an element begins and the one before it ends.
  [[nodiscard]] double edge(int element) const { return edges_(element); }

  /// The zones if friction is so little that the sheet sticks in short zones alone, where slip turns around. Elements
  /// then have a mean of both signs. The signs determine the shears, these the slip, and this the signs. Nothing if
  /// this does not end or zones of stick are not short.
  std::optional<Zones> slipping() {
    constexpr int most_changes = 10;
    constexpr double tolerance = 1e-6;
    shear_ = VectorXd::Zero(count_);
    for (int change = 0; change < most_changes; ++change) {
      pressure_ = pressure_without_ + pressure_by_shear_ * shear_;
      slip_ = strain_without_ + strain_by_shear_ * shear_;
      slip_.array() -= task_.creep ? *task_.creep : slipping_creep();
      const VectorXd before = std::exchange(shear_, slipping_shear(0));
      const Zones zones = zones_of(turns(0));
      for (std::size_t k = 1; k + 1 < zones.size(); k += 2)
        if (!(4 * zones[k].length < std::min(zones[k - 1].length, zones[k + 1].length))) return std::nullopt;
      if ((shear_ - before).lpNorm<1>() < tolerance * task_.friction * pressure_.lpNorm<1>()) return zones;
    }
    return std::nullopt;
  }

 private:
  /// The length l of a zone of stick with little friction, if s' is the slope of the slip without it, q = mu p sign(s')
  /// before the zone and -mu p sign(s') behind it. A shear q causes a pressure p with H p = beta q, and the slip
  /// -H q - beta p, where H q = (1/pi) int q/(e - e') de' and H H = -1: together the slip -(1 - beta^2) H q. Therefore
  /// (1 - beta^2) H q' = s' in the zone, and q' is bounded where the zone begins. At the distance x from there
  /// q' = -4 mu p sign(s')/(pi l) (x/(l - x))^(1/2), with l = (1 - beta^2) 4 mu p/(pi |s'|).
  [[nodiscard]] double length_of_turn(int element, double slope) const {
    return (1 - task_.beta * task_.beta) * 4 * task_.friction * pressure_(element) /
           (std::numbers::pi * std::fabs(slope));
  }

  /// Where slip is `limit`, in steps of theta, which are i + 1/2 to i + 3/2 in element i.
  struct Turns {
    int first_sign;  ///< of the shear at the leading end
    std::vector<double> places;
  };
  [[nodiscard]] Turns turns(double limit) const {
    Turns turns{slip_(0) > limit ? -1 : 1, {}};
    for (int i = 0; i < count_; ++i)
      if ((slip_(i) > limit) != (slip_(i + 1) > limit))
        turns.places.push_back(i + 0.5 + (limit - slip_(i)) / (slip_(i + 1) - slip_(i)));
    return turns;
  }
  /// The shears if slip turned around where it is `limit` now.
  [[nodiscard]] VectorXd slipping_shear(double limit) const {
    const auto [first_sign, places] = turns(limit);
    VectorXd shear = task_.friction * first_sign * pressure_;
    int sign = first_sign;
    for (const double place : places) {
      const auto element = std::min(static_cast<int>(place - 0.5), count_ - 1);
      const double behind = element + 1.5 - place;  // the part of the element that is behind the place
      shear(element) -= 2 * sign * behind * task_.friction * pressure_(element);
      sign = -sign;
      for (int i = element + 1; i < count_; ++i) shear(i) = task_.friction * sign * pressure_(i);
    }
    return shear;
  }
  /// The creep over the present one with which the contact has the given traction, which grows with it.
  [[nodiscard]] double slipping_creep() const {
    double least = slip_.minCoeff(), most = slip_.maxCoeff();
    constexpr int bits = 50;
    for (int bit = 0; bit < bits; ++bit) {
      const double middle = std::midpoint(least, most);
      (weights_.dot(slipping_shear(middle)) < wanted_traction() ? least : most) = middle;
    }
    return least;
  }
  /// Zones of slip with one of stick at each turn.
  [[nodiscard]] Zones zones_of(const Turns& turns) const {
    Zones zones;
    double start = 0;
    int sign = turns.first_sign;
    for (const double place : turns.places) {
      const auto i = std::min(static_cast<int>(place - 0.5), count_ - 1);
      const double half = length_of_turn(i, (slip_(i + 1) - slip_(i)) / (edges_(i + 1) - edges_(i))) / 2,
                   e = std::lerp(edges_(i), edges_(i + 1), place - i - 0.5);
      zones.push_back({e - half - start, sign});
      zones.push_back({2 * half, 0});
      start = e + half;
      sign = -sign;
    }
    zones.push_back({length_ - start, sign});
    return zones;
  }

  /// The load of the elements is not exactly a given load; the traction is to be the same share of it.
  [[nodiscard]] double wanted_traction() const {
    return task_.load ? *task_.traction / *task_.load * weights_.dot(pressure_) : *task_.traction;
  }

  /// Changes signs until none violates its condition at the present creep; returns false if this does not end.
  bool settles() {
    constexpr int most_changes = 20;
    for (int change = 0; change < most_changes; ++change) {
      solve();
      if (!change_signs()) return true;
    }
    return false;
  }
  /// settles() at `creep` or, if that does not end, at a creep nearer to the present one.
  bool settles_towards(double creep) {
    constexpr int most_halvings = 6;
    const std::vector<int> signs = signs_;
    const double from = creep_;
    for (int halving = 0; halving < most_halvings; ++halving) {
      creep_ = std::lerp(from, creep, std::ldexp(1, -halving));
      signs_ = signs;
      if (settles()) return true;
    }
    return false;
  }
  /// settles() at the present creep, from the present signs or from a creep at which all elements slip one way.
  bool settles_anyhow() {
    if (settles()) return true;
    constexpr int most_steps = 20;
    const double wanted = creep_;
    for (const int sign : {-1, 1}) {
      std::ranges::fill(signs_, sign);
      creep_ = sign < 0 ? least_creep_ : most_creep_;
      for (int step = 0; step < most_steps && settles_towards(wanted); ++step)
        if (creep_ == wanted) return true;
    }
    return false;
  }
  /// The strains if all elements slip one way. They do so at creeps beyond all of these.
  const VectorXd& sliding(int sign) {
    std::ranges::fill(signs_, sign);
    creep_ = 0;
    solve();
    return slip_;
  }

  /// Newton's method in a bracket for the creep of the given traction. The traction grows with the creep, from sliding
  /// one way to sliding the other, linearly as long as the signs stay. Elements may have several states at one creep
  /// and none with this traction; the nearest state is the result.
  bool settles_for_traction() {
    if (!settles_anyhow()) return false;
    double least = least_creep_, most = most_creep_;
    constexpr double tolerance = 1e-6;
    constexpr int most_steps = 40;
    std::vector<int> signs;
    double creep = 0, least_missing = std::numeric_limits<double>::infinity();
    for (int step = 0; step < most_steps; ++step) {
      const double of_load = task_.load ? *task_.traction / *task_.load : 0, load = weights_.dot(pressure_);
      const double missing = wanted_traction() - weights_.dot(shear_);
      if (std::fabs(missing) < least_missing) {
        signs = signs_;
        creep = creep_;
        least_missing = std::fabs(missing);
      }
      (missing > 0 ? least : most) = creep_;
      if (least_missing < tolerance * task_.friction * load) break;
      const double by_creep =
          weights_.dot(shear_by_creep_) - of_load * weights_.dot(pressure_by_shear_ * shear_by_creep_);
      const double next = creep_ + missing / by_creep;
      if (!settles_towards(next > least && next < most ? next : std::midpoint(least, most))) break;
    }
    signs_ = signs;
    creep_ = creep;
    solve();
    return true;
  }

  /// Solves for the tractions with the present signs.
  void solve() {
    MatrixXd matrix = strain_by_shear_.topRows(count_), right(count_, 2);  // without creep, and per creep
    right << -strain_without_.head(count_), VectorXd::Ones(count_);
    for (int i = 0; i < count_; ++i) {
      const double ratio = task_.friction * signs_[static_cast<std::size_t>(i)];
      if (ratio == 0) continue;
      matrix.row(i) = -ratio * pressure_by_shear_.row(i);
      matrix(i, i) += 1;
      right.row(i) << ratio * pressure_without_(i), 0;
    }
    const MatrixXd shears = Elimination(std::move(matrix)).solve_columns(right);
    ++task_.work->systems;
    task_.work->unknowns = std::max(task_.work->unknowns, count_);
    shear_by_creep_ = shears.col(1);
    shear_ = shears.col(0) + creep_ * shear_by_creep_;
    pressure_ = pressure_without_ + pressure_by_shear_ * shear_;
    slip_ = (strain_without_ + strain_by_shear_ * shear_).array() - creep_;
  }

  /// Changes signs whose conditions are violated, the last from slip to slip; false, without a change, if no other is.
  bool change_signs() {
    const std::vector<int> before = signs_;
    for (int i = 0; i < count_; ++i) {
      int& sign = signs_[static_cast<std::size_t>(i)];
      const bool is_last = i + 1 == count_;
      if (sign == 0 && (is_last || std::fabs(shear_(i)) > task_.friction * pressure_(i)))
        sign = shear_(i) > 0 ? 1 : -1;
      else if (sign * slip_(i) > 0)
        sign = is_last ? -sign : 0;
    }
    if (before.back() == 0 || !std::equal(before.begin(), before.end() - 1, signs_.begin())) return true;
    signs_ = before;
    return false;
  }

  const PartialSlipTask& task_;
  int count_;
  double length_, creep_ = 0;
  double least_creep_ = 0, most_creep_ = 0;  ///< beyond them all elements slip one way
  VectorXd weights_, edges_;
  MatrixXd pressure_by_shear_, strain_by_shear_;
  VectorXd pressure_without_, strain_without_;
  std::vector<int> signs_;
  bool is_settled_ = false;
  VectorXd pressure_, shear_, slip_, shear_by_creep_;
};

/// Settled elements. Few elements settle from any signs, more elements from the signs of half as many.
Elements settled(const PartialSlipTask& task, double length, int count) {
  constexpr int few = 30;
  Elements elements(task, length, count);
  if (count < 2 * few) {
    elements.settle({0}, 0);
  } else {
    const Elements fewer = settled(task, length, count / 2);
    elements.settle(fewer.signs(), fewer.creep());
  }
  return elements;
}

}  // namespace

double length_guess(const PartialSlipTask& task) {
  return task.length ? *task.length : 2 * half_length_guess(*task.load);
}

std::optional<Zones> slipping_zones(const PartialSlipTask& task, int elements) {
  return Elements(task, length_guess(task), elements).slipping();
}

std::optional<Zones> plain_zones(const PartialSlipTask& task, int count) {
  const Elements elements = settled(task, length_guess(task), count);
  if (!elements.is_settled()) return std::nullopt;
  // The slip of the last element shows nothing if the one before slips, or if all others stick without traction.
  std::vector<int> signs = elements.signs();
  const auto sticking = static_cast<int>(std::ranges::count(signs, 0));
  if (signs[signs.size() - 2] != 0 || (sticking == count - 1 && task.traction == 0.0))
    signs.back() = signs[signs.size() - 2];
  Zones zones;
  for (int i = 0; i < count; ++i) {
    const int sign = signs[static_cast<std::size_t>(i)];
    if (i == 0 || zones.back().sign != sign) zones.push_back({0, sign});
    zones.back().length += elements.edge(i + 1) - elements.edge(i);
  }
  // With a given traction a part of the contact sticks, if less than an element.
  if (task.traction && zones.size() == 1 && zones.front().sign != 0) {
    zones.insert(zones.begin(), {elements.edge(1) / 2, 0});
    zones.back().length -= elements.edge(1) / 2;
  }
  return zones;
}

}  // namespace nipref::fast
