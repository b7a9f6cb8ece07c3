#pragma once
#include <Eigen/Core>
#include <complex>
#include <vector>

#include <nipref/fast/viscoelastic_nip/internal/layout.hpp>

namespace nipref::fast {

/// amplitude e^(-rate w), w the way (half-thicknesses) that a material point has gone since: a relaxation
/// term of the compliance over its instantaneous part, as the steadily rolling sheet sees it. Dimensionless.
struct MemoryTerm {
  std::complex<double> amplitude;
  std::complex<double> rate;
};

/// The memory z(d) = int_0^d e^(-rate (d - d')) p(d') dd' of the pressure on one panel, d the distance from
/// the leading end: z' = p - rate z, collocated at Chebyshev points of xi, where the solution is as smooth as
/// the pressure however stiff the equation is. In coefficients of T_j(2 xi - 1).
struct PanelMemory {
  Eigen::MatrixXcd by_pressure;             ///< of each pressure coefficient of this panel
  Eigen::VectorXcd by_inflow;               ///< of z = 1 where the material enters the panel
  Eigen::RowVectorXcd outflow_by_pressure;  ///< z where the material leaves the panel
  std::complex<double> outflow_by_inflow;
};

PanelMemory panel_memory(const ViscoelasticLayout& layout, const ViscoelasticPanel& panel,
                         std::complex<double> rate);

/// The pressure basis of a panel in coefficients of T_j(2 xi - 1).
Eigen::MatrixXd pressure_in_chebyshev(const ViscoelasticLayout& layout, const ViscoelasticPanel& panel);

}  // namespace nipref::fast
