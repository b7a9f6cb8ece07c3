#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <nipref/ref/number/internal/bracketed_root.hpp>
#include <nipref/ref/number/internal/chebyshev_sum.hpp>
#include <nipref/ref/number/internal/local_slope.hpp>
#include <nipref/ref/number/internal/refined_solution.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_pressure.hpp>

namespace nipref::ref {

/// The longest piece of an integral where the sheet itself is felt, half-thicknesses: its kernel is singular 2 beside.
constexpr double longest_piece = 2.5;

/// For the panels of a layout, and for pieces that begin or end where a kernel or the basis is singular. A kernel
/// is analytic but for a point a third of a piece's length, or a panel's width, away, so that a node of Gauss brings
/// 2.2 nats, with the root of an end taken out by a substitution as many; a memory that swings grows within it as RollingKernel says.
struct RollingPressure::Rules {
  UnitRule plain, root, ends;
  Float first_piece;  ///< beside the kernel's singularity, in which memories fade by a few times e at most

  Rules(const RollingLayout& layout, const RollingKernel& kernel) {
    double widest = 0;
    for (const RollingPanel& panel : layout.panels)
      widest = std::max(widest, static_cast<double>(panel.width));
    const double swing = 1.4 * kernel.swing(widest), nats = kernel.nats() + swing;
    plain = gauss_rule(static_cast<int>(nats / 2.2) + layout.terms / 2 + 6);
    root = gauss_rule(static_cast<int>(nats / 2.2) + layout.terms + 6);
    ends = double_exponential_rule(kernel.nats(), layout.terms + static_cast<int>(swing / 2));
    first_piece = longest_piece;
    for (const RollingMemory& term : kernel.memory())
      if (!is_flow(term)) first_piece = std::min(first_piece, 8 / abs(term.rate));
  }
};

/// Integrals of K(s - x) times functions that are the panel's root times polynomials, s and x counted from its left
/// end. All kernels of a contact have the same memory and digits, so that one set of rules serves them.
class RollingPressure::Integrals {
 public:
  /// Values of all functions at a place.
  using Functions =
      std::function<void(const Float& from_left, const Float& from_right, std::vector<Float>& values)>;

  Integrals(const RollingPanel& panel, std::size_t count, Functions functions, const Rules& rules)
      : panel_(panel), functions_(std::move(functions)), rules_(rules), count_(count) {
    const UnitRule& rule = panel.has_root() ? rules.root : rules.plain;
    for (std::size_t i = 0; i < rule.size(); ++i) append_node(rule, i);
  }

  /// One for each function.
  [[nodiscard]] std::vector<Float> of(const Float& s, RollingKernel& kernel) const {
    std::vector<Float> sums(count_);
    const Float& width = panel_.width;
    const Float gap = std::max(Float(-s), Float(s - width));
    if (gap >= width && (width <= longest_piece || gap >= kernel.far())) {
      add_far(s, kernel, sums);
      return sums;
    }
    if (s < width) add_side(s, true, kernel, sums);
    if (s > 0) add_side(s, false, kernel, sums);
    return sums;
  }

 private:
  /// With the root at an end, x = xi^2 from there; with one at both, x = sin^2(pi xi/2).
  void append_node(const UnitRule& rule, std::size_t i) {
    const Float& xi = rule.from_left[i];
    Float x, slope;
    if (panel_.root_left && panel_.root_right) {
      const Float sine = sin(pi() * xi / 2), cosine = cos(pi() * xi / 2);
      x = sine * sine;
      slope = pi() * sine * cosine;
    } else if (panel_.root_left) {
      x = xi * xi;
      slope = 2 * xi;
    } else if (panel_.root_right) {
      const Float& other = rule.from_right[i];
      x = 1 - other * other;
      slope = 2 * other;
    } else {
      x = xi;
      slope = 1;
    }
    far_at_.push_back(panel_.width * x);
    std::vector<Float> values(count_);
    functions_(far_at_.back(), panel_.width - far_at_.back(), values);
    const Float factor = panel_.width * slope * rule.weight[i];
    for (Float& value : values) value *= factor;
    far_values_.push_back(std::move(values));
  }

