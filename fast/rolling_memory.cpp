#include "fast/rolling_memory.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace nipref::fast {
namespace {

constexpr double pi = std::numbers::pi;

/// Chebyshev points of [0, 1], both ends among them, ascending.
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

/// d/dxi of the polynomial through values at the points.
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

/// Coefficients of T_j(2 xi - 1) from values at the points.
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

Eigen::MatrixXd pressure_at_points(const RollingLayout& layout, const RollingPanel& panel,
                                   const Eigen::VectorXd& xi) {
  Eigen::MatrixXd values(xi.size(), layout.terms());
  std::vector<double> basis;
  for (Eigen::Index i = 0; i < xi.size(); ++i) {
    layout.pressure_basis(panel, xi(i), basis);
    values.row(i) = Eigen::Map<Eigen::RowVectorXd>(basis.data(), layout.terms());
  }
  return values;
}

}  // namespace

Eigen::MatrixXd pressure_in_chebyshev(const RollingLayout& layout, const RollingPanel& panel) {
  const int degree = layout.degree(panel);
  return to_chebyshev(degree) * pressure_at_points(layout, panel, points(degree));
}

PanelMemory panel_memory(const RollingLayout& layout, const RollingPanel& panel, std::complex<double> rate) {
  const int degree = layout.degree(panel);
  const Eigen::VectorXd xi = points(degree);
  // Downstream is towards larger xi on the leading half, towards smaller on the trailing one.
  const bool leading = panel.half == Half::leading;
  const Eigen::VectorXd step =
      xi.unaryExpr([&](double at) { return (leading ? 1 : -1) * panel.width * panel.slope(at); });
  const Eigen::Index in = leading ? 0 : degree;
  const Eigen::Index first = leading ? 1 : 0;  // of the points other than the inflow
  const Eigen::MatrixXd slope = differentiation(degree);
  const Eigen::MatrixXd pressure = pressure_at_points(layout, panel, xi);

  Eigen::MatrixXcd equations = slope.block(first, first, degree, degree).cast<std::complex<double>>();
  equations.diagonal() += rate * step.segment(first, degree);
  Eigen::MatrixXcd right(degree, layout.terms() + 1);
  right.leftCols(layout.terms()) =
      (step.segment(first, degree).asDiagonal() * pressure.middleRows(first, degree))
          .cast<std::complex<double>>();
  right.rightCols(1) = -slope.block(first, in, degree, 1).cast<std::complex<double>>();
  const Eigen::MatrixXcd solved = equations.partialPivLu().solve(right);

  Eigen::MatrixXcd values = Eigen::MatrixXcd::Zero(degree + 1, layout.terms() + 1);
  values.middleRows(first, degree) = solved;
  values(in, layout.terms()) = 1;
  const Eigen::Index out = leading ? degree : 0;
  const Eigen::MatrixXcd coefficients = to_chebyshev(degree) * values;
  return {coefficients.leftCols(layout.terms()), coefficients.rightCols(1),
          values.row(out).head(layout.terms()), values(out, layout.terms())};
}

}  // namespace nipref::fast
