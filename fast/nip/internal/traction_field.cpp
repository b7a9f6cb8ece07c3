#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <nipref/fast/nip/internal/traction_field.hpp>
#include <nipref/fast/number/internal/gauss_legendre.hpp>

namespace nipref::fast {
namespace {

using Complex = std::complex<double>;
/// Of a half-thickness or of the contact at its end, and of any panel.
constexpr int halvings_at_end = 72, most_halvings = 10;
/// The right ends of the panels of one side before they are halved further: they double from the contact's end and then
/// follow the blocks to the middle.
std::vector<double> panel_ends(const ContactBlocks& blocks) {
  std::vector<double> ends;
  for (int k = halvings_at_end; k >= 0; --k) ends.push_back(std::ldexp(blocks.graded(), -k));
  for (std::size_t block = 1; block < blocks.of_side(); ++block)
    ends.push_back(blocks.graded() + blocks.inner() * static_cast<double>(block));
  ends.back() = blocks.half_length();
  return ends;
}

const GaussRule& rule_of_panel(int order) {
  static const GaussRule rule = gauss_legendre(order);
  return rule;
}

double largest(const FaceTraction& of) { return std::max(std::fabs(of.pressure), std::fabs(of.shear)); }

/// Q_0 .. Q_(order-1) at z in the upper half-plane or, as limits from there, on the axis but for +-1. The recurrence
/// runs forwards where the values fall little with the order, otherwise backwards.
template <std::size_t order>
std::array<std::complex<double>, order> second_kind(std::complex<double> z, std::complex<double> z_plus_1,
                                                    std::complex<double> z_minus_1) {
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
  const int start = static_cast<int>(order) - 1 + static_cast<int>(std::ceil(18 / std::log(fall)));
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

}  // namespace

TractionField::TractionField(double half_length, bool symmetric, const FaceTractions& traction)
    : blocks_(half_length),
      symmetric_(symmetric),
      sides_(make_sides(traction)),
      sheet_part_(blocks_, symmetric,
                  [this](bool right, std::size_t block) { return loads_of(right, block); }) {}

std::vector<TractionField::Side> TractionField::make_sides(const FaceTractions& traction) const {
  const Side right = make_side(true, traction);
  return {symmetric_ ? mirrored(right) : make_side(false, traction), right};
}

TractionField::Side TractionField::mirrored(const Side& right) {
  Side left = right;
  for (SampledPanel& panel : left.panels) {
    for (std::size_t j = 0; j < order; ++j) {
      panel.t[j] = -panel.t[j];
      panel.loads[j].shear *= -1;
      (j % 2 == 0 ? panel.series[j].shear : panel.series[j].pressure) *= -1;
    }
  }
  for (Moments& moments : left.moments) {
    for (FaceTraction& moment : moments) moment.shear *= -1;
  }
  return left;
}

TractionField::Side TractionField::make_side(bool right, const FaceTractions& traction) const {
  constexpr double rounding = 1e-14;
  std::vector<SampledPanel> coarse;
  double left = 0, peak = 0;
  for (const double end : panel_ends(blocks_)) {
    coarse.push_back(sampled(right, left, end, traction));
    peak = std::max(peak, largest(coarse.back().series[0]));
    left = end;
  }
  Side side;
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    if (i == 0 || i > halvings_at_end) side.first_of_block.push_back(side.panels.size());
    if (i == 0)
      add(coarse[i], side);
    else
      add_resolved(right, coarse[i], traction, rounding * peak, most_halvings, side);
  }
  side.first_of_block.push_back(side.panels.size());
  return side;
}

void TractionField::add_resolved(bool right, const SampledPanel& panel, const FaceTractions& traction,
                                 double negligible, int halvings, Side& side) {
  const double last = std::max(largest(panel.series[order - 2]), largest(panel.series[order - 1]));
  if (last <= negligible || halvings == 0) {
    side.unresolved = std::max(side.unresolved, last);
    add(panel, side);
    return;
  }
  const double middle = std::midpoint(panel.left, panel.right);
  for (const SampledPanel& half :
       {sampled(right, panel.left, middle, traction), sampled(right, middle, panel.right, traction)})
    add_resolved(right, half, traction, negligible, halvings - 1, side);
}

TractionField::SampledPanel TractionField::sampled(bool right, double left, double end,
                                                   const FaceTractions& traction) {
  const GaussRule& rule = rule_of_panel(order);
  SampledPanel panel{};
  panel.left = left;
  panel.right = end;
  panel.width = end - left;
  for (std::size_t j = 0; j < order; ++j) {
    const FaceTraction here = traction(right, left + panel.width * rule.at[j]);
    panel.t[j] = right ? 1 - 2 * rule.at[j] : 2 * rule.at[j] - 1;
    panel.loads[j].add(2 * rule.weight[j], here);
    std::array<double, order> polynomials{};
    legendre(panel.t[j], polynomials);
    for (std::size_t k = 0; k < order; ++k)
      panel.series[k].add((static_cast<double>(k) + 0.5) * polynomials[k], panel.loads[j]);
  }
  return panel;
}

std::vector<LoadOnFace> TractionField::loads_of(bool right, std::size_t block) const {
  const Side& side = sides_[right ? 1 : 0];
  std::vector<LoadOnFace> loads;
  for (std::size_t i = side.first_of_block[block]; i < side.first_of_block[block + 1]; ++i) {
    const SampledPanel& panel = side.panels[i];
    for (std::size_t j = 0; j < order; ++j) {
      loads.push_back({panel.left + panel.width * rule_of_panel(order).at[j], {}});
      loads.back().force.add(panel.width / 2, panel.loads[j]);
    }
  }
  return loads;
}

/// With the moments of all panels up to it.
void TractionField::add(const SampledPanel& panel, Side& side) {
  const double left = panel.left, end = panel.right;
  Moments moments{};
  for (std::size_t j = 0; j < order; ++j) {
    const double share = (left + panel.width * rule_of_panel(order).at[j]) / end;
    double power = panel.width / 2;
    for (std::size_t m = 0; m < moment_count; ++m, power *= share) moments[m].add(power, panel.loads[j]);
  }
  if (!side.moments.empty()) {
    double power = 1;
    for (std::size_t m = 0; m < moment_count; ++m, power *= left / end)
      moments[m].add(power, side.moments.back()[m]);
  }
  side.panels.push_back(panel);
  side.moments.push_back(moments);
}

void TractionField::add_side(bool right, const ContactBlocks::Range& near, double alpha, double distance,
                             Wanted wanted, Cauchy& total) const {
  Cauchy sum = total;
  const bool slopes = wanted == Wanted::slopes;
  const Side& side = sides_[right ? 1 : 0];
  const auto [begin, end_panel] = panels_of(right, near);
  const double half_length = blocks_.half_length();
  const double turn = right ? -1 : 1;  // along the sheet with growing distance from the end
  const Complex from_end(alpha - (right ? half_length : -half_length), distance);
  const double reach = std::abs(from_end) / 4;
  std::size_t first = begin;
  while (begin == 0 && first < end_panel && side.panels[first].right <= reach) ++first;
  if (first > begin) {
    // The multipole expansion about the end.
    const double end = side.panels[first - 1].right;
    const Moments& moments = side.moments[first - 1];
    const Complex inverse = 1.0 / from_end, ratio = turn * end * inverse;
    Complex power = inverse;
    for (std::size_t m = 0; m < moment_count; ++m, power *= ratio) {
      const auto n = static_cast<double>(m);
      sum.whole.add(power, moments[m]);
      if (slopes)
        sum.slope.add((n + 1) * power * inverse, moments[m]);
      else
        sum.log.add(m == 0 ? std::log(from_end) : -power * from_end / n, moments[m]);
    }
  }
  for (std::size_t i = first; i < end_panel; ++i) {
    const SampledPanel& panel = side.panels[i];
    const double half = panel.width / 2;
    // The distance from a panel's end, the same number for both panels that share it.
    const auto from_break = [&](double e) {
      return e == half_length ? Complex(alpha, distance) : from_end - turn * e;
    };
    const Complex z = (from_end - turn * (panel.left + half)) / half;
    if (std::norm(z) > 2.6) {
      for (std::size_t j = 0; j < order; ++j) {
        const double x = z.real() - panel.t[j], y = z.imag(), inverse = 1 / (x * x + y * y);
        const double re = x * inverse, im = -y * inverse;
        sum.whole.add({re, im}, panel.loads[j]);
        if (slopes)
          sum.slope.add({(re * re - im * im) / half, 2 * re * im / half}, panel.loads[j]);
        else
          sum.log.add(half * std::log(half * Complex(x, y)), panel.loads[j]);
      }
      continue;
    }
    // At the common end of two panels their logarithms cancel.
    constexpr double beside_break = 1e-40;
    Complex from_left = from_break(right ? panel.right : panel.left);
    Complex from_right = from_break(right ? panel.left : panel.right);
    if (from_left == 0.0) from_left = {0, beside_break};
    if (from_right == 0.0) from_right = {0, beside_break};
    const Complex from_minus_1 = from_left / half, from_1 = from_right / half;
    const auto q = second_kind<order + 1>(z, from_minus_1, from_1);
    const Complex over = half / from_left * (half / from_right);
    for (std::size_t k = 0; k < order; ++k) {
      const auto n = static_cast<double>(k);
      sum.whole.add(2.0 * q[k], panel.series[k]);
      if (slopes)  // -Q_k'
        sum.slope.add((k == 0 ? Complex(1) : n * (q[k - 1] - z * q[k])) * over * (2 / half), panel.series[k]);
      else  // The integral of P_k(t) ln(half (z - t)), by parts with (2k + 1) P_k = P_(k+1)' - P_(k-1)'.
        sum.log.add(half * (k == 0 ? from_minus_1 * std::log(from_left) - from_1 * std::log(from_right) - 2.0
                                   : 2.0 / (2 * n + 1) * (q[k + 1] - q[k - 1])),
                    panel.series[k]);
    }
  }
  total = sum;
}

TractionField::Cauchy TractionField::cauchy(const ContactBlocks::Range& near, double alpha, double distance,
                                            Wanted wanted) const {
  Cauchy sum{};
  for (const bool right : {false, true}) add_side(right, near, alpha, distance, wanted, sum);
  return sum;
}

std::pair<std::size_t, std::size_t> TractionField::panels_of(bool right,
                                                             const ContactBlocks::Range& blocks) const {
  const std::size_t of_side = blocks_.of_side(), all = blocks_.count();
  const auto before = [&](std::size_t block) { return sides_[right ? 1 : 0].first_of_block[block]; };
  if (right)
    return {before(all - std::max(blocks.end, of_side)), before(all - std::max(blocks.begin, of_side))};
  return {before(std::min(blocks.begin, of_side)), before(std::min(blocks.end, of_side))};
}

SheetStresses TractionField::half_planes(const ContactBlocks::Range& near, const SheetPoint& place) const {
  SheetStresses sum{};
  for (const double face : {1.0, -1.0}) {
    const double d = 1 - face * place.depth;
    const auto [whole, slope, log] = cauchy(near, place.alpha, d, Wanted::slopes);
    const Complex p = d * slope.pressure, q = d * slope.shear;
    sum = sum + SheetStresses{
                    (whole.pressure.imag() + p.real() + q.imag()) / std::numbers::pi,
                    (whole.pressure.imag() - p.real() - 2 * whole.shear.real() - q.imag()) / std::numbers::pi,
                    face * (q.real() - whole.shear.imag() - p.imag()) / std::numbers::pi};
  }
  return sum;
}

/// Line loads p and q at the distance a along the sheet, r^2 = a^2 + d^2, displace each face's half-plane by
///     pi u = p (ln r - t1 d^2/r^2) - q (t2 theta + t1 a d/r^2), towards that face
///     pi v = p (t1 a d/r^2 - t2 theta) - q (ln r + t1 d^2/r^2)
/// with ln r + i (pi/2 - theta) = ln(a + i d), where pi/2 is left out, as it cancels between depths.
internal::FromFace TractionField::half_planes_displaced(const ContactBlocks::Range& near, double alpha,
                                                        double depth, const internal::Shares& share) const {
  const auto [t1, t2] = share;
  internal::FromFace sum{};
  for (const double face : {1.0, -1.0}) {
    const double d = 1 - face * depth;
    const auto [whole, slope, log] = cauchy(near, alpha, d, Wanted::logarithms);
    const Complex p = t1 * d * whole.pressure, q = t1 * d * whole.shear;
    sum.u += face * (log.pressure.real() + p.imag() + t2 * log.shear.imag() - q.real()) / std::numbers::pi;
    sum.v += (t2 * log.pressure.imag() + p.real() - log.shear.real() + q.imag()) / std::numbers::pi;
  }
  return sum;
}

internal::FromFace TractionField::from_face(const SheetPoint& place, const internal::Shares& share) const {
  const double s = std::fabs(place.depth);
  if (s == 1) return {0, 0};
  const auto [at, turned] = folded(place);
  const ContactBlocks::Range near = sheet_part_.near(at.alpha);
  const internal::FromFace here = half_planes_displaced(near, at.alpha, s, share),
                           face = half_planes_displaced(near, at.alpha, 1, share),
                           rest = sheet_part_.from_face(at.alpha, s, share);
  const double v = here.v - face.v + rest.v;
  return {-(here.u - s * face.u + rest.u), turned ? -v : v};
}

SheetStresses TractionField::at(const SheetPoint& place) const {
  const auto [at, turned] = folded(place);
  SheetStresses stresses = half_planes(sheet_part_.near(at.alpha), at) + sheet_part_.at(at.alpha, at.depth);
  if (turned) stresses.shear = -stresses.shear;
  return stresses;
}

}  // namespace nipref::fast
