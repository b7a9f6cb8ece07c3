#pragma once
#include <Eigen/Core>
#include <utility>
#include <vector>

#include <nipref/fast/nip/internal/tractions.hpp>
#include <nipref/fast/number/estimate.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {

/// Linear equations for the tractions of a contact and further unknowns.
struct Equations {
  /// All other numbers are zero.
  Equations(Eigen::MatrixXd of_tractions, Eigen::MatrixXd sizes, Eigen::Index unknowns,
            Eigen::Index of_layers)
      : on_tractions(std::move(of_tractions)),
        on_unknowns(Eigen::MatrixXd::Zero(on_tractions.rows(), unknowns)),
        right(Eigen::VectorXd::Zero(on_tractions.rows())),
        size_on_tractions(std::move(sizes)),
        size_on_unknowns(on_unknowns),
        size_right(right),
        layers(Eigen::MatrixXd::Zero(of_layers, unknowns + 1)) {}

  Eigen::MatrixXd on_tractions;  ///< columns of Tractions
  Eigen::MatrixXd on_unknowns;
  Eigen::VectorXd right;
  /// The sizes of the parts that cancel in these numbers, 0 where none cancel.
  Eigen::MatrixXd size_on_tractions;
  Eigen::MatrixXd size_on_unknowns;
  Eigen::VectorXd size_right;
  /// The coefficients of the layers: a column of factors for each further unknown, and a last column of constants.
  Eigen::MatrixXd layers;
  /// The number of last equations whose numbers are memories of kernels, right to eight units in the last place.
  int memories = 0;
};

/// A linear functional of a solution, plus a constant.
struct Functional {
  Eigen::RowVectorXd on_tractions, on_unknowns;
  double constant = 0;
  double cancelled = 0;  ///< size of the parts that cancel in it for this solution, for its rounding error

  friend Functional operator-(Functional a, const Functional& b) {
    a.on_tractions -= b.on_tractions;
    a.on_unknowns -= b.on_unknowns;
    a.constant -= b.constant;
    a.cancelled += b.cancelled;
    return a;
  }
  friend Functional operator*(double factor, Functional a) {
    a.on_tractions *= factor;
    a.on_unknowns *= factor;
    a.constant *= factor;
    a.cancelled *= std::fabs(factor);
    return a;
  }
};

/// The solution x of M x = r by elimination, refined once.
///
/// Truncation error of a number J(x). Let c_l be the coefficients of the true tractions beyond the terms that are
/// solved for, and M_l their columns. The terms solved for are wrong by M^-1 sum M_l c_l. With the adjoint solution z,
/// M^T z = J, the number is therefore wrong by
///     sum_l c_l (J_l - z . M_l).
/// The next two columns of each expansion are known. The coefficients of functions that are analytic on and around a
/// panel fall geometrically, and panels.hpp chooses panels on which they fall by 1.6 or more a term. The next
/// coefficient is then at most the largest of |c_(n-k)|/1.6^k, k = 1, 2, 3. Columns of equal parity act about equally,
/// and every other coefficient from there on adds up to 1/(1 - 1.6^-2) = 1.64 times that: twice that covers all.
/// Rounding error, u = 2^-53. The elimination with one step of refinement solves a system whose numbers differ from the
/// given ones by about 2 u (Skeel 1980). The given numbers have errors themselves: 4 u, two units in the last place, in
/// the kernels, or 16 u in the kernels' memories, and about 2 u in weights and rates. In all d_i = 8 u, or 16 u for
/// memories of kernels, relative to a number or to the size of the parts that cancel in it. In rolling u counts twice,
/// because the amplitudes and rates of the material, right to four units each, act in all equations and functionals. As
/// independent random numbers (Higham and Mary 2019) these errors change the number by
///     (sum_i d_i^2 z_i^2 (sum_k (M_ik x_k)^2 + r_i^2))^(1/2).
/// The evaluation of J adds 16 u times the sum of the sizes of its terms. This covers 8 u for its numbers, as in an
/// equation; 8 u for the unit of the result, a product with up to eight roundings; and 5 u for the rounding of a given
/// length in half-thicknesses, as J grows like its fifth power at most (solved_nip.hpp). Together, as independent
/// errors, they are 13 u. The effect of the least normal number in place of kernels that underflow is added.
class Solution {
 public:
  Solution(Tractions tractions, const Equations& equations);

  [[nodiscard]] const Tractions& tractions() const { return tractions_; }
  [[nodiscard]] double half_length() const { return tractions_.half_length(); }
  [[nodiscard]] int unknowns() const { return static_cast<int>(unknowns_.size()); }
  [[nodiscard]] double unknown(int number) const { return unknowns_(number); }
  /// The integrals of Re g and of y Im g over the contact: the load and, in rolling, the moment.
  [[nodiscard]] Functional load() const { return of_tractions(integrals_.row(0)); }
  [[nodiscard]] Functional moment() const { return of_tractions(integrals_.row(1)); }
  /// A functional of one further unknown, and one of the tractions alone.
  [[nodiscard]] Functional of_unknown(int number) const;
  [[nodiscard]] Functional of_tractions(Eigen::RowVectorXd row) const;
  /// g at 0 <= e <= A, see Tractions.
  [[nodiscard]] std::complex<double> traction(double e) const { return tractions_.value(e, coefficients_); }
  [[nodiscard]] double value(const Functional& functional) const;
  [[nodiscard]] double carried_load() const { return integrals_.row(0).dot(coefficients_); }
  struct Parts {
    double value, truncation, rounding;
  };
  /// A number with the parts of its error.
  [[nodiscard]] Parts parts(const Functional& functional) const;
  [[nodiscard]] Estimate estimate(const Functional& functional) const {
    const auto [value, truncation, rounding] = parts(functional);
    return {value, truncation + rounding};
  }
  /// A bound of |g|: Chebyshev polynomials and the factors are at most 1, and the Dawson integrals of layers at most 1.2,
  /// the largest |int_0^x e^(i t^2) dt|, which belongs to an imaginary rate.
  [[nodiscard]] double traction_bound() const;
  [[nodiscard]] int size() const { return static_cast<int>(elimination_.size()); }

 private:
  [[nodiscard]] Eigen::VectorXd adjoint(const Functional& functional) const;
  void take_tails();

  Tractions tractions_;
  Eigen::MatrixXd integrals_;
  std::vector<int> solved_, left_out_;  ///< columns
  Eigen::MatrixXd layers_;
  Elimination elimination_;
  Eigen::MatrixXd left_out_columns_;
  Eigen::VectorXd coefficients_;  ///< of all columns, 0 of those left out
  Eigen::VectorXd unknowns_;
  Eigen::RowVectorXd tails_;  ///< estimated coefficient of each column that is left out
  double unit_;               ///< u, or 2 u with memories
  Eigen::VectorXd equation_errors_;
};

}  // namespace nipref::fast
