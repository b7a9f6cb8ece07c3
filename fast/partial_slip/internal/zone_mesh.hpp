#pragma once
#include <cmath>
#include <vector>

#include <nipref/fast/partial_slip/internal/zones.hpp>

namespace nipref::fast {

/// The unknowns of a contact's tractions, and where they are matched.
///
/// A panel, a zone or an equal part of a long one, is mapped to the real line by e = left + length/(1 + e^-s), which
/// takes the powers of the distance from its ends to exponentials. Unknown are the pressure p, and where the sheet sticks
/// the shear q, at the nodes s = j h; integrals over e are sums over the nodes, and the equations hold midway between
/// them: there the trapezoidal rule's error for a Cauchy integral is as small as for a smooth function, e^(-2 pi d/h) with d
/// = pi the width of the strip in which tractions are analytic in s. Between the nodes p and q are interpolated by the sinc
/// function times a Gaussian, which is accurate to e^(-0.7 pi d/h): that sets h.
///
/// At the ends of a panel (t: distance from it, a = atan(beta mu sign)/pi with the sign of the slip zone):
///     p ~ t^(1/2 - a) at the contact's leading end, t^(1/2 + a) at its trailing end; t^(1/2) where it sticks,
///     p - p(0) ~ |t|^(1/2 - a), q - sign mu p ~ t^(1/2 - a)   where it sticks and then slips,
///     p - p(0) ~ t,             q - sign mu p ~ t^(3/2 + a)   where it slips and then sticks, for
/// t^(1/2 + a) would be slip along the shear. (They solve the equations with the Cauchy kernels alone, by int_0^inf
/// s^b/(t - s) ds = pi cot(pi b) t^b.) Before the first node and beyond the last one the tractions go on as these powers.
/// Boundary values p(0) are unknowns, with the hat function of both panels; where it sticks, q is counted from mu p times a
/// smooth step between the signs of both neighbours. A boundary where slip turns into stick has an equation more.
class ZoneMesh {
 public:
  struct Point {
    int panel;
    double s;
    double power = std::exp(s);         ///< e^s
    double left = power / (1 + power);  ///< distance from the panel's left end over its length
    double right = 1 / (1 + power);
  };
  /// A traction of one unknown at a point.
  struct Share {
    int unknown;
    double pressure, shear;
  };
  using Shares = std::vector<Share>;

  /// nats: -ln of the accuracy that it is made for.
  ZoneMesh(const std::vector<Zone>& zones, const PartialSlipTask& task, double nats);

  /// Where the powers begin next to joints of panels and to boundaries where slip turns into stick: -ln of t over the
  /// panel's length. The powers leave out what is smaller by t. That t^(1/2 + a) has no part is seen in tractions e^-reach
  /// of the others, so that rounding shifts the boundary by e^reach of itself. Both errors are alike at about 16.
  [[nodiscard]] static double smooth_reach(double nats);

  /// The same unknowns over zones of other lengths.
  void stretch_to(const std::vector<Zone>& zones);

  [[nodiscard]] double step() const { return step_; }
  [[nodiscard]] int unknowns() const { return unknowns_; }
  [[nodiscard]] const std::vector<Point>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<Point>& midpoints() const { return midpoints_; }
  [[nodiscard]] bool matches_normal(std::size_t midpoint) const { return !extra_[midpoint]; }
  [[nodiscard]] int sign(const Point& point) const { return panels_[at(point.panel)].sign; }
  [[nodiscard]] int zone(const Point& point) const { return panels_[at(point.panel)].zone; }
  /// The weight of a node, or of a midpoint for sums over midpoints.
  [[nodiscard]] double weight(const Point& point) const;
  /// e_a - e_b without cancellation.
  [[nodiscard]] double distance(const Point& a, const Point& b) const;
  /// How far the zones go to e of the point, each: 0 if it is beyond.
  [[nodiscard]] double extent(int zone, const Point& point) const;
  [[nodiscard]] double place(const Point& point) const;
  /// 0 < e < the contact's length; from the nearer end of the panel that it lies in.
  [[nodiscard]] Point point_at(double e) const;
  [[nodiscard]] Shares shares(const Point& point) const;

 private:
  struct PanelEnd {
    double pressure_power, shear_power;  ///< of t
    double reach;                        ///< of |s| from where on they hold
    int value, shear_value;              ///< unknowns of the boundary's values, -1 where they are 0
    bool extra;
  };
  struct Panel {
    int zone, sign, part, parts;
    double length;
    PanelEnd left, right;
    int first_node, last_node;
    int pressure, shear;  ///< first unknowns
    double from, to;      ///< signs that the shear is counted from at the zone's ends
  };
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }
  void measure_gaps();
  void cut(const std::vector<Zone>& zones);
  void set_ends(const PartialSlipTask& task, double nats);
  [[nodiscard]] PanelEnd end(std::size_t panel, bool is_right, const PartialSlipTask& task,
                             double nats) const;
  void number();
  /// At either end of a panel, for the powers and the hats: the place of the last one is e^-16 of the last unknown's.
  [[nodiscard]] int nodes_beyond() const;
  void add_hats(const Panel& panel, const Point& point, Shares& shares) const;
  void add_node(const Panel& panel, int node, double factor, Shares& shares) const;
  void add_shear_of_step(const Panel& panel, const Point& point, Shares& shares) const;

  double step_;
  double window_;  ///< of the Gaussian, in steps
  double friction_;
  std::vector<Panel> panels_;
  std::vector<std::vector<double>> gaps_;  ///< from a panel's right end to a later one's left end
  std::vector<Point> nodes_, midpoints_;
  std::vector<bool> extra_;
  int unknowns_ = 0;
};

}  // namespace nipref::fast
