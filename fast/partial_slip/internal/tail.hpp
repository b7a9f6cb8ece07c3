#pragma once
#include <Eigen/Core>

namespace nipref::fast {

/// The continuation of a traction, over its envelope, beyond the last node of a panel: a sum of four powers of t =
/// e^-s. It has the values at the last node and at three others before it, `spacing` nodes or about one
/// unit of s apart. Let the powers be d apart, and q be the next one. The continuation of t^q is wrong by t^(q - 4 d)
/// times the product of the four |t^d - t_k^d|, with t_k = t_0 e^k for the node number k from the last one on, as
/// interpolation by a polynomial of t^d is: by at most e^(6 d) t_0^q.
class Tail {
 public:
  static constexpr int terms = 4;  ///< number of powers and of nodes
  using Powers = Eigen::Array<double, terms, 1>;
  using Parts = Eigen::Matrix<double, terms, 1>;
  using Square = Eigen::Matrix<double, terms, terms>;

  Tail() = default;
  /// `step`: the step between nodes.
  Tail(const Powers& powers, double step);

  [[nodiscard]] int spacing() const { return spacing_; }
  /// The weights of the nodes' values in the value so many steps beyond the last node.
  [[nodiscard]] Parts parts(double steps) const {
    return of_powers_.transpose() * (-steps * decays_).exp().matrix();
  }
  /// Their weights in the sum of sin(pi (steps + k))/(pi (steps + k)) times the value over the nodes k >= 1 beyond
  /// the last one, for a place so many steps before the last one.
  [[nodiscard]] Parts sinc_sum(double steps) const;

 private:
  Powers decays_ = Powers::Zero();  ///< nats of each power from node to node
  int spacing_ = 1;
  Square of_powers_ = Square::Zero();
};

}  // namespace nipref::fast
