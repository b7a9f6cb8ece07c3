#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <nipref/fast/nip/internal/traction_field.hpp>
#include <nipref/fast/number/internal/gauss_legendre.hpp>

namespace nipref::fast {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int halvings = 72, graded_panels = halvings + 1;
/// Of the sheet's part, in the graded part of a side and in a panel behind it.
constexpr std::size_t nodes_at_end = 24, nodes_inside = 12;

SheetStresses operator+(const SheetStresses& a, const SheetStresses& b) {
  return {a.across + b.across, a.along + b.along, a.shear + b.shear};
}
SheetStresses operator*(double factor, const SheetStresses& a) {
  return {factor * a.across, factor * a.along, factor * a.shear};
}

/// Right ends of the panels of one side: doubling from the contact's end, then of one length up to the middle.
std::vector<double> panel_ends(double half_length) {
  const double graded = std::min(half_length, 1.0);
  std::vector<double> ends;
  for (int k = halvings; k >= 0; --k) ends.push_back(std::ldexp(graded, -k));
  const double rest = half_length - graded;
  const int count = static_cast<int>(std::ceil(rest));
  for (int k = 1; k <= count; ++k) ends.push_back(graded + rest * k / count);
  ends.back() = half_length;
  return ends;
}

/// P_0 .. P_(count-1) at t.
void legendre(double t, std::span<double> values) {
  values[0] = 1;
  values[1] = t;
  for (std::size_t k = 2; k < values.size(); ++k) {
    const auto n = static_cast<double>(k);
    values[k] = ((2 * n - 1) * t * values[k - 1] - (n - 1) * values[k - 2]) / n;
  }
}

/// Q_0 .. Q_(order-1) at z in the upper half-plane or on the axis as seen from there, off +-1: forwards where they do not
/// fall much, otherwise backwards from where they have fallen.
template <std::size_t order>
std::array<std::complex<double>, order> second_kind(std::complex<double> z, std::complex<double> z_plus_1,
                                                    std::complex<double> z_minus_1) {
  using Complex = std::complex<double>;
  std::array<Complex, order> q;
  // The branch whose imaginary part falls from 0 to -pi/2 on the axis.
  const Complex first = (std::log(z_plus_1) - std::log(z_minus_1)) / 2.0;
  const Complex root = std::sqrt(z_minus_1) * std::sqrt(z_plus_1);
  const double fall = std::abs(z + root);
  if (fall < 1.3) {
    q[0] = first;
    q[1] = z * first - 1.0;
    for (std::size_t k = 1; k + 1 < order; ++k) {
      const auto n = static_cast<double>(k);
      q[k + 1] = ((2 * n + 1) * z * q[k] - n * q[k - 1]) / (n + 1);
    }
    return q;
  }
  const int start = static_cast<int>(order) + static_cast<int>(std::ceil(18 / std::log(fall)));
  Complex above = 0, here = 1e-200;
  for (int k = start; k > 0; --k) {
    const double n = k;
    if (k < static_cast<int>(order)) q[static_cast<std::size_t>(k)] = here;
    above = std::exchange(here, ((2 * n + 1) * z * here - (n + 1) * above) / n);
  }
  q[0] = here;
  const Complex scale = first / here;
  for (Complex& value : q) value *= scale;
  return q;
}

/// Where a load counts as far: its residues need near_load_end, and a cell's series over depths converge like 14^-n for
/// loads so far off.
constexpr double nearest_far = 1.5;
static_assert(nearest_far >= internal::near_load_end);

}  // namespace

TractionField::TractionField(double half_length, bool symmetric, const Traction& traction)
    : half_length_(half_length), symmetric_(symmetric) {
  sides_[1] = make_side(true, traction);
  add_smooth_nodes(true, traction);
  if (symmetric) {
    mirror();
  } else {
    sides_[0] = make_side(false, traction);
    add_smooth_nodes(false, traction);
  }
}

