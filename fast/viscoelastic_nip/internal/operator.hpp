#pragma once
#include <Eigen/Core>
#include <map>
#include <vector>

#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/number/internal/double_exponential.hpp>
#include <nipref/fast/viscoelastic_nip/internal/layout.hpp>
#include <nipref/fast/viscoelastic_nip/internal/panel_memory.hpp>

namespace nipref::fast {

/// What a line load at distance alpha = y - y' does at a point, over pi.
enum class ViscoelasticKernel {
  normal,      ///< I1/pi: the normal displacement
  tangential,  ///< I3/pi: of the tangential displacement, what N acts in
  sign,        ///< I2/pi: what theta2 acts in
  stretch      ///< I3'/pi: of the strain along the surface, what N acts in
};

/// Displacements of single points by what is given on panels, or trails behind the contact.
class ViscoelasticOperator {
 public:
  ViscoelasticOperator(const ViscoelasticLayout& layout, double tolerance, CountedKernels& kernels);

  /// int kernel(y - y') T_j(2 xi - 1) dy' over a panel, j = 0 .. degree, at each of the points: one row each.
  [[nodiscard]] Eigen::MatrixXd moments(const std::vector<ContactPlace>& points,
                                        const ViscoelasticPanel& panel, ViscoelasticKernel kernel);
  /// int_0^inf (kernel(y - y_T + w) - limit) e^(-rate w) dw, y_T the trailing end: what a memory that fades
  /// behind the contact does, per unit of what it is there, beside what it does to all points alike by the
  /// kernel's limit far ahead: 1/4, 1/2 or 0. At any place, behind the contact too.
  [[nodiscard]] std::complex<double> trail(ContactPlace place, std::complex<double> rate,
                                           ViscoelasticKernel kernel);

 private:
  struct Nodes {
    std::vector<double> xi, weight, alpha;
  };
  [[nodiscard]] double coordinate(ContactPlace point, const ViscoelasticPanel& panel) const;
  [[nodiscard]] bool is_far(double at, const ViscoelasticPanel& panel) const;
  void append_near_nodes(double at, const ViscoelasticPanel& panel, ViscoelasticKernel kernel,
                         Nodes& nodes) const;
  [[nodiscard]] std::vector<double> values(ViscoelasticKernel kernel, const std::vector<double>& alpha);
  void near_moments(const std::vector<double>& at, const std::vector<std::size_t>& rows,
                    const ViscoelasticPanel& panel, ViscoelasticKernel kernel, Eigen::MatrixXd& result);
  void far_moments(const std::vector<double>& at, const std::vector<std::size_t>& rows,
                   const ViscoelasticPanel& panel, ViscoelasticKernel kernel, Eigen::MatrixXd& result);

  const ViscoelasticLayout& layout_;
  double tolerance_;
  double reach_;  ///< where I1, pi/4 - I3 and I3' have decayed below the tolerance
  std::vector<UnitNode> rule_;
  CountedKernels& kernels_;
};

}  // namespace nipref::fast
