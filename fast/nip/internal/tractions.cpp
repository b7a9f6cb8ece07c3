#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include <nipref/fast/nip/internal/layer.hpp>
#include <nipref/fast/nip/internal/tractions.hpp>
#include <nipref/fast/number/internal/cache.hpp>
#include <nipref/fast/number/internal/chebyshev.hpp>
#include <nipref/fast/number/internal/gauss_legendre.hpp>

namespace nipref::fast {
namespace {

using Complex = std::complex<double>;

/// Distances from where something decays with these rates, at which it is cut. It is analytic for a few lengths, and falls
/// like a power from there: the rule resolves a factor of 150 in the distance. What oscillates does so until it has decayed.
std::vector<double> cuts(const std::vector<Complex>& rates, double farthest) {
  constexpr double few_lengths = 6, radians = 20, decayed = 40, resolved_ratio = 150;
  std::vector<double> result;
  for (const Complex& rate : rates) {
    const double size = std::abs(rate);
    double cut = few_lengths / size;
    for (; rate.imag() != 0 && rate.real() * cut < decayed && cut < farthest;
         cut += std::min(cut, radians / size))
      result.push_back(cut);
    for (; cut < 0.5 * farthest; cut *= resolved_ratio) result.push_back(cut);
  }
  return result;
}

/// Whether something that oscillates has not decayed at the distance, and is no polynomial over the width.
bool oscillates(const std::vector<Complex>& rates, double distance, double width) {
  return std::ranges::any_of(rates, [&](const Complex& rate) {
    return rate.imag() != 0 && rate.real() * distance < 40 && std::abs(rate) * width > 5;
  });
}

/// Of a function of a degree whose singularities are at least the width of its interval from it: at +-3 for [-1, 1], on an
/// ellipse of 3 + sqrt 8.
std::shared_ptr<const GaussRule> cached_gauss(double degree, double tolerance) {
  static Cache<int, GaussRule> rules(gauss_legendre);
  return rules.at(static_cast<int>(degree / 2 + 2 - std::log(tolerance) / 3.5));
}

/// T_0 .. T_(count - 1), a row for each t.
Eigen::MatrixXd chebyshev(const Eigen::ArrayXd& t, int count) {
  Eigen::MatrixXd values(t.size(), count);
  values.col(0).setOnes();
  if (count > 1) values.col(1) = t;
  for (int k = 2; k < count; ++k)
    values.col(k).array() = 2 * t * values.col(k - 1).array() - values.col(k - 2).array();
  return values;
}

/// Re g and Im g, each with a weight that depends on alpha, as two functionals.
template <class Weights>
Tractions::Kernel both_parts(const Weights& weights) {
  return {
      2, false, {}, [weights](std::span<const double> alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q) {
        on_p = on_q = Eigen::MatrixXd::Zero(2, static_cast<Eigen::Index>(alpha.size()));
        for (std::size_t i = 0; i < alpha.size(); ++i) {
          const auto [on_real, on_imaginary] = weights(alpha[i]);
          on_p(0, static_cast<Eigen::Index>(i)) = on_real;
          on_q(1, static_cast<Eigen::Index>(i)) = on_imaginary;
        }
      }};
}

std::shared_ptr<const std::vector<UnitNode>> cached_rule(double tolerance) {
  static Cache<double, std::vector<UnitNode>> rules(
      [](const double& key) { return double_exponential_rule(key); });
  return rules.at(tolerance);
}

Eigen::ArrayXd array(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::ArrayXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

Tractions::Tractions(double half_length, std::vector<Panel> panels, bool is_complex, Complex exponent,
                     const std::vector<Complex>& layers)
    : half_length_(half_length),
      panels_(std::move(panels)),
      is_complex_(is_complex),
      exponent_(exponent),
      layers_(layers.begin(), layers.end()) {
  int column = 0;
  for (const Panel& panel : panels_) {
    first_.push_back(column);
    column += components() * (panel.terms + left_out);
  }
  first_.push_back(column);
  columns_ = column + static_cast<int>(2 * layers_.size());
}

void Tractions::Nodes::clear() {
  for (std::vector<double>* values : {&e, &other, &weight, &alpha}) values->clear();
  on_this_half = 0;
}

void Tractions::Nodes::grow(std::size_t count) {
  for (std::vector<double>* values : {&e, &other, &weight, &alpha}) values->resize(values->size() + count);
}

/// `singular` is outside the piece or at one of its ends. By Gauss's rule where it and the ends of the contact are farther
/// than the piece is wide.
void Tractions::append_piece(double from, double to, double singular, bool mirrored,
                             const std::vector<UnitNode>& rule, double tolerance, Nodes& nodes) const {
  const double width = to - from, beyond = 2 * half_length_ - to, sign = mirrored ? -1 : 1;
  std::size_t i = nodes.e.size();
  const auto append = [&](double from_left, double from_right, double weight) {
    const double distance =
        singular <= from ? (from - singular) + width * from_left : -((singular - to) + width * from_right);
    nodes.e[i] = from + width * from_left;
    nodes.other[i] = beyond + width * from_right;
    nodes.weight[i] = width * weight;
    nodes.alpha[i] = sign * distance;
    ++i;
  };
  if (std::min({from, beyond, std::max(from - singular, singular - to)}) >= width && width <= 8) {
    // Polynomials of a piece that is so far from the ends have no more degrees than that.
    constexpr double degree_of_piece = 40;
    const auto gauss = cached_gauss(degree_of_piece, tolerance);
    nodes.grow(gauss->at.size());
    for (std::size_t k = 0; k < gauss->at.size(); ++k)
      append(gauss->at[k], 1 - gauss->at[k], gauss->weight[k]);
    return;
  }
  nodes.grow(rule.size());
  for (const UnitNode& node : rule) append(node.from_left, node.from_right, node.weight);
}

/// A panel that is near the singularity, or ends where the tractions do, is integrated by the double-exponential rule,
/// others by Gauss's. Pieces end where the kernel is singular and where it has decayed.
void Tractions::append_panel(const Panel& panel, double singular, bool mirrored, const Kernel& kernel,
                             double reach, const std::vector<UnitNode>& rule, double tolerance,
                             Nodes& nodes) const {
  const double gap = std::max(panel.left - singular, singular - panel.right);
  if (kernel.decays && gap > reach) return;
  const bool is_far = gap >= panel.width() && panel.width() <= 8;
  if (is_far && !oscillates(kernel.rates, gap, panel.width()) &&
      !(panel.at_end && (panel.about_middle || exponent_.imag() != 0 || !layers_.empty()))) {
    const int degree =
        (panel.at_end ? 2 : 1) * (panel.terms + left_out) + (panel.about_middle ? panel.terms : 0);
    const auto gauss = cached_gauss(degree + 2 * panel.width(), tolerance);
    std::size_t next = nodes.e.size();
    nodes.grow(gauss->at.size());
    for (std::size_t i = 0; i < gauss->at.size(); ++i, ++next) {
      const double xi = gauss->at[i], x = panel.at_end ? xi * xi : xi, slope = panel.at_end ? 2 * xi : 1;
      const double e = panel.left + panel.width() * x, distance = e - singular;
      nodes.e[next] = e;
      nodes.other[next] = 2 * half_length_ - e;
      nodes.weight[next] = panel.width() * slope * gauss->weight[i];
      nodes.alpha[next] = mirrored ? -distance : distance;
    }
    return;
  }
  std::vector<double> ends{panel.left, panel.right};
  for (const double cut : {singular, singular - 5, singular + 5, singular - reach, singular + reach}) {
    if (panel.left < cut && cut < panel.right && (cut == singular || panel.width() > 8)) ends.push_back(cut);
  }
  for (const double cut : cuts(kernel.rates, std::max(gap, 0.0) + panel.width())) {
    for (const double end : {singular - cut, singular + cut})
      if (panel.left < end && end < panel.right) ends.push_back(end);
  }
  cut_for_layers(panel, ends);
  std::ranges::sort(ends);
  ends.erase(std::ranges::unique(ends).begin(), ends.end());
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (kernel.decays && (ends[i] <= singular - reach || ends[i - 1] >= singular + reach)) continue;
    append_piece(ends[i - 1], ends[i], singular, mirrored, rule, tolerance, nodes);
  }
}

void Tractions::cut_for_layers(const Panel& panel, std::vector<double>& ends) const {
  if (!panel.at_end) return;
  for (const double cut : cuts(layer_rates(), panel.right)) ends.push_back(cut);
}

std::vector<Complex> Tractions::layer_rates() const {
  std::vector<Complex> rates;
  for (const LayerPressure& layer : layers_) rates.push_back(layer.rate());
  return rates;
}

Tractions::Basis Tractions::basis(std::size_t p, const Nodes& nodes) const {
  const Panel& panel = panels_[p];
  const Eigen::ArrayXd e = array(nodes.e), other = array(nodes.other);
  const int terms = panel.terms + left_out;
  Basis result;
  result.real = Eigen::ArrayXd::Ones(e.size());
  result.imaginary = Eigen::ArrayXd::Zero(e.size());
  if (panel.about_middle) {
    // T_2k(t) = T_k(2 t^2 - 1), and T_2k+1 obeys the same recurrence from T_1 and T_-1 = T_1 on.
    const Eigen::ArrayXd t = (other - e) / panel.width();
    const Eigen::ArrayXd doubled = 2 * t.square() - 1;
    result.even = chebyshev(doubled, terms);
    if (is_complex_) {
      result.odd.resize(t.size(), terms);
      result.odd.col(0) = t;
      result.odd.col(1).array() = t * (2 * doubled - 1);
      for (int k = 2; k < terms; ++k)
        result.odd.col(k).array() =
            2 * doubled * result.odd.col(k - 1).array() - result.odd.col(k - 2).array();
    }
  } else {
    result.even = chebyshev(2 * (e - panel.left) / panel.width() - 1, terms);
    if (is_complex_) result.odd = result.even;
  }
  if (panel.at_end) {
    const Eigen::ArrayXd ratio = panel.about_middle ? (e / other).eval() : (e / panel.right).eval();
    result.real = panel.about_middle ? ((e * other).sqrt() / half_length_).eval() : ratio.sqrt();
    if (exponent_.imag() != 0) {
      const Eigen::ArrayXd angle = (ratio > 0).select(exponent_.imag() * ratio.max(1e-300).log(), 0.0);
      result.imaginary = result.real * angle.sin();
      result.real *= angle.cos();
    }
    result.layers.resize(e.size(), static_cast<Eigen::Index>(2 * layers_.size()));
    for (std::size_t j = 0; j < layers_.size(); ++j) {
      for (Eigen::Index i = 0; i < e.size(); ++i) {
        const Complex value = layers_[j](e(i));
        result.layers(i, static_cast<Eigen::Index>(2 * j)) = value.real();
        result.layers(i, static_cast<Eigen::Index>(2 * j + 1)) = -value.imag();
      }
    }
  }
  return result;
}

void Tractions::add_rows(std::size_t p, const Nodes& nodes, const Kernel& kernel, bool trailing,
                         Eigen::Ref<Eigen::MatrixXd> rows) const {
  const auto count = static_cast<Eigen::Index>(nodes.e.size());
  const int terms = panels_[p].terms + left_out;
  const Basis basis = this->basis(p, nodes);
  Eigen::MatrixXd on_p, on_q;
  std::vector<double> alpha = nodes.alpha;
  if (trailing) std::ranges::transform(alpha, alpha.begin(), std::negate{});
  kernel.at(alpha, on_p, on_q);
  const Eigen::ArrayXd weight = array(nodes.weight);
  Eigen::ArrayXd signed_weight = weight;
  const auto on_this_half = static_cast<Eigen::Index>(nodes.on_this_half);
  if (trailing)
    signed_weight.head(on_this_half) *= -1;
  else
    signed_weight.tail(count - on_this_half) *= -1;
  for (int i = 0; i < kernel.functionals; ++i) {
    const Eigen::ArrayXd wp = weight * on_p.row(i).transpose().array();
    if (!is_complex_) {
      rows.row(i).segment(column(p, 0), terms).noalias() +=
          (wp * basis.real).matrix().transpose() * basis.even;
      continue;
    }
    const Eigen::ArrayXd wq = signed_weight * on_q.row(i).transpose().array();
    rows.row(i).segment(column(p, 0), terms).noalias() +=
        (wp * basis.real + wq * basis.imaginary).matrix().transpose() * basis.even;
    rows.row(i).segment(column(p, 1), terms).noalias() +=
        (wq * basis.real - wp * basis.imaginary).matrix().transpose() * basis.odd;
    if (basis.layers.cols() > 0)
      rows.row(i).tail(basis.layers.cols()).noalias() +=
          (0.5 * (wp + wq)).matrix().transpose() * basis.layers;
  }
}

Eigen::MatrixXd Tractions::rows(std::span<const double> places, bool trailing, const Kernel& kernel,
                                double tolerance) const {
  Eigen::MatrixXd result =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(places.size()) * kernel.functionals, columns_);
  const auto rule = cached_rule(tolerance);
  const double reach = -std::log(tolerance) / 2.1;
  Nodes nodes;
  for (std::size_t place = 0; place < places.size(); ++place) {
    for (std::size_t p = 0; p < panels_.size(); ++p) {
      nodes.clear();
      append_panel(panels_[p], places[place], false, kernel, reach, *rule, tolerance, nodes);
      nodes.on_this_half = nodes.e.size();
      if (!panels_[p].about_middle)
        append_panel(panels_[p], 2 * half_length_ - places[place], true, kernel, reach, *rule, tolerance,
                     nodes);
      if (nodes.e.empty()) continue;
      add_rows(p, nodes, kernel, trailing,
               result.middleRows(static_cast<Eigen::Index>(place) * kernel.functionals, kernel.functionals));
    }
  }
  return result;
}

std::size_t Tractions::panel_of(double e) const {
  std::size_t p = 0;
  while (p + 1 < panels_.size() && e > panels_[p].right) ++p;
  return p;
}

Eigen::MatrixXd Tractions::values(double e) const {
  Nodes nodes;
  nodes.e = {e};
  nodes.other = {2 * half_length_ - e};
  nodes.weight = {1};
  nodes.alpha = {0};
  nodes.on_this_half = 1;
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(2, columns_);
  add_rows(panel_of(e), nodes, both_parts([](double) { return std::array{1.0, 1.0}; }), false, result);
  return result;
}

Complex Tractions::value(double e, const Eigen::VectorXd& coefficients) const {
  const std::size_t p = panel_of(e);
  const Panel& panel = panels_[p];
  const double other = 2 * half_length_ - e;
  const double t =
      panel.about_middle ? (other - e) / panel.width() : 2 * (e - panel.left) / panel.width() - 1;
  const double x = panel.about_middle ? 2 * t * t - 1 : t;
  const auto sum = [&](int component, double first, double second) {
    double before = second, now = first, total = 0;  // T_-1 and T_0, or T_-1 and T_1 of odd ones
    for (int k = 0; k < panel.terms; ++k) {
      total += coefficients(column(p, component) + k) * now;
      now = 2 * x * now - std::exchange(before, now);
    }
    return total;
  };
  Complex g{sum(0, 1, x), is_complex_ ? (panel.about_middle ? sum(1, t, t) : sum(1, 1, x)) : 0};
  if (panel.at_end) {
    const double ratio = panel.about_middle ? e / other : e / panel.right;
    g *= panel.about_middle ? std::sqrt(e * other) / half_length_ : std::sqrt(ratio);
    if (exponent_.imag() != 0 && ratio > 0) g *= std::polar(1.0, exponent_.imag() * std::log(ratio));
    for (std::size_t j = 0; j < layers_.size(); ++j) {
      const Complex layer = layers_[j](e);
      const auto at = first_.back() + static_cast<Eigen::Index>(2 * j);
      g += Complex(0.5, 0.5) * (layer.real() * coefficients(at) - layer.imag() * coefficients(at + 1));
    }
  }
  return g;
}

/// The nodes' alpha is their y.
Eigen::MatrixXd Tractions::integrals() const {
  constexpr double tolerance = 1e-16;
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(2, columns_);
  const auto rule = cached_rule(tolerance);
  for (std::size_t p = 0; p < panels_.size(); ++p) {
    const Panel& panel = panels_[p];
    std::vector<double> ends{panel.left, panel.about_middle ? half_length_ : panel.right};
    cut_for_layers(panel, ends);
    std::ranges::sort(ends);
    Nodes nodes;
    for (std::size_t i = 1; i < ends.size(); ++i)
      append_piece(ends[i - 1], ends[i], half_length_, true, *rule, tolerance, nodes);
    nodes.on_this_half = nodes.e.size();
    add_rows(p, nodes, both_parts([](double y) { return std::array{2.0, 2 * y}; }), false, result);
  }
  return result;
}

std::vector<double> Tractions::matching_points(int more) const {
  std::vector<double> points;
  for (const Panel& panel : panels_) {
    const int count = panel.terms + (panel.at_end ? more : 0);
    for (int i = 0; i < count; ++i) {
      // About the middle half of the zeros of T_2count.
      const double x = internal::shifted_chebyshev_zero(i, panel.about_middle ? 2 * count : count);
      points.push_back(panel.left + panel.width() * x);
    }
  }
  return points;
}

}  // namespace nipref::fast