void TractionField::mirror() {
  sides_[0] = sides_[1];
  for (Panel& panel : sides_[0].panels) {
    for (std::size_t j = 0; j < order; ++j) {
      panel.t[j] = -panel.t[j];
      panel.shear[j] = -panel.shear[j];
      (j % 2 == 0 ? panel.shear_series : panel.pressure_series)[j] *= -1;
    }
  }
  for (Moments& moments : sides_[0].moments) {
    for (double& moment : moments.shear) moment = -moment;
  }
  smooth_[0] = smooth_[1];
  for (SmoothNode& node : smooth_[0]) node = {-node.alpha, node.pressure, -node.shear};
}

TractionField::Side TractionField::make_side(bool right, const Traction& traction) const {
  const GaussRule rule = gauss_legendre(order);
  Side side;
  double left = 0;
  std::array<std::array<double, order>, order> polynomials{};
  for (std::size_t j = 0; j < order; ++j)
    legendre(right ? 1 - 2 * rule.at[j] : 2 * rule.at[j] - 1, polynomials[j]);
  for (const double end : panel_ends(half_length_)) {
    Panel panel{};
    panel.left = left;
    panel.right = end;
    panel.width = end - left;
    for (std::size_t j = 0; j < order; ++j) {
      const FaceTraction here = traction(right, left + panel.width * rule.at[j]);
      panel.t[j] = right ? 1 - 2 * rule.at[j] : 2 * rule.at[j] - 1;
      panel.pressure[j] = 2 * rule.weight[j] * here.pressure;
      panel.shear[j] = 2 * rule.weight[j] * here.shear;
      for (std::size_t k = 0; k < order; ++k) {
        const double factor = (static_cast<double>(k) + 0.5) * polynomials[j][k];
        panel.pressure_series[k] += factor * panel.pressure[j];
        panel.shear_series[k] += factor * panel.shear[j];
      }
    }
    Moments moments{};
    for (std::size_t j = 0; j < order; ++j) {
      const double share = (left + panel.width * rule.at[j]) / end;
      double power = panel.width / 2;
      for (std::size_t m = 0; m < moment_count; ++m, power *= share) {
        moments.pressure[m] += power * panel.pressure[j];
        moments.shear[m] += power * panel.shear[j];
      }
    }
    if (!side.moments.empty()) {
      double power = 1;
      for (std::size_t m = 0; m < moment_count; ++m, power *= left / end) {
        moments.pressure[m] += power * side.moments.back().pressure[m];
        moments.shear[m] += power * side.moments.back().shear[m];
      }
    }
    side.panels.push_back(panel);
    side.moments.push_back(moments);
    left = end;
  }
  return side;
}

/// With e = w x^4 at the end, which takes the sting out of any exponent there.
void TractionField::add_smooth_nodes(bool right, const Traction& traction) {
  const auto add = [&](double e, double weight) {
    const FaceTraction here = traction(right, e);
    smooth_[right ? 1 : 0].push_back(
        {right ? half_length_ - e : e - half_length_, weight * here.pressure, weight * here.shear});
  };
  const GaussRule at_end = gauss_legendre(nodes_at_end), inside = gauss_legendre(nodes_inside);
  const double graded = std::min(half_length_, 1.0), rest = half_length_ - graded;
  for (std::size_t j = 0; j < at_end.at.size(); ++j) {
    const double x = at_end.at[j];
    add(graded * x * x * x * x, 4 * graded * x * x * x * at_end.weight[j]);
  }
  const int count = static_cast<int>(std::ceil(rest));
  for (int piece = 0; piece < count; ++piece) {
    for (std::size_t j = 0; j < inside.at.size(); ++j)
      add(graded + rest * (piece + inside.at[j]) / count, rest / count * inside.weight[j]);
  }
}

