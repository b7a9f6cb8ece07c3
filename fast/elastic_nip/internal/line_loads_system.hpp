#pragma once
#include <Eigen/Core>
#include <memory>
#include <span>

#include <nipref/fast/elastic_nip/line_loads.hpp>

namespace nipref::fast {

/// Which kernels a step of the line-load method needs.
struct WantedKernels {
  bool I1 = false;
  bool coupling = false;
  bool I6 = false;
};

/// Their values, empty where not wanted: u under a normal load is N/pi I1, v under it N/pi times the coupling I3 -
/// (theta2/N) I2, which is -u under a shear load too, and v under a shear load N/pi I6, N = theta1 + theta2.
/// Functions of eta, the same for all alpha, are left out: in a symmetric nip they cancel between the loads at +-Y.
struct LineLoadKernels {
  Eigen::RowVectorXd I1, coupling, I6;
};

/// The kernels at each alpha, finite and nonzero, as `method` computes them; counted into `work`.
LineLoadKernels line_load_kernels(const data::ElasticMaterial& material, const LineLoadMethod& method,
                                  std::span<const double> alpha, WantedKernels wanted, Work& work);

/// The matching equations of one half of the nip, all of their numbers lengths or dimensionless: the unknowns are d0
/// and the normal loads P_1 .. P_m times N/pi, with friction also the shear loads Q_1 .. Q_m. Matching points lie at
/// 2 i a, loads at +-(2k - 1) a, so that all distances are odd multiples of half an element a. Rows: u at i = 0 .. m,
/// with friction v at i = 1 .. m; v at the middle of the nip is 0 by symmetry. (thesis 5.8, 5.11) BadInput unless
/// nip, method and length are in their domains.
Eigen::MatrixXd matching_matrix(const data::ElasticNip& nip, const LineLoadMethod& method,
                                double contact_length, bool grips, Work& work);

/// The sheet under loads across its faces and, if it is gripped, along them.
std::shared_ptr<const LineLoadSheet> elastic_sheet(const data::ElasticNip& nip, const LineLoadMethod& method,
                                                   bool grips);

}  // namespace nipref::fast
