#include <cmath>
#include <utility>

#include <nipref/fast/nip/internal/tractions.hpp>

namespace nipref::fast {

using Complex = std::complex<double>;

Tractions::Tractions(double half_length, std::vector<Panel> panels, bool is_complex, Complex exponent,
                     const std::vector<Complex>& layers)
    : half_length_(half_length),
      panels_(std::move(panels)),
      is_complex_(is_complex),
      exponent_(exponent),
      layers_(layers.begin(), layers.end()) {
  panels_.back().right = 2 * half_length - panels_.back().left;
  int column = 0;
  for (const Panel& panel : panels_) {
    first_.push_back(column);
    column += components() * (panel.terms + left_out);
  }
  first_.push_back(column);
  columns_ = column + static_cast<int>(2 * layers_.size());
}

std::vector<Complex> Tractions::layer_rates() const {
  std::vector<Complex> rates;
  for (const LayerPressure& layer : layers_) rates.push_back(layer.rate());
  return rates;
}

PanelBasis Tractions::basis(const Panel& panel) const {
  return {panel.at_end, panel.at_end && panel.about_middle, panel.at_end ? exponent_.imag() : 0};
}

int Tractions::degrees(const Panel& panel) { return (panel.about_middle ? 2 : 1) * (panel.terms + left_out); }

Tractions::Degrees Tractions::degrees_of(std::size_t p, int component) const {
  if (!panels_[p].about_middle) return {0, 1, 1};
  return {component, 2, component == 0 ? 1.0 : -1.0};
}

Eigen::MatrixXd Tractions::layers_at(const Eigen::ArrayXd& e) const {
  Eigen::MatrixXd values(e.size(), layer_columns());
  for (std::size_t j = 0; j < layers_.size(); ++j) {
    const auto column = static_cast<Eigen::Index>(2 * j);
    for (Eigen::Index i = 0; i < e.size(); ++i) {
      const Complex value = layers_[j](e[i]);
      values.row(i).segment<2>(column) << value.real(), -value.imag();
    }
  }
  return values;
}

void Tractions::add_sums(std::size_t p, const PanelBasis::Rows& integrals, const Eigen::RowVectorXd& of_p,
                         const Eigen::RowVectorXd& of_q,
                         Eigen::Ref<Eigen::RowVectorXd, 0, Eigen::InnerStride<>> row) const {
  const int count = panels_[p].terms + left_out;
  for (int component = 0; component < components(); ++component) {
    const Degrees degrees = degrees_of(p, component);
    auto sums = row.segment(column(p, component), count);
    const Eigen::RowVectorXd &same = component == 0 ? of_p : of_q, &other = component == 0 ? of_q : of_p;
    sums.noalias() += degrees.sign * (same * degrees.columns(integrals.real, count));
    if (integrals.imaginary.size() == 0 || !is_complex_) continue;
    const double sign = component == 0 ? degrees.sign : -degrees.sign;
    sums.noalias() += sign * (other * degrees.columns(integrals.imaginary, count));
  }
}

std::vector<double> Tractions::matching_points() const {
  std::vector<double> points;
  points.reserve(static_cast<std::size_t>(columns_));
  for (const Panel& panel : panels_) {
    for (const double at : *points_of(panel).at()) points.push_back(panel.left + panel.width() * at);
  }
  return points;
}

std::size_t Tractions::panel_of(double e) const {
  std::size_t p = 0;
  while (p + 1 < panels_.size() && e > panels_[p].right) ++p;
  return p;
}

Eigen::MatrixXd Tractions::values(double e) const {
  const std::size_t p = panel_of(e);
  const Panel& panel = panels_[p];
  const double right = panel.about_middle ? 2 * half_length_ - panel.left : panel.right;
  const auto at = [&](double distance) { return Eigen::ArrayXd::Constant(1, distance / panel.width()); };
  const PanelBasis::Rows basis = this->basis(panel).values(at(e - panel.left), at(right - e), degrees(panel));
  const Eigen::RowVectorXd one = Eigen::RowVectorXd::Ones(1), none = Eigen::RowVectorXd::Zero(1);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(2, columns_);
  add_sums(p, basis, one, none, result.row(0));
  add_sums(p, basis, none, one, result.row(1));
  if (panel.at_end)
    result.rightCols(layer_columns()).rowwise() += 0.5 * layers_at(Eigen::ArrayXd::Constant(1, e)).row(0);
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
    double before = second, now = first, total = 0;  // T_-1 and T_0, or of odd terms T_-1 and T_1
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

/// A product rule of two points is exact for 1 and y.
Eigen::MatrixXd Tractions::integrals() const {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(2, columns_);
  for (std::size_t p = 0; p < panels_.size(); ++p) {
    const Panel& panel = panels_[p];
    const auto rule = product_rule(basis(panel), 2, degrees(panel));
    const double twice = panel.about_middle ? 1 : 2;
    const Eigen::RowVectorXd ones = Eigen::RowVectorXd::Constant(rule->at.size(), twice * panel.width()),
                             none = Eigen::RowVectorXd::Zero(rule->at.size());
    const Eigen::RowVectorXd y =
        ones.array() * ((half_length_ - panel.left) - panel.width() * rule->at.transpose());
    add_sums(p, rule->weight, ones, none, result.row(0));
    add_sums(p, rule->weight, none, y, result.row(1));
  }
  if (!layers_.empty()) result.rightCols(layer_columns()) = integrals_of_layers();
  return result;
}

}  // namespace nipref::fast
