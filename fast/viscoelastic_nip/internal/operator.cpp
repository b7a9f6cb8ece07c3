#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <span>

#include <nipref/fast/nip/internal/stretch.hpp>
#include <nipref/fast/number/internal/cache.hpp>
#include <nipref/fast/number/internal/gauss_legendre.hpp>
#include <nipref/fast/viscoelastic_nip/internal/operator.hpp>

namespace nipref::fast {
namespace {

constexpr double pi = std::numbers::pi;

bool decays(ViscoelasticKernel kernel) {
  return kernel == ViscoelasticKernel::normal || kernel == ViscoelasticKernel::stretch;
}

/// Far ahead of a load.
double limit(ViscoelasticKernel kernel) {
  if (kernel == ViscoelasticKernel::tangential) return 0.25;
  return kernel == ViscoelasticKernel::sign ? 0.5 : 0;
}

/// alpha increases towards the leading side, e away from the end: +1 on the trailing half.
double orientation(const ViscoelasticPanel& panel) { return panel.half == Half::leading ? -1 : 1; }

/// T_j(2 xi - 1), j = 0 .. degree, for each xi one row.
void chebyshev_rows(std::span<const double> xi, int degree, Eigen::MatrixXd& rows) {
  const Eigen::Map<const Eigen::ArrayXd> x(xi.data(), static_cast<Eigen::Index>(xi.size()));
  rows.resize(x.size(), degree + 1);
  rows.col(0).setOnes();
  rows.col(1) = 2 * x - 1;
  for (int j = 2; j <= degree; ++j)
    rows.col(j).array() = 2 * rows.col(1).array() * rows.col(j - 1).array() - rows.col(j - 2).array();
}

/// Of a memory that swings: a piece holds few radians more than it has faded by, in nats, for of the rule's 37 nats
/// each radian costs a third.
void append_waves(std::complex<double> rate, double last, std::vector<double>& ends) {
  const double frequency = std::fabs(rate.imag());
  double cut = 0;
  while (frequency * (last - cut) > 8 + rate.real() * cut) {
    cut += (8 + rate.real() * cut) / frequency;
    ends.push_back(cut);
  }
}

}  // namespace

ViscoelasticOperator::ViscoelasticOperator(const ViscoelasticLayout& layout, double tolerance,
                                           CountedKernels& kernels)
    : layout_(layout),
      tolerance_(tolerance),
      reach_(-std::log(tolerance) / 2.1),
      rule_(double_exponential_rule(tolerance)),
      kernels_(kernels) {}

/// The point's e, counted from the end of the panel's half.
double ViscoelasticOperator::coordinate(ContactPlace point, const ViscoelasticPanel& panel) const {
  return point.half == panel.half ? point.e : 2 * layout_.half_length() - point.e;
}

/// So far that the kernel is as smooth on the panel as the pressure.
bool ViscoelasticOperator::is_far(double at, const ViscoelasticPanel& panel) const {
  const double gap = std::max(panel.left - at, at - (panel.left + panel.width));
  return panel.width <= 8 && gap >= panel.width;
}

/// Pieces end where the kernel is singular, and where it has decayed, for it may be thousands of
/// half-thicknesses to the panel's ends.
void ViscoelasticOperator::append_near_nodes(double at, const ViscoelasticPanel& panel,
                                             ViscoelasticKernel kernel, Nodes& nodes) const {
  const double right = panel.left + panel.width;
  std::vector<double> ends{panel.left, right};
  for (const double cut : {at, at - 5, at + 5, at - reach_, at + reach_}) {
    if (panel.left < cut && cut < right && (cut == at || panel.width > 8)) ends.push_back(cut);
  }
  std::ranges::sort(ends);
  ends.erase(std::ranges::unique(ends).begin(),
             ends.end());  // a piece without length would hold the point itself
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double from = ends[i - 1], to = ends[i], width = to - from;
    if (decays(kernel) && (to <= at - reach_ || from >= at + reach_)) continue;
    for (const UnitNode& node : rule_) {
      const double x = from == panel.left && node.from_left < node.from_right
                           ? width / panel.width * node.from_left
                           : (from - panel.left + width * node.from_left) / panel.width;
      const double distance =
          at <= from ? (from - at) + width * node.from_left : -((at - to) + width * node.from_right);
      nodes.xi.push_back(panel.xi(std::min(x, 1.0)));
      nodes.weight.push_back(width * node.weight);
      nodes.alpha.push_back(-orientation(panel) * distance);
    }
  }
}

std::vector<double> ViscoelasticOperator::values(ViscoelasticKernel kernel,
                                                 const std::vector<double>& alpha) {
  std::vector<double> result;
  if (kernel == ViscoelasticKernel::stretch) {
    for (const double a : alpha) result.push_back(stretch_over_pi(a));
    return result;
  }
  if (kernel == ViscoelasticKernel::normal) {
    result = kernels_.I1(alpha);
  } else if (kernel == ViscoelasticKernel::tangential) {
    result = kernels_.I3(alpha);
  } else {
    for (const double a : alpha) result.push_back(a == 0 ? 0 : std::copysign(pi / 2, a));
  }
  for (double& value : result) value /= pi;
  return result;
}

