#pragma once
#include <Eigen/Core>

namespace nipref::fast {

/// The continuation of a traction, over its envelope, beyond the last node of a panel: a sum of three powers of t =
/// e^-s. It has the values at the last node and at those `spacing` and twice `spacing` before it.
class Tail {
 public:
  Tail() = default;
  /// `step`: the step between nodes.
  Tail(const Eigen::Array3d& powers, double step);

  [[nodiscard]] int spacing() const { return spacing_; }
  /// The weights of the three nodes' values in the value so many steps beyond the last node.
  [[nodiscard]] Eigen::Vector3d parts(double steps) const {
    return of_powers_.transpose() * (-steps * decays_).exp().matrix();
  }
  /// Their weights in the sum of sin(pi (steps + k))/(pi (steps + k)) times the value over the nodes k >= 1 beyond
  /// the last one, for a place so many steps before the last one.
  [[nodiscard]] Eigen::Vector3d sinc_sum(double steps) const;

 private:
  Eigen::Array3d decays_ = Eigen::Array3d::Zero();  ///< nats of each power from node to node
  int spacing_ = 1;
  Eigen::Matrix3d of_powers_ = Eigen::Matrix3d::Zero();
};

}  // namespace nipref::fast
