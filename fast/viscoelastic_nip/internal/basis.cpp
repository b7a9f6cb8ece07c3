#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <nipref/fast/number/internal/cache.hpp>
#include <nipref/fast/viscoelastic_nip/internal/basis.hpp>
#include <nipref/fast/viscoelastic_nip/internal/layout.hpp>

namespace nipref::fast {
namespace {

constexpr double pi = std::numbers::pi;

Eigen::VectorXd points(int degree) {
  return Eigen::VectorXd::NullaryExpr(degree + 1, [&](Eigen::Index i) {
    return std::pow(std::sin(static_cast<double>(i) * pi / (2 * degree)), 2);
  });
}

/// xi_i - xi_j without cancellation.
double difference(Eigen::Index i, Eigen::Index j, int degree) {
  const double unit = pi / (2 * degree);
  return std::sin(static_cast<double>(i + j) * unit) * std::sin(static_cast<double>(i - j) * unit);
}

Eigen::MatrixXd differentiation(int degree) {
  const auto weight = [&](Eigen::Index i) {
    return (i % 2 == 0 ? 1.0 : -1.0) * (i == 0 || i == degree ? 0.5 : 1.0);
  };
  Eigen::MatrixXd matrix(degree + 1, degree + 1);
  for (Eigen::Index i = 0; i <= degree; ++i) {
    matrix(i, i) = 0;
    for (Eigen::Index j = 0; j <= degree; ++j) {
      if (j != i) matrix(i, j) = weight(j) / (weight(i) * difference(i, j, degree));
    }
    matrix(i, i) = -matrix.row(i).sum();  // so that constants have no derivative
  }
  return matrix;
}

Eigen::MatrixXd to_chebyshev(int degree) {
  Eigen::MatrixXd matrix(degree + 1, degree + 1);
  for (int j = 0; j <= degree; ++j) {
    for (int i = 0; i <= degree; ++i) {
      const double half = (i == 0 || i == degree ? 0.5 : 1.0) * (j == 0 || j == degree ? 0.5 : 1.0);
      // The points ascend, so T_j(2 xi_i - 1) = cos(j (pi - i pi/degree)).
      matrix(j, i) = 2 * half / degree * (j % 2 == 0 ? 1 : -1) * std::cos(j * i % (2 * degree) * pi / degree);
    }
  }
  return matrix;
}

Eigen::MatrixXd pressure_at(const ViscoelasticLayout& layout, const ViscoelasticPanel& panel,
                            const Eigen::VectorXd& xi) {
  Eigen::MatrixXd values(xi.size(), layout.terms());
  std::vector<double> basis;
  for (Eigen::Index i = 0; i < xi.size(); ++i) {
    layout.pressure_basis(panel, xi(i), basis);
    values.row(i) = Eigen::Map<Eigen::RowVectorXd>(basis.data(), layout.terms());
  }
  return values;
}

/// Fejer's rule in xi with dx = dx/dxi dxi: exact for these polynomials.
void integrate(const ViscoelasticLayout& layout, const ViscoelasticPanel& panel, ViscoelasticBasis& basis) {
  const int count = 2 * layout.terms() + 4;
  Eigen::VectorXd xi(count);
  Eigen::RowVectorXd weight(count), moment(count);
  for (int i = 0; i < count; ++i) {
    const double angle = (2 * i + 1) * pi / (2 * count);
    double sum = 1;
    for (int k = 1; k <= count / 2; ++k) sum -= 2 * std::cos(2 * k * angle) / (4.0 * k * k - 1);
    xi(i) = std::pow(std::cos(angle / 2), 2);
    weight(i) = sum / count * panel.slope(xi(i));
    moment(i) = weight(i) * panel.x(xi(i));
  }
  const Eigen::MatrixXd pressure = pressure_at(layout, panel, xi);
  basis.integral = weight * pressure;
  basis.moment = moment * pressure;
}

using Kind = std::pair<int, bool>;  // terms, at_end

ViscoelasticBasis make(const Kind& kind) {
  const auto [terms, at_end] = kind;
  const ViscoelasticLayout layout(1, 2, terms);
  const ViscoelasticPanel& panel = layout.panels()[at_end ? 0 : 1];
  ViscoelasticBasis basis;
  basis.degree = layout.degree(panel);
  basis.xi = points(basis.degree);
  basis.slope = differentiation(basis.degree);
  basis.chebyshev = to_chebyshev(basis.degree);
  basis.pressure = pressure_at(layout, panel, basis.xi);
  integrate(layout, panel, basis);
  return basis;
}

}  // namespace

std::shared_ptr<const ViscoelasticBasis> viscoelastic_basis(int terms, bool at_end) {
  static Cache<Kind, ViscoelasticBasis> kept(make);
  return kept.at({terms, at_end});
}

}  // namespace nipref::fast