  void add_far(const Float& s, RollingKernel& kernel, std::vector<Float>& sums) const {
    for (std::size_t i = 0; i < far_at_.size(); ++i) {
      const Float value = kernel(s - far_at_[i]);
      if (value != 0) accumulate(value, far_values_[i], sums);
    }
  }

  /// Of what is downstream of s, or upstream: pieces three times as long as they are far away, but none ends just before
  /// a root.
  void add_side(const Float& s, bool down, RollingKernel& kernel, std::vector<Float>& sums) const {
    const Float& width = panel_.width;
    const Float gap = std::max(Float(0), down ? Float(-s) : Float(s - width));
    const Float all = std::min(width, down ? Float(width - s) : s);
    Float done = 0;
    for (bool last = false; !last;) {
      const Float from = gap + done, left_over = all - done;
      Float length = from == 0 ? rules_.first_piece : 3 * from;
      if (from < kernel.far()) length = std::min(length, Float(longest_piece));
      last = left_over <= length;
      length = last ? left_over : std::min(length, Float(left_over / 2));
      const bool at_first = gap > 0 && done == 0 && (down ? panel_.root_left : panel_.root_right);
      const bool at_last = last && (down ? panel_.root_right : panel_.root_left);
      const bool at_root = from == 0 || at_first || at_last;
      add_piece(s, down ? length : -length, from, at_root ? rules_.ends : rules_.plain, kernel, sums);
      done += length;
    }
  }

  /// Of a piece that begins `gap` away from s and goes on by `length`, downstream if that is positive.
  void add_piece(const Float& s, const Float& length, const Float& gap, const UnitRule& rule,
                 RollingKernel& kernel, std::vector<Float>& sums) const {
    const bool down = length > 0;
    const Float size = abs(length);
    // Of the piece's ends from the panel's, exactly 0 where they are the same.
    const Float near = down ? s + gap : panel_.width - s + gap;  // from the end that is behind
    Float beyond = panel_.width - near - size;
    if (abs(beyond) < ldexp(panel_.width, -40)) beyond = 0;
    std::vector<Float> values(count_);
    for (std::size_t i = 0; i < rule.size(); ++i) {
      const Float way = size * rule.from_left[i];
      const Float value = kernel(down ? -(gap + way) : gap + way) * (size * rule.weight[i]);
      if (value == 0) continue;
      const Float behind = near + way, ahead = beyond + size * rule.from_right[i];
      functions_(down ? behind : ahead, down ? ahead : behind, values);
      accumulate(value, values, sums);
    }
  }

  static void accumulate(const Float& factor, const std::vector<Float>& values, std::vector<Float>& sums) {
    Float term;
    for (std::size_t k = 0; k < sums.size(); ++k) {
      mpfr_mul(raw(term), raw(factor), raw(values[k]), MPFR_RNDN);
      mpfr_add(raw(sums[k]), raw(sums[k]), raw(term), MPFR_RNDN);
    }
  }

