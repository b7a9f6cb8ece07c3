#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>

namespace nipref::fast {

// The matching equations of one half of the nip, all of their numbers lengths or dimensionless: the unknowns
// are d0 and the line loads times N/pi, N = theta1 + theta2. Matching points lie at 2 i a, loads at
// +-(2k - 1) a, so that all distances are odd multiples of half an element a.

/// Distances a, 3a .. (4m - 1) a in half-thicknesses. BadInput unless nip, method and length are in their
/// domains.
std::vector<double> odd_multiples(const data::ElasticNip& nip, const LineLoadMethod& method,
                                  double contact_length);

/// Which kernels a step of the line-load method needs.
struct WantedKernels {
  bool I1 = false;
  bool I3 = false;
  bool I6 = false;
};

/// Their values, empty where not wanted. I6 lacks a function of eta, the same for all alpha: in a symmetric
/// nip it cancels between the loads at +-Y.
struct KernelValues {
  std::vector<double> I1, I3, I6;
};

/// The kernels at each alpha, finite and nonzero, as `method` computes them; counted into `work`.
KernelValues line_load_kernels(const LineLoadMethod& method, std::span<const double> alpha,
                               WantedKernels wanted, Work& work);

/// Without friction: u at i = 0 .. m; unknowns d0, P_1 .. P_m. (thesis 5.11)
Eigen::MatrixXd slip_matrix(const std::vector<double>& I1);

/// With full friction: u at i = 0 .. m, then v at i = 1 .. m; unknowns d0, P_1 .. P_m, Q_1 .. Q_m. The
/// equation of v at the middle of the nip is met by symmetry. (thesis 5.8)
Eigen::MatrixXd grip_matrix(const KernelValues& kernels, double poisson);

/// The gap Y^2/(2R) at the matching points: right-hand side of the equations of u.
Eigen::VectorXd gap_at_matching_points(const data::ElasticNip& nip, int elements_per_side,
                                       double contact_length);

void count_system(int unknowns, Work& work);

/// The search for the contact length that carries `load`, from `trial_length` on; BadInput unless load and
/// search are in their domains.
LengthSearch length_search(double load, double trial_length, const LoadSearch& search);

/// Fills a solution from the unknowns.
LineLoadSolution solution_of(const data::ElasticNip& nip, int elements_per_side, double contact_length,
                             const Eigen::VectorXd& unknowns);

}  // namespace nipref::fast
