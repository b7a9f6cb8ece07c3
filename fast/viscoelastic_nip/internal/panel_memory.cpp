
#include <nipref/fast/number/internal/linear_system.hpp>
#include <nipref/fast/viscoelastic_nip/internal/basis.hpp>
#include <nipref/fast/viscoelastic_nip/internal/panel_memory.hpp>

namespace nipref::fast {
namespace {

/// Rate is double or complex<double>.
template <typename Rate>
PanelMemory memory_at(const ViscoelasticLayout& layout, const ViscoelasticPanel& panel, Rate rate) {
  using Matrix = Eigen::Matrix<Rate, Eigen::Dynamic, Eigen::Dynamic>;
  const auto kept = viscoelastic_basis(layout.terms(), panel.at_end());
  const ViscoelasticBasis& basis = *kept;
  const int degree = basis.degree;
  // Downstream is towards larger xi on the leading half, towards smaller on the trailing one.
  const bool leading = panel.half == Half::leading;
  const Eigen::VectorXd step =
      basis.xi.unaryExpr([&](double at) { return (leading ? 1 : -1) * panel.width * panel.slope(at); });
  const Eigen::Index in = leading ? 0 : degree;
  const Eigen::Index first = leading ? 1 : 0;  // of the points other than the inflow

  Matrix equations = basis.slope.block(first, first, degree, degree).cast<Rate>();
  equations.diagonal() += rate * step.segment(first, degree);
  Matrix right(degree, layout.terms() + 1);
  right.leftCols(layout.terms()) =
      (step.segment(first, degree).asDiagonal() * basis.pressure.middleRows(first, degree))
          .template cast<Rate>();
  right.rightCols(1) = -basis.slope.block(first, in, degree, 1).cast<Rate>();

  Matrix values = Matrix::Zero(degree + 1, layout.terms() + 1);
  values.middleRows(first, degree) = linear_solution(equations, right);
  values(in, layout.terms()) = 1;
  const Eigen::Index out = leading ? degree : 0;
  const Matrix coefficients = product(basis.chebyshev.cast<Rate>(), values);
  using Complex = std::complex<double>;
  return {coefficients.leftCols(layout.terms()).template cast<Complex>(),
          coefficients.rightCols(1).template cast<Complex>(),
          values.row(out).head(layout.terms()).template cast<Complex>(), values(out, layout.terms())};
}

}  // namespace

Eigen::MatrixXd pressure_in_chebyshev(const ViscoelasticLayout& layout, const ViscoelasticPanel& panel) {
  const auto basis = viscoelastic_basis(layout.terms(), panel.at_end());
  return product(basis->chebyshev, basis->pressure);
}

PanelMemory panel_memory(const ViscoelasticLayout& layout, const ViscoelasticPanel& panel,
                         std::complex<double> rate) {
  return rate.imag() == 0 ? memory_at(layout, panel, rate.real()) : memory_at(layout, panel, rate);
}

}  // namespace nipref::fast
