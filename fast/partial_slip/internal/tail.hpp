#pragma once
#include <Eigen/Core>

namespace nipref::fast {

/// How a traction goes on beyond the last node of a panel: the sum of three powers of the distance t from the panel's end,
/// t = e^-s, that has its values at the last node and the nodes `spacing` and twice `spacing` before it.
class Tail {
 public:
  Tail() = default;
  /// step: between nodes.
  Tail(const Eigen::Array3d& powers, double step);

  [[nodiscard]] int spacing() const { return spacing_; }
  /// What each of the three nodes' values adds to the traction so many steps beyond the last node.
  [[nodiscard]] Eigen::Vector3d parts(double steps) const {
    return of_powers_.transpose() * (-steps * decays_).exp().matrix();
  }
  /// And to the sum of sin(pi (steps + k))/(pi (steps + k)) times the traction over all nodes beyond the last one, k >= 1, for
  /// a place so many steps before the last one.
  [[nodiscard]] Eigen::Vector3d sinc_sum(double steps) const;

 private:
  Eigen::Array3d decays_ = Eigen::Array3d::Zero();  ///< from node to node
  int spacing_ = 1;
  Eigen::Matrix3d of_powers_ = Eigen::Matrix3d::Zero();
};

}  // namespace nipref::fast
