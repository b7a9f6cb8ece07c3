#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <nipref/fast/elastic_nip/internal/operator.hpp>
#include <nipref/fast/elastic_nip/internal/panels.hpp>
#include <nipref/fast/nip/internal/expansion_tail.hpp>
#include <nipref/fast/number/internal/chebyshev.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {
namespace {

constexpr double pi = std::numbers::pi;
using Complex = std::complex<double>;

std::vector<double> panel_breaks(double half_length, int panels) {
  std::vector<double> breaks{0};
  for (int i = 1; i <= panels; ++i) breaks.push_back(std::ldexp(half_length, i - panels));
  return breaks;
}

class PanelContact : public HalfContact {
 public:
  PanelContact(double length, data::Friction friction, double poisson, const PanelLayout& layout)
      : friction_(friction == data::Friction::full), terms_(layout.terms), panels_(layout.panels) {
    half_length = length;
    breaks = panel_breaks(length, layout.panels);
    if (friction_) exponent_ = {0.5, -std::atanh(beta(poisson)) / pi};
  }

  static double beta(double poisson) { return (1 - 2 * poisson) / (2 * (1 - poisson)); }

  [[nodiscard]] Traction traction(double e) const override {
    const int panel = panel_of(e);
    std::vector<double> polynomials(static_cast<std::size_t>(terms_));
    const double x = fraction(panel, e);
    internal::shifted_chebyshev(x, polynomials);
    Complex sum = 0;
    for (int k = 0; k < terms_; ++k) sum += coefficient(panel, k) * polynomials[static_cast<std::size_t>(k)];
    sum *= end_factor(panel, x);
    return {sum.real(), sum.imag()};
  }

  [[nodiscard]] Traction tail_at(double e) const override {
    return tails_[static_cast<std::size_t>(panel_of(e))];
  }