void ViscoelasticOperator::near_moments(const std::vector<double>& at, const std::vector<std::size_t>& rows,
                                        const ViscoelasticPanel& panel, ViscoelasticKernel kernel,
                                        Eigen::MatrixXd& result) {
  if (rows.empty()) return;
  Nodes nodes;
  std::vector<std::size_t> ends;
  for (const std::size_t row : rows) {
    append_near_nodes(at[row], panel, kernel, nodes);
    ends.push_back(nodes.xi.size());
  }
  std::vector<double> weighted = values(kernel, nodes.alpha);
  std::ranges::transform(weighted, nodes.weight, weighted.begin(), std::multiplies{});
  const Eigen::Map<const Eigen::RowVectorXd> factors(weighted.data(),
                                                     static_cast<Eigen::Index>(weighted.size()));
  const std::span<const double> xi(nodes.xi);
  Eigen::MatrixXd polynomials;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t count = ends[i] - begin;
    chebyshev_rows(xi.subspan(begin, count), layout_.degree(panel), polynomials);
    result.row(static_cast<Eigen::Index>(rows[i])).noalias() =
        factors.segment(static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(count)) * polynomials;
    begin = ends[i];
  }
}

void ViscoelasticOperator::far_moments(const std::vector<double>& at, const std::vector<std::size_t>& rows,
                                       const ViscoelasticPanel& panel, ViscoelasticKernel kernel,
                                       Eigen::MatrixXd& result) {
  if (rows.empty()) return;
  const int degree = layout_.degree(panel);
  // The kernel's singularity is at least the panel's width away: in x - 1/2 at 3/2, an ellipse of 3 + sqrt 8.
  const int count = static_cast<int>(degree / 2.0 + 2 - std::log(tolerance_) / 3.5 + panel.width);
  static Cache<int, GaussRule> rules(gauss_legendre);
  const auto rule = rules.at(count);
  Eigen::MatrixXd weighted;
  chebyshev_rows(rule->at, degree, weighted);
  for (int g = 0; g < count; ++g) {
    const auto node = static_cast<std::size_t>(g);
    weighted.row(g) *= rule->weight[node] * panel.width * panel.slope(rule->at[node]);
  }
  std::vector<double> alpha;
  for (const std::size_t row : rows) {
    for (const double xi : rule->at)
      alpha.push_back(orientation(panel) * (at[row] - panel.left - panel.width * panel.x(xi)));
  }
  std::vector<double> kernel_values = values(kernel, alpha);
  const Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> table(
      kernel_values.data(), static_cast<Eigen::Index>(rows.size()), count);
  const Eigen::MatrixXd product = table * weighted;
  for (std::size_t i = 0; i < rows.size(); ++i)
    result.row(static_cast<Eigen::Index>(rows[i])) = product.row(static_cast<Eigen::Index>(i));
}

Eigen::MatrixXd ViscoelasticOperator::moments(const std::vector<ContactPlace>& points,
                                              const ViscoelasticPanel& panel, ViscoelasticKernel kernel) {
  const int degree = layout_.degree(panel);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(points.size()), degree + 1);
  std::vector<double> at;
  std::vector<std::size_t> near, far;
  for (std::size_t i = 0; i < points.size(); ++i) {
    at.push_back(coordinate(points[i], panel));
    const double gap = std::max(panel.left - at[i], at[i] - (panel.left + panel.width));
    if (decays(kernel) && gap > reach_) continue;
    (is_far(at[i], panel) ? far : near).push_back(i);
  }
  near_moments(at, near, panel, kernel, result);
  far_moments(at, far, panel, kernel, result);
  return result;
}

std::complex<double> ViscoelasticOperator::trail(ContactPlace place, std::complex<double> rate,
                                                 ViscoelasticKernel kernel) {
  // Of the point ahead of the trailing end.
  const double ahead = place.half == Half::trailing ? place.e : 2 * layout_.half_length() - place.e;
  const double nats = -std::log(tolerance_);
  const double last = std::min(nats / rate.real(), std::max(reach_ - ahead, 0.0));
  if (last == 0) return 0;
  std::vector<double> ends{0, last};
  for (const double cut :
       {-ahead, 5 - ahead, -5 - ahead, reach_ - ahead, -reach_ - ahead, 10 / rate.real()}) {
    if (0 < cut && cut < last) ends.push_back(cut);
  }
  // Before the trail the kernel is singular at -ahead: near it pieces are as long as they are far.
  for (double cut = ahead; cut > 0 && cut < std::min(last, 5.0); cut *= 4) ends.push_back(cut);
  append_waves(rate, last, ends);
  std::ranges::sort(ends);
  std::vector<double> weight, alpha, way;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double from = ends[i - 1], to = ends[i], width = to - from;
    for (const UnitNode& node : rule_) {
      alpha.push_back(ahead + from >= 0 ? ahead + from + width * node.from_left
                                        : ahead + to - width * node.from_right);
      way.push_back(from + width * node.from_left);
      weight.push_back(width * node.weight);
    }
  }
  const std::vector<double> kernel_values = values(kernel, alpha);
  std::complex<double> sum = 0;
  for (std::size_t n = 0; n < way.size(); ++n) {
    const double factor = (kernel_values[n] - limit(kernel)) * weight[n] * std::exp(-rate.real() * way[n]);
    sum += rate.imag() == 0 ? factor : factor * std::polar(1.0, -rate.imag() * way[n]);
  }
  return sum;
}

}  // namespace nipref::fast
