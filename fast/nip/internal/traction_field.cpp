#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <nipref/fast/nip/internal/traction_field.hpp>
#include <nipref/fast/number/internal/gauss_legendre.hpp>
#include <nipref/fast/number/internal/legendre.hpp>

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
      panel.shear[j] = -panel.shear[j];
      (j % 2 == 0 ? panel.shear_series : panel.pressure_series)[j] *= -1;
    }
  }
  for (Moments& moments : left.moments) {
    for (double& moment : moments.shear) moment = -moment;
  }
  return left;
}

TractionField::Side TractionField::make_side(bool right, const FaceTractions& traction) const {
  constexpr double rounding = 1e-14;
  std::vector<SampledPanel> coarse;
  double left = 0, peak = 0;
  for (const double end : panel_ends(blocks_)) {
    coarse.push_back(sampled(right, left, end, traction));
    peak = std::max(
        {peak, std::fabs(coarse.back().pressure_series[0]), std::fabs(coarse.back().shear_series[0])});
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
  double last = 0;
  for (const auto* series : {&panel.pressure_series, &panel.shear_series})
    last = std::max({last, std::fabs((*series)[order - 2]), std::fabs((*series)[order - 1])});
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
    panel.pressure[j] = 2 * rule.weight[j] * here.pressure;
    panel.shear[j] = 2 * rule.weight[j] * here.shear;
    std::array<double, order> polynomials{};
    internal::legendre(panel.t[j], polynomials);
    for (std::size_t k = 0; k < order; ++k) {
      const double factor = (static_cast<double>(k) + 0.5) * polynomials[k];
      panel.pressure_series[k] += factor * panel.pressure[j];
      panel.shear_series[k] += factor * panel.shear[j];
    }
  }
  return panel;
}

std::vector<LoadOnFace> TractionField::loads_of(bool right, std::size_t block) const {
  const Side& side = sides_[right ? 1 : 0];
  std::vector<LoadOnFace> loads;
  for (std::size_t i = side.first_of_block[block]; i < side.first_of_block[block + 1]; ++i) {
    const SampledPanel& panel = side.panels[i];
    for (std::size_t j = 0; j < order; ++j)
      loads.push_back({panel.left + panel.width * rule_of_panel(order).at[j],
                       panel.width / 2 * panel.pressure[j], panel.width / 2 * panel.shear[j]});
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
}

void TractionField::add_side(bool right, const ContactBlocks::Range& near, double alpha, double distance,
                             Wanted wanted, Cauchy& sum) const {
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
      sum.pressure += moments.pressure[m] * power;
      sum.shear += moments.shear[m] * power;
      if (slopes) {
        const Complex slope = (n + 1) * power * inverse;
        sum.pressure_slope += moments.pressure[m] * slope;
        sum.shear_slope += moments.shear[m] * slope;
      } else {
        const Complex logarithm = m == 0 ? std::log(from_end) : -power * from_end / n;
        sum.pressure_log += moments.pressure[m] * logarithm;
        sum.shear_log += moments.shear[m] * logarithm;
      }
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
        if (!slopes) {
          const Complex logarithm = half * std::log(half * Complex(x, y));
          sum.pressure_log += panel.pressure[j] * logarithm;
          sum.shear_log += panel.shear[j] * logarithm;
        }
      }
      sum.pressure += Complex(real[0], imag[0]);
      sum.pressure_slope += Complex(real[1], imag[1]) / half;
      sum.shear += Complex(real[2], imag[2]);
      sum.shear_slope += Complex(real[3], imag[3]) / half;
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
      sum.pressure += panel.pressure_series[k] * 2.0 * q[k];
      sum.shear += panel.shear_series[k] * 2.0 * q[k];
      if (!slopes) {
        // The integral of P_k(t) ln(half (z - t)), by parts with (2k + 1) P_k = P_(k+1)' - P_(k-1)'.
        const Complex logarithm =
            half * (k == 0 ? from_minus_1 * std::log(from_left) - from_1 * std::log(from_right) - 2.0
                           : 2.0 / (2 * n + 1) * (q[k + 1] - q[k - 1]));
        sum.pressure_log += panel.pressure_series[k] * logarithm;
        sum.shear_log += panel.shear_series[k] * logarithm;
        continue;
      }
      // -Q_k'
      const Complex slope = (k == 0 ? Complex(1) : n * (q[k - 1] - z * q[k])) * over * (2 / half);
      sum.pressure_slope += panel.pressure_series[k] * slope;
      sum.shear_slope += panel.shear_series[k] * slope;
    }
  }
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
    Cauchy f{};
    for (const bool right : {false, true}) add_side(right, near, place.alpha, d, Wanted::slopes, f);
    const Complex p = d * f.pressure_slope, q = d * f.shear_slope;
    sum =
        sum + SheetStresses{(f.pressure.imag() + p.real() + q.imag()) / std::numbers::pi,
                            (f.pressure.imag() - p.real() - 2 * f.shear.real() - q.imag()) / std::numbers::pi,
                            face * (q.real() - f.shear.imag() - p.imag()) / std::numbers::pi};
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
    Cauchy f{};
    for (const bool right : {false, true}) add_side(right, near, alpha, d, Wanted::logarithms, f);
    const Complex p = t1 * d * f.pressure, q = t1 * d * f.shear;
    sum.u +=
        face * (f.pressure_log.real() + p.imag() + t2 * f.shear_log.imag() - q.real()) / std::numbers::pi;
    sum.v += (t2 * f.pressure_log.imag() + p.real() - f.shear_log.real() + q.imag()) / std::numbers::pi;
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