  [[nodiscard]] SolutionAndTwins solutions(const ElasticNipOperator& from, CountedKernels& kernels) const {
    const std::vector<double> points = matching_points();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size(), size());
    Eigen::VectorXd gap = Eigen::VectorXd::Zero(size());
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
      const double e = points[static_cast<std::size_t>(i)];
      for (int panel = 0; panel < panels_; ++panel) add_panel(from, e, panel, i, matrix);
      gap(i) = e * (2 * half_length - e);
      matrix(i, size() - components()) = -1;
      if (friction_) matrix(i + per_component() + 1, size() - 1) = -(half_length - e);
    }
    kernels.count_system(size());
    return solution_and_twins(matrix, sizes(matrix, from.beta()), gap);
  }
  void take_tails(const SolutionAndTwins& found) {
    const std::vector<double> all = expansion_tails(found, terms_, panels_ * components());
    tail = std::ranges::max(all);
    const std::size_t panels = breaks.size() - 1;
    for (std::size_t panel = 0; panel < panels; ++panel)
      tails_.push_back({all[panel], friction_ ? all[panels + panel] : 0});
    // The complex factor at the end mixes the two components.
    tails_[0].pressure = tails_[0].shear = std::max(tails_[0].pressure, tails_[0].shear);
  }
  void take(const Eigen::VectorXd& unknowns, double tolerance) {
    unknowns_ = unknowns;
    edge_displacement = unknowns_(size() - components());
    if (friction_) creep = unknowns_(size() - 1);
    load = 2 * half_load(tolerance);
  }

 private:
  /// The sizes of the numbers from which the entries are computed (measured). Some of their many roundings average out,
  /// less so in long contacts, where near and far contributions cancel. In the coupling of pressure and shear the two
  /// sides of a point cancel, and the roundings of a hundred nodes remain.
  [[nodiscard]] Eigen::MatrixXd sizes(const Eigen::MatrixXd& matrix, double beta) const {
    Eigen::MatrixXd size = std::min(1.0, 0.5 + half_length / 50) * matrix.cwiseAbs();
    if (!friction_) return size;
    const int rows = per_component() + 1;
    for (int panel = 0; panel < panels_; ++panel) {
      const double coupled = 0.2 * (0.25 + beta / 2) * (right(panel) - left(panel));
      for (const auto& [row, at] : {std::pair{0, per_component()}, std::pair{rows, 0}}) {
        auto block = size.block(row, at + column(panel, 0), rows, terms_);
        block = block.cwiseMax(coupled).eval();
      }
    }
    return size;
  }

  [[nodiscard]] int panel_of(double e) const {
    int panel = 0;
    while (panel + 1 < panels_ && e > right(panel)) ++panel;
    return panel;
  }
  [[nodiscard]] double left(int panel) const { return breaks[static_cast<std::size_t>(panel)]; }
  [[nodiscard]] double right(int panel) const { return breaks[static_cast<std::size_t>(panel) + 1]; }
  [[nodiscard]] double fraction(int panel, double e) const {
    return (e - left(panel)) / (right(panel) - left(panel));
  }
  [[nodiscard]] Complex end_factor(int panel, double x) const {
    if (panel > 0) return 1;
    if (!friction_) return std::sqrt(x);
    return x > 0 ? std::exp(exponent_ * std::log(x)) : 0;
  }

  // Unknowns: the real parts of all coefficients, with friction their imaginary parts, then the edge
  // displacement and with friction the creep.
  [[nodiscard]] int per_component() const { return panels_ * terms_; }
  [[nodiscard]] int components() const { return friction_ ? 2 : 1; }
  [[nodiscard]] int size() const { return components() * (per_component() + 1); }
  [[nodiscard]] int column(int panel, int k) const { return panel * terms_ + k; }
  [[nodiscard]] Complex coefficient(int panel, int k) const {
    const int at = column(panel, k);
    return {unknowns_(at), friction_ ? unknowns_(per_component() + at) : 0};
  }

  [[nodiscard]] std::vector<double> matching_points() const {
    std::vector<double> points;
    for (int panel = 0; panel < panels_; ++panel) {
      const int count = terms_ + (panel == 0 ? 1 : 0);
      for (int i = 0; i < count; ++i) {
        const double x = internal::shifted_chebyshev_zero(i, count);
        points.push_back(left(panel) + (right(panel) - left(panel)) * x);
      }
    }
    return points;
  }

  /// One panel's part of the rows of one matching point: normal displacement at `row`, tangential below.
  void add_panel(const ElasticNipOperator& from, double point, int panel, int row,
                 Eigen::MatrixXd& matrix) const {
    const auto nodes =
        from.influences(point, left(panel), right(panel), {true, friction_, friction_, friction_},
                        panel > 0 ? std::optional(terms_ - 1) : std::nullopt);
    const auto count = static_cast<Eigen::Index>(nodes.size());
    Eigen::ArrayXd x(count);
    // The influences of each node, times the real and the imaginary part of its factor.
    Eigen::MatrixXd kernels = Eigen::MatrixXd::Zero(friction_ ? 8 : 1, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Influence& node = nodes[static_cast<std::size_t>(i)];
      x(i) = fraction(panel, node.e);
      const Complex factor = node.weight * end_factor(panel, x(i));
      kernels(0, i) = factor.real() * node.normal_by_pressure;
      if (!friction_) continue;
      const Eigen::Vector4d all{node.normal_by_pressure, node.normal_by_shear, node.tangential_by_pressure,
                                node.tangential_by_shear};
      kernels.col(i) << factor.real() * all, factor.imag() * all;
    }
    const Eigen::MatrixXd sums = product(kernels, polynomials(x));
    const int at = column(panel, 0);
    matrix.row(row).segment(at, terms_) = sums.row(0);
    if (!friction_) return;
    // The coefficient i multiplies the basis: pressure -Im, shear Re.
    const int tangential = row + per_component() + 1, imaginary = per_component() + at;
    matrix.row(row).segment(at, terms_) += sums.row(5);
    matrix.row(row).segment(imaginary, terms_) = sums.row(1) - sums.row(4);
    matrix.row(tangential).segment(at, terms_) = sums.row(2) + sums.row(7);
    matrix.row(tangential).segment(imaginary, terms_) = sums.row(3) - sums.row(6);
  }
  /// T_k(2x - 1), a row for each x.
  [[nodiscard]] Eigen::MatrixXd polynomials(const Eigen::ArrayXd& x) const {
    Eigen::MatrixXd values = Eigen::MatrixXd::Ones(x.size(), terms_);
    if (terms_ > 1) values.col(1) = 2 * x - 1;
    for (int k = 2; k < terms_; ++k)
      values.col(k).array() =
          2 * values.col(1).array() * values.col(k - 1).array() - values.col(k - 2).array();
    return values;
  }

  [[nodiscard]] double half_load(double tolerance) const {
    double sum = 0;
    for (const UnitNode& node : double_exponential_rule(tolerance)) {
      for (int panel = 0; panel < panels_; ++panel) {
        const double width = right(panel) - left(panel);
        sum += width * node.weight * traction(left(panel) + width * node.from_left).pressure;
      }
    }
    return sum;
  }

  bool friction_;
  int terms_;
  int panels_;
  Complex exponent_ = 0.5;
  Eigen::VectorXd unknowns_;
  std::vector<Traction> tails_;
};

}  // namespace

std::unique_ptr<HalfContact> panel_contact(double half_length, data::Friction friction, double poisson,
                                           const PanelLayout& layout, CountedKernels& kernels) {
  const bool with_friction = friction == data::Friction::full;
  const ElasticNipOperator from(half_length, with_friction ? PanelContact::beta(poisson) : 0,
                                layout.tolerance, kernels);
  const PanelContact unsolved(half_length, friction, poisson, layout);
  const SolutionAndTwins found = unsolved.solutions(from, kernels);
  const auto solved = [&](const Eigen::VectorXd& unknowns) {
    auto contact = std::make_unique<PanelContact>(half_length, friction, poisson, layout);
    contact->take(unknowns, layout.tolerance);
    return contact;
  };
  auto contact = solved(found.solution);
  contact->take_tails(found);
  for (const auto& twin : found.twins.colwise()) contact->twins.push_back(solved(twin));
  return contact;
}

}  // namespace nipref::fast