void TractionField::add_side(bool right, const std::vector<bool>& blocks, double alpha, double distance,
                             Cauchy& sum) const {
  const Side& side = sides_[right ? 1 : 0];
  const bool whole = std::ranges::find(blocks, false) == blocks.end();
  const auto graded = static_cast<std::size_t>(graded_panels);
  const double turn = right ? -1 : 1;  // along the sheet with growing distance from the end
  const Complex from_end(alpha - (right ? half_length_ : -half_length_), distance);
  const double reach = std::abs(from_end) / 4;
  const std::size_t last_in_moments = whole ? side.panels.size() : blocks[0] ? graded : 0;
  std::size_t first = 0;
  while (first < last_in_moments && side.panels[first].right <= reach) ++first;
  if (first > 0) {
    // Sum of moments over powers of the distance from the end.
    const double end = side.panels[first - 1].right;
    const Moments& moments = side.moments[first - 1];
    const Complex inverse = 1.0 / from_end, ratio = turn * end * inverse;
    Complex power = inverse;
    for (std::size_t m = 0; m < moment_count; ++m, power *= ratio) {
      const Complex slope = (static_cast<double>(m) + 1) * power * inverse;
      sum.pressure += moments.pressure[m] * power;
      sum.shear += moments.shear[m] * power;
      sum.pressure_slope += moments.pressure[m] * slope;
      sum.shear_slope += moments.shear[m] * slope;
    }
  }
  for (std::size_t i = first; i < side.panels.size(); ++i) {
    if (!blocks[i < graded ? 0 : i - graded + 1]) continue;
    const Panel& panel = side.panels[i];
    const double half = panel.width / 2;
    // From both of its ends, as its neighbours see them too.
    const auto from_break = [&](double e) {
      return e == half_length_ ? Complex(alpha, distance) : from_end - turn * e;
    };
    const Complex z = (from_end - turn * (panel.left + half)) / half;
    if (std::norm(z) > 2.6) {
      double real[4] = {}, imag[4] = {};
      for (std::size_t j = 0; j < order; ++j) {
        const double x = z.real() - panel.t[j], y = z.imag(), inverse = 1 / (x * x + y * y);
        const double re = x * inverse, im = -y * inverse, re2 = re * re - im * im, im2 = 2 * re * im;
        real[0] += panel.pressure[j] * re;
        imag[0] += panel.pressure[j] * im;
        real[1] += panel.pressure[j] * re2;
        imag[1] += panel.pressure[j] * im2;
        real[2] += panel.shear[j] * re;
        imag[2] += panel.shear[j] * im;
        real[3] += panel.shear[j] * re2;
        imag[3] += panel.shear[j] * im2;
      }
      sum.pressure += Complex(real[0], imag[0]);
      sum.pressure_slope += Complex(real[1], imag[1]) / half;
      sum.shear += Complex(real[2], imag[2]);
      sum.shear_slope += Complex(real[3], imag[3]) / half;
      continue;
    }
    // At a panel's end its logarithm and its neighbour's cancel.
    constexpr double beside_break = 1e-40;
    Complex from_left = from_break(right ? panel.right : panel.left);
    Complex from_right = from_break(right ? panel.left : panel.right);
    if (from_left == 0.0) from_left = {0, beside_break};
    if (from_right == 0.0) from_right = {0, beside_break};
    const auto q = second_kind<order>(z, from_left / half, from_right / half);
    const Complex over = half / from_left * (half / from_right);
    for (std::size_t k = 0; k < order; ++k) {
      const auto n = static_cast<double>(k);
      // -Q_k'
      const Complex slope = (k == 0 ? Complex(1) : n * (q[k - 1] - z * q[k])) * over * (2 / half);
      sum.pressure += panel.pressure_series[k] * 2.0 * q[k];
      sum.pressure_slope += panel.pressure_series[k] * slope;
      sum.shear += panel.shear_series[k] * 2.0 * q[k];
      sum.shear_slope += panel.shear_series[k] * slope;
    }
  }
}

TractionField::Blocks TractionField::all_blocks() const {
  Blocks all;
  for (const int side : {0, 1})
    all.of_side[side].assign(sides_[side].panels.size() - graded_panels + 1, true);
  return all;
}

TractionField::Blocks TractionField::blocks_near(double left, double right) const {
  Blocks near = all_blocks();
  for (const int side : {0, 1}) {
    for (std::size_t block = 0; block < near.of_side[side].size(); ++block) {
      const Panel& outer = sides_[side].panels[block == 0 ? 0 : block + graded_panels - 1];
      const Panel& inner = sides_[side].panels[block + graded_panels - 1];
      const double begin = side == 0 ? outer.left - half_length_ : half_length_ - inner.right;
      const double end = side == 0 ? inner.right - half_length_ : half_length_ - outer.left;
      near.of_side[side][block] = std::max(begin - right, left - end) < nearest_far;
    }
  }
  return near;
}