  const RollingPanel& panel_;
  Functions functions_;
  const Rules& rules_;
  std::size_t count_;
  std::vector<Float> far_at_;
  std::vector<std::vector<Float>> far_values_;
};

void RollingPanel::basis(const Float& from_left, const Float& from_right, std::vector<Float>& values) const {
  Float factor = 1;
  if (root_left) factor *= sqrt(from_left / width);
  if (root_right) factor *= sqrt(from_right / width);
  const Float x = (from_left - from_right) / width;
  const Float twofold = 2 * x;
  values[0] = factor;
  if (values.size() > 1) values[1] = factor * x;
  for (std::size_t k = 2; k < values.size(); ++k) {
    mpfr_mul(raw(values[k]), raw(twofold), raw(values[k - 1]), MPFR_RNDN);
    mpfr_sub(raw(values[k]), raw(values[k]), raw(values[k - 2]), MPFR_RNDN);
  }
}

RollingLayout::RollingLayout(const Float& half_length, double first, double growth, double longest,
                             bool whole, int the_terms)
    : terms(the_terms) {
  if (whole) {
    panels.push_back({0, 2 * half_length, true, true});
    return;
  }
  const auto size = static_cast<double>(half_length);
  std::vector<double> edges{0, first};
  while (edges.back() < size) edges.push_back(edges.back() + std::min((growth - 1) * edges.back(), longest));
  for (double& edge : edges) edge /= edges.back();
  const auto at = [&](std::size_t i) { return edges[i] * half_length; };
  const std::size_t count = edges.size() - 1;
  for (std::size_t i = 0; i < count; ++i) panels.push_back({at(i), at(i + 1) - at(i), i == 0, false});
  for (std::size_t i = count; i-- > 0;)
    panels.push_back({2 * half_length - at(i + 1), at(i + 1) - at(i), false, i == 0});
}

std::vector<Float> RollingLayout::matching_points() const {
  std::vector<Float> points;
  for (const RollingPanel& panel : panels) {
    const int count = terms + (panel.root_left ? 1 : 0) + (panel.root_right ? 1 : 0);
    for (int i = 0; i < count; ++i)
      points.push_back(panel.left + panel.width * (1 - cos((2 * i + 1) * pi() / (2 * count))) / 2);
  }
  return points;
}

RollingPressure::RollingPressure(const Float& half_length, RollingLayout layout, RollingKernel& kernel)
    : half_length_(half_length),
      layout_(std::move(layout)),
      rules_(std::make_unique<Rules>(layout_, kernel)) {
  const std::vector<Float> points = layout_.matching_points();
  const int rows = layout_.unknowns();
  Matrix matrix(rows, rows);
  Vector right(rows);
  for (std::size_t p = 0; p < layout_.panels.size(); ++p) {
    const RollingPanel& panel = layout_.panels[p];
    const auto basis = [&](const Float& from_left, const Float& from_right, std::vector<Float>& values) {
      panel.basis(from_left, from_right, values);
    };
    const Integrals moments(panel, static_cast<std::size_t>(layout_.terms), basis, *rules_);
    for (int i = 0; i < rows; ++i) {
      const std::vector<Float> sums = moments.of(points[static_cast<std::size_t>(i)] - panel.left, kernel);
      for (int k = 0; k < layout_.terms; ++k)
        matrix(i, static_cast<int>(p) * layout_.terms + k) = sums[static_cast<std::size_t>(k)];
    }
  }
  // Displacements in units of A^2, so that all unknowns are of about one size.
  for (int i = 0; i < rows; ++i) {
    const Float d = points[static_cast<std::size_t>(i)] / half_length_;
    matrix(i, rows - 2) = -half_length_;
    matrix(i, rows - 1) = -2 * d * half_length_;
    right(i) = d * (2 - d) * half_length_ * half_length_;
  }
  const Vector solution = refined_solution(matrix, right);
  edge_displacement_ = solution(rows - 2) * half_length_;
  offset_ = solution(rows - 1);
  for (std::size_t p = 0; p < layout_.panels.size(); ++p) {
    coefficients_.emplace_back();
    for (int k = 0; k < layout_.terms; ++k)
      coefficients_.back().push_back(solution(static_cast<int>(p) * layout_.terms + k));
  }
  integrate(rules_->ends);
  for (std::size_t p = 0; p < layout_.panels.size(); ++p) {
    const auto here = [this, p](const Float& from_left, const Float& from_right, std::vector<Float>& values) {
      values.front() = in_panel(p, from_left, from_right);
    };
    pressures_.emplace_back(layout_.panels[p], 1, here, *rules_);
  }
}

RollingPressure::~RollingPressure() = default;

Float RollingPressure::in_panel(std::size_t panel, const Float& from_left, const Float& from_right) const {
  const RollingPanel& here = layout_.panels[panel];
  Float value = chebyshev_sum(coefficients_[panel], (from_left - from_right) / here.width);
  if (here.root_left) value *= sqrt(from_left / here.width);
  if (here.root_right) value *= sqrt(from_right / here.width);
  return value;
}

void RollingPressure::integrate(const UnitRule& rule) {
  for (std::size_t p = 0; p < layout_.panels.size(); ++p) {
    const RollingPanel& panel = layout_.panels[p];
    for (std::size_t i = 0; i < rule.size(); ++i) {
      const Float from_left = panel.width * rule.from_left[i];
      const Float part =
          panel.width * rule.weight[i] * in_panel(p, from_left, panel.width * rule.from_right[i]);
      load_ += part;
      moment_ += part * (half_length_ - panel.left - from_left);
    }
  }
}

Float RollingPressure::pressure(const Float& d) const {
  return d <= 0 || d >= 2 * half_length_ ? Float(0) : pressure(d, 2 * half_length_ - d);
}

Float RollingPressure::pressure(const Float& d, const Float& left) const {
  std::size_t panel = 0;
  while (panel + 1 < layout_.panels.size() && d >= layout_.panels[panel + 1].left) ++panel;
  const RollingPanel& here = layout_.panels[panel];
  const bool last = panel + 1 == layout_.panels.size();
  return in_panel(panel, d - here.left, last ? left : here.left + here.width - d);
}

/// The neighbours of the largest sample bracket the place where p is the same h = 2^{-bits/4} before and behind,
/// which is off by h^2, so that p there is off by h^4.
Float RollingPressure::peak_pressure() const { return pressure(nearly_place_of_peak()); }

/// To half of the digits, as a difference tells the slope.
Float RollingPressure::nearly_place_of_peak() const {
  constexpr int samples = 200;
  const auto place = [&](const Float& x) -> Float { return half_length_ * (1 - cos(pi() * x)); };
  int best = 1;
  Float largest = 0;
  for (int i = 1; i < samples; ++i) {
    const Float value = pressure(place(Float(i) / samples));
    if (value > largest) largest = value, best = i;
  }
  const Float step = ldexp(Float(1), -working_bits() / 4);
  const auto slope = [&](const Float& x) { return pressure(place(x + step)) - pressure(place(x - step)); };
  const auto zero = bracketed_root<Float>(slope, Float(best - 1) / samples + 2 * step,
                                          Float(best + 1) / samples - 2 * step, step * step);
  return place(zero ? *zero : Float(best) / samples);
}

Float RollingPressure::place_of_peak() const {
  const Float near = nearly_place_of_peak();
  // Within its panel the pressure is one analytic function; where the place is at a border, its neighbour's is the same
  // but for what both leave out.
  Float reach = 2 * half_length_;
  for (const RollingPanel& panel : layout_.panels) {
    if (near >= panel.left && near <= panel.left + panel.width) reach = panel.width / 2;
  }
  reach = std::min({reach, Float(near / 5), Float((2 * half_length_ - near) / 5)});
  const auto at = [&](const Float& d) { return pressure(d); };
  const auto slope = [&](const Float& d) { return local_slope(at, d, reach); };
  const Float beside = half_length_ / 1000;
  const Float low = std::max(Float(near - beside), Float(near / 2)),
              high = std::min(Float(near + beside), Float(half_length_ + near / 2));
  const auto zero =
      bracketed_root<Float>(slope, low, high, half_length_ * std::numeric_limits<Float>::epsilon() * 1e4);
  return zero ? *zero : near;
}

Float RollingPressure::response(const Float& d, RollingKernel& kernel) const {
  Float sum = 0;
  for (std::size_t p = 0; p < layout_.panels.size(); ++p)
    sum += pressures_[p].of(d - layout_.panels[p].left, kernel).front();
  return sum;
}

Float RollingPressure::normal_displacement(const Float& d, RollingKernel& kernel) const {
  if (d >= 0 && d <= 2 * half_length_)
    return edge_displacement_ + d * (2 * half_length_ - d) + 2 * offset_ * d;
  return response(d, kernel);
}

}  // namespace nipref::ref
