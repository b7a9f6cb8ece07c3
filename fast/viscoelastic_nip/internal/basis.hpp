#pragma once
#include <Eigen/Core>
#include <memory>

namespace nipref::fast {

/// What the expansions on a panel need and what depends on the number of terms and the kind of the panel
/// only: made once for each (see ViscoelasticPanel).
struct ViscoelasticBasis {
  int degree;                   ///< in xi, of the pressure and its memory
  Eigen::VectorXd xi;           ///< Chebyshev points of [0, 1], both ends among them, ascending
  Eigen::MatrixXd slope;        ///< d/dxi at the points of the polynomial through values there
  Eigen::MatrixXd chebyshev;    ///< coefficients of T_j(2 xi - 1) from values at the points
  Eigen::MatrixXd pressure;     ///< the pressure's basis at the points
  Eigen::RowVectorXd integral;  ///< of each function of the pressure's basis over x from 0 to 1
  Eigen::RowVectorXd moment;    ///< the same times x
};

/// Computed at the first call and kept, see Cache.
std::shared_ptr<const ViscoelasticBasis> viscoelastic_basis(int terms, bool at_end);

}  // namespace nipref::fast