std::span<const TractionField::SmoothNode> TractionField::nodes_of(bool right, std::size_t block) const {
  const std::span<const SmoothNode> all(smooth_[right ? 1 : 0]);
  if (block == 0) return all.first(nodes_at_end);
  return all.subspan(nodes_at_end + (block - 1) * nodes_inside, nodes_inside);
}

SheetStresses TractionField::half_planes(const Blocks& blocks, const InnerPlace& place) const {
  SheetStresses sum{};
  for (const double face : {1.0, -1.0}) {
    const double d = 1 - face * place.depth;
    Cauchy f{};
    for (const bool right : {false, true}) add_side(right, blocks.of_side[right ? 1 : 0], place.alpha, d, f);
    const Complex p = d * f.pressure_slope, q = d * f.shear_slope;
    sum = sum + SheetStresses{(f.pressure.imag() + p.real() + q.imag()) / pi,
                              (f.pressure.imag() - p.real() - 2 * f.shear.real() - q.imag()) / pi,
                              face * (q.real() - f.shear.imag() - p.imag()) / pi};
  }
  return sum;
}

/// What is between two alphas and not from the half-planes' loads near it: those near give what the sheet adds, those
/// far the whole.
class TractionField::Cell {
 public:
  Cell(const TractionField& field, double left, double right)
      : left_(left), near_(field.blocks_near(left, right)) {
    for (const bool on_right : {false, true}) {
      const std::vector<bool>& near = near_.of_side[on_right ? 1 : 0];
      for (std::size_t block = 0; block < near.size(); ++block) {
        const auto nodes = field.nodes_of(on_right, block);
        if (near[block]) {
          near_nodes_.insert(near_nodes_.end(), nodes.begin(), nodes.end());
        } else {
          for (const SmoothNode& node : nodes) add_far(node, node.alpha < left ? left_of_ : right_of_, right);
        }
      }
    }
  }

  [[nodiscard]] const Blocks& near() const { return near_; }
  /// At one alpha.
  void add(double alpha, const internal::StressesAtDepths& depths, std::span<SheetStresses> sums) const {
    std::vector<internal::StressesBeside> one(sums.size());
    for (const SmoothNode& node : near_nodes_) {
      depths(alpha - node.alpha, one);
      for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] = sums[i] + node.pressure * one[i].normal + node.shear * one[i].shear;
    }
    if (left_of_) depths.add_far(seen_from(*left_of_, alpha), 1, sums);
    if (right_of_) depths.add_far(seen_from(*right_of_, alpha), -1, sums);
  }

 private:
  /// Far loads of one side as seen from the nearer end of the cell.
  struct Far {
    double end;
    internal::FarLoads loads;
  };

  void add_far(const SmoothNode& node, std::optional<Far>& side, double right) {
    if (!side) {
      side.emplace(
          Far{node.alpha < left_ ? left_ : right, {internal::AlongWaves(0), internal::AlongWaves(0), 0}});
      for (internal::AlongWaves* waves : {&side->loads.pressure, &side->loads.shear}) waves->of.fill(0);
    }
    const internal::AlongWaves waves(std::fabs(node.alpha - side->end));
    for (std::size_t n = 0; n < static_cast<std::size_t>(waves.count); ++n) {
      side->loads.pressure.of[n] += node.pressure * waves.of[n];
      side->loads.shear.of[n] += node.shear * waves.of[n];
    }
    side->loads.shear_force += node.shear;
  }
  static internal::FarLoads seen_from(const Far& far, double alpha) {
    internal::FarLoads loads = far.loads;
    const internal::AlongWaves waves(std::fabs(alpha - far.end));
    for (std::size_t n = 0; n < loads.pressure.of.size(); ++n) {
      const Complex wave = n < static_cast<std::size_t>(waves.count) ? waves.of[n] : 0;
      loads.pressure.of[n] *= wave;
      loads.shear.of[n] *= wave;
    }
    return loads;
  }

  double left_;
  Blocks near_;
  std::vector<SmoothNode> near_nodes_;
  std::optional<Far> left_of_, right_of_;
};

/// Chebyshev series of a cell in alpha and in the square of the depth: stresses across and along are even in it, the
/// shear over the depth too.
class TractionField::Interpolant {
 public:
  static constexpr int along = 24, across = 12;

