#include <algorithm>
#include <utility>

#include <nipref/ref/number/internal/chebyshev_sum.hpp>
#include <nipref/ref/viscoelastic_nip/internal/trace.hpp>

namespace nipref::ref {
namespace {

/// Longest piece times |rate|, so that e^(-rate w) is smooth on a piece.
constexpr int longest_piece_of_memory = 8;
/// From the degree of about 0.7 nats on, the Chebyshev coefficients of e^(4 x), as on such a piece, are below e^-nats.
constexpr double degree_of_memory = 0.7;

/// The place on a panel at which the polynomial's variable is xi, 0 .. 1.
Float place_at(const TracePanel& panel, const Float& xi) {
  if (panel.root == TracePanel::Root::none) return panel.left + panel.width * xi;
  if (panel.root == TracePanel::Root::left) return panel.left + panel.width * (xi * xi);
  return panel.left + panel.width - panel.width * (xi * xi);
}

Float variable_at(const TracePanel& panel, const Float& place) {
  const Float x = (place - panel.left) / panel.width;
  if (panel.root == TracePanel::Root::none) return x;
  return sqrt(std::max(Float(0), panel.root == TracePanel::Root::left ? x : Float(1 - x)));
}

}  // namespace

Trace::Trace(std::vector<TracePanel> panels, Function function, double nats)
    : nats_(nats), function_(std::move(function)) {
  int most = 0;
  for (TracePanel& panel : panels) {
    most = std::max(most, panel.terms);
    panels_.push_back({std::move(panel), {}});
  }
  rule_ = gauss_rule(most / 2 + static_cast<int>(degree_of_memory * nats_) + 4);
}

const std::vector<Float>& Trace::coefficients(const Panel& panel) const {
  if (panel.coefficients.empty()) {
    // The T_k are orthogonal on Chebyshev's points.
    std::vector<Float> chebyshev(static_cast<std::size_t>(panel.shape.terms));
    panel.coefficients.resize(chebyshev.size());
    Float product;
    for (const Float& xi : chebyshev_points(panel.shape.terms)) {
      const Float share = 2 * function_(place_at(panel.shape, xi)) / panel.shape.terms;
      chebyshev_values(2 * xi - 1, chebyshev);
      for (std::size_t k = 0; k < chebyshev.size(); ++k)
        add_product(panel.coefficients[k], product, share, chebyshev[k]);
    }
    panel.coefficients[0] /= 2;
  }
  return panel.coefficients;
}

Float Trace::end() const { return panels_.back().shape.left + panels_.back().shape.width; }

ComplexFloat Trace::piece(const Panel& panel, const Float& from, const Float& to, const Float& x,
                          const Weight& weight) const {
  const TracePanel& shape = panel.shape;
  const std::vector<Float>& known = coefficients(panel);
  const Float first = variable_at(shape, from), length = variable_at(shape, to) - first;
  ComplexFloat sum;
  for (std::size_t i = 0; i < rule_.size(); ++i) {
    const Float xi = first + length * rule_.from_left[i];
    Float value = chebyshev_sum(known, 2 * xi - 1) * rule_.weight[i];
    if (shape.root != TracePanel::Root::none) value *= 2 * xi;
    sum = sum + weight(x - place_at(shape, xi)) * value;
  }
  return sum * Float(abs(length) * shape.width);
}

/// Integrates by pieces upstream from x, each as long as a panel or as the memory allows.
ComplexFloat Trace::integral(const ComplexFloat& rate, const Float& x, bool forgets,
                             const Weight& weight) const {
  const Float size = abs(rate), longest = size == 0 ? Float(0) : Float(longest_piece_of_memory / size);
  const Float forgotten = rate.re == 0 ? Float(0) : Float(nats_ / rate.re);
  ComplexFloat sum;
  for (auto panel = panels_.rbegin(); panel != panels_.rend(); ++panel) {
    const Float& left = panel->shape.left;
    Float to = std::min(x, Float(left + panel->shape.width));
    while (to > left) {
      const bool is_forgotten = rate.re > 0 && x - to > forgotten;
      if (is_forgotten && forgets) return sum;
      const Float from = size == 0 || is_forgotten ? left : std::max(left, Float(to - longest));
      sum = sum + piece(*panel, from, to, x, weight);
      to = from;
    }
  }
  return sum;
}

ComplexFloat Trace::faded(const ComplexFloat& rate, const Float& x) const {
  return integral(rate, x, true, [&](const Float& way) { return exp(-(rate * way)); });
}

ComplexFloat Trace::faded_integral(const ComplexFloat& rate, const Float& x) const {
  return integral(rate, x, false, [&](const Float& way) { return faded_power(rate, way, 0); });
}

ComplexFloat faded_power(const ComplexFloat& rate, const Float& way, int k) {
  const ComplexFloat z = rate * way;
  Float power = 1;  // way^k/k!
  for (int j = 1; j <= k; ++j) power *= way / j;
  if (!(abs(z) < Float(1)))
    return (ComplexFloat(power) - (k == 0 ? exp(-z) : faded_power(rate, way, k - 1))) / rate;
  // way^(k + 1) sum_n (-z)^n/(n + k + 1)!
  const Float least = ldexp(Float(1), -working_bits() - 4);
  ComplexFloat sum, term(1);
  for (int n = 0; abs(term) > least; ++n) {
    sum = sum + term;
    term = term * (-z) / Float(n + k + 2);
  }
  return sum * Float(power * way / (k + 1));
}

}  // namespace nipref::ref