  Interpolant(const Cell& cell, double left, double length) : left_(left), length_(length) {
    std::array<double, across> depths;
    for (int j = 0; j < across; ++j)
      depths[static_cast<std::size_t>(j)] = std::sqrt((1 + zero(j, across)) / 2);
    const internal::StressesAtDepths at_depths(depths);
    std::array<SheetStresses, along * across> values{};
    for (int i = 0; i < along; ++i) {
      cell.add(left + length * (1 + zero(i, along)) / 2, at_depths,
               std::span(values).subspan(static_cast<std::size_t>(i * across), across));
    }
    for (std::size_t k = 0; k < values.size(); ++k) values[k].shear /= depths[k % across];
    // One variable after the other.
    std::array<SheetStresses, along * across> halfway{};
    for (int i = 0; i < along; ++i) {
      for (int n = 0; n < across; ++n) {
        SheetStresses sum{};
        for (int j = 0; j < across; ++j) {
          const double weight = (n == 0 ? 1.0 : 2.0) / across * std::cos(pi * n * (j + 0.5) / across);
          sum = sum + weight * values[static_cast<std::size_t>(i * across + j)];
        }
        halfway[static_cast<std::size_t>(i * across + n)] = sum;
      }
    }
    for (int m = 0; m < along; ++m) {
      for (int i = 0; i < along; ++i) {
        const double weight = (m == 0 ? 1.0 : 2.0) / along * std::cos(pi * m * (i + 0.5) / along);
        for (int n = 0; n < across; ++n)
          coefficient_[m][n] =
              coefficient_[m][n] + weight * halfway[static_cast<std::size_t>(i * across + n)];
      }
    }
  }

  [[nodiscard]] SheetStresses at(const InnerPlace& place) const {
    const double x = 2 * (place.alpha - left_) / length_ - 1, y = 2 * place.depth * place.depth - 1;
    std::array<double, across> polynomials{};
    polynomials[0] = 1;
    polynomials[1] = y;
    for (std::size_t n = 2; n < across; ++n) polynomials[n] = 2 * y * polynomials[n - 1] - polynomials[n - 2];
    SheetStresses sum{};
    double before = x, here = 1;
    for (int m = 0; m < along; ++m) {
      SheetStresses row{};
      for (int n = 0; n < across; ++n) {
        const double t = polynomials[static_cast<std::size_t>(n)];
        row = row + t * coefficient_[m][n];
      }
      sum = sum + here * row;
      before = std::exchange(here, 2 * x * here - before);
    }
    sum.shear *= place.depth;
    return sum;
  }

 private:
  static double zero(int i, int count) { return std::cos(pi * (i + 0.5) / count); }

  double left_, length_;
  SheetStresses coefficient_[along][across]{};
};

SheetStresses TractionField::at(const InnerPlace& place) const {
  const Cell cell(*this, place.alpha, place.alpha);
  SheetStresses sum = half_planes(cell.near(), place);
  cell.add(place.alpha, internal::StressesAtDepths({&place.depth, 1}), {&sum, 1});
  return sum;
}

std::vector<SheetStresses> TractionField::at(std::span<const InnerPlace> places) const {
  constexpr double length = 2;
  constexpr std::size_t fewest_in_cell = 64;  // as dear one by one
  std::map<double, std::vector<std::size_t>> cells;
  for (std::size_t i = 0; i < places.size(); ++i)
    cells[length * std::floor(folded(places[i]).first.alpha / length)].push_back(i);
  std::vector<SheetStresses> result(places.size());
  const auto set = [&](std::size_t i, const SheetStresses& stresses) {
    result[i] = stresses;
    if (folded(places[i]).second) result[i].shear = -stresses.shear;
  };
  for (const auto& [left, members] : cells) {
    if (members.size() < fewest_in_cell) {
      for (const std::size_t i : members) set(i, at(folded(places[i]).first));
      continue;
    }
    const Cell cell(*this, left, left + length);
    const Interpolant interpolant(cell, left, length);
    for (const std::size_t i : members) {
      const InnerPlace place = folded(places[i]).first;
      set(i, half_planes(cell.near(), place) + interpolant.at(place));
    }
  }
  return result;
}

}  // namespace nipref::fast
