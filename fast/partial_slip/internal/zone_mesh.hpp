#pragma once
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <nipref/fast/partial_slip/internal/tail.hpp>
#include <nipref/fast/partial_slip/internal/zones.hpp>

namespace nipref::fast {

/// The unknowns of a contact's tractions, and the points where the equations hold.
///
/// A panel is a zone or an equal part of a long one. It is mapped to the real line by e = left + length/(1 + e^-s),
/// which turns powers of the distance from its ends into exponentials. The unknowns are the pressure p and, where
/// the sheet sticks, the shear q at the nodes s = j h, both over an envelope, which falls to both ends as the
/// traction does or more slowly. Integrals over e are sums over the nodes. The equations hold midway between the
/// nodes, where the trapezoidal rule's error for a Cauchy integral is as small as for a smooth function, e^(-2 pi
/// d/h) with d = pi the width of the strip in which tractions are analytic in s. Between the nodes p and q are
/// interpolated by the sinc function times the envelope. The error of this interpolation, e^(-pi d/h) times the
/// envelope, determines h. It falls to the ends, so that it does not hide the small tractions there, which determine
/// the places of boundaries.
///
/// At the ends of a panel, with t the distance from it and a = atan(beta mu sign)/pi, sign that of the slip zone, the
/// tractions are, up to factors that are analytic in t:
///     p = t^(1/2 - a) at the contact's leading end, t^(1/2 + a) at its trailing end; t^(1/2) where it sticks,
///     p = p(0) + t + |t|^(1/2 - a), q - sign mu p = t^(1/2 - a)   where it sticks and then slips,
///     p = p(0) + t + |t|^(3/2 + a), q - sign mu p = t^(3/2 + a)   where it slips and then sticks,
/// where t^(1/2 + a) would be slip along the shear. (These powers solve the equations with the Cauchy kernels alone,
/// by int_0^inf s^b/(t - s) ds = pi cot(pi b) t^b.) Before the first node and beyond the last one the tractions are
/// continued by the first four of these powers. The boundary values p(0) are unknowns. A hat function, 1 at the
/// boundary, spreads such a value over both panels. It falls to 0 at their other ends like t, or at an end of the
/// contact like the least power of t there: any other power would be left in the tractions at the nodes, where no
/// power continues it. Where the sheet sticks, q is counted from mu p times a smooth step between the signs of both
/// neighbours. A boundary where slip turns into stick has an additional equation.
class ZoneMesh {
 public:
  /// The largest |s|, at e^-72 of a panel from its end.
  static constexpr double farthest = 72;
  /// Nodes get no nearer to a boundary where slip turns into stick than with so many nats. About there the rounding of
  /// the equations moves the boundary as far as the truncated powers do, and nearer nodes would let it move it farther.
  static constexpr double most_smooth_nats = 26;

  /// s may be infinite: at the panel's end itself.
  struct Point {
    int panel;
    double s;
    double power = std::exp(s);            ///< e^s
    double left = 1 / (1 + std::exp(-s));  ///< distance from the panel's left end over its length
    double right = 1 / (1 + power);
  };
  struct Traction {
    double pressure, shear;
    friend Traction operator*(double factor, const Traction& traction) {
      return {factor * traction.pressure, factor * traction.shear};
    }
  };
  /// The traction of one unknown at a point.
  struct Share {
    int unknown;
    double pressure, shear;
  };
  using Shares = std::vector<Share>;
  /// Tractions of unit unknowns, columns, at points, rows.
  struct Rows {
    Eigen::SparseMatrix<double> pressure, shear;
  };
  /// A point midway between two nodes, with the equations that hold there: those of u' and v'. No equation holds at the
  /// midpoints beyond the last nodes; the conditions of stick and slip are checked there, too.
  struct Midpoint : Point {
    bool matches_normal, matches_along;
  };

  /// `nats`: -ln of the accuracy for which the mesh is made.
  ZoneMesh(const Zones& zones, const PartialSlipTask& task, double nats);

  /// The same unknowns over zones of other lengths.
  void stretch_to(const Zones& zones);

  [[nodiscard]] double nats() const { return nats_; }
  [[nodiscard]] double step() const { return step_; }
  [[nodiscard]] int unknowns() const { return unknowns_; }
  [[nodiscard]] const std::vector<Point>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<Midpoint>& midpoints() const { return midpoints_; }
  [[nodiscard]] const Rows& at_nodes() const { return at_nodes_; }
  [[nodiscard]] const Rows& at_midpoints() const { return at_midpoints_; }
  [[nodiscard]] int sign(const Point& point) const { return panels_[at(point.panel)].sign; }
  [[nodiscard]] int zone(const Point& point) const { return panels_[at(point.panel)].zone; }
  /// The weight of a node, or of a midpoint for sums over midpoints.
  [[nodiscard]] double weight(const Point& point) const;
  /// e_a - e_b without cancellation.
  [[nodiscard]] double distance(const Point& a, const Point& b) const;
  /// Sets Cauchy's kernels, -1/(pi times the distance), of all midpoints, rows, from all nodes, columns.
  void set_cauchy_kernels(Eigen::MatrixXd& kernels) const;
  /// The length of the part of a zone that lies before the point.
  [[nodiscard]] double extent(int zone, const Point& point) const;
  /// The distance of the point from the right or the left end of its zone, without cancellation.
  [[nodiscard]] double from_end(const Point& point, bool right) const;
  [[nodiscard]] double place(const Point& point) const;
  /// The point at e, 0 < e < the contact's length.
  [[nodiscard]] Point point_at(double e) const;
  [[nodiscard]] Shares shares(const Point& point) const;
  /// The unknowns that give these tractions.
  [[nodiscard]] Eigen::VectorXd unknowns_of(const std::function<Traction(const Point&)>& traction) const;

 private:
  /// A traction next to an end of a panel.
  struct TractionEnd {
    double least_power = 0, envelope_power = 0;  ///< of t in the traction, and in its envelope
    Tail tail = {};                              ///< of the traction over its envelope
  };
  struct PanelEnd {
    TractionEnd pressure = {}, shear = {};
    double reach = 0, depth = 0;  ///< |s| of the last node with an unknown, and of the last node
    double checked = 0;           ///< |s| of the last midpoint
    double next_length = 0;       ///< of the next panel over this one's, at most 1; 0 at the contact's end
    int value = -1, shear_value = -1;  ///< unknowns of the boundary's values, -1 where they are 0
    bool has_extra_equation = false;   ///< of the boundary where slip turns into stick

    [[nodiscard]] bool is_of_contact() const { return next_length == 0; }
    /// The power of t with which the hat of the pressure at the panel's other end falls to 0 here.
    [[nodiscard]] double hat_power() const { return is_of_contact() ? pressure.least_power : 1; }
  };
  struct Panel {
    int zone, sign, number_in_zone, panels_of_zone;
    double length;
    double sign_before, sign_after;  ///< the neighbours', from which the shear is counted at the zone's ends
    PanelEnd left = {}, right = {};
    int first_node = 0, last_node = 0;        ///< with unknowns
    int first_of_all = 0, last_of_all = 0;    ///< with those beyond
    int first_checked = 0, last_checked = 0;  ///< nodes next to the outermost midpoints
    int pressure = 0, shear = 0;              ///< first unknowns
  };
  static std::size_t at(Eigen::Index index) { return static_cast<std::size_t>(index); }
  void measure_gaps();
  void cut(const Zones& zones);
  void set_ends(const PartialSlipTask& task);
  [[nodiscard]] PanelEnd end(std::size_t panel, bool is_right, const PartialSlipTask& task) const;
  [[nodiscard]] PanelEnd end_of_contact(const Panel& own, bool is_right, const PartialSlipTask& task) const;
  [[nodiscard]] PanelEnd boundary(const Panel& own, const Panel& other, bool is_right,
                                  const PartialSlipTask& task) const;
  /// A traction with these powers of t, whose last node with an unknown is at |s| = reach.
  [[nodiscard]] TractionEnd traction_end(const Tail::Powers& powers, double reach) const;
  [[nodiscard]] double smooth_nats() const { return std::min(nats_, most_smooth_nats); }
  void number_unknowns();
  void add_points(const Panel& panel, int index);
  /// A product of powers of t at both ends, t over the panel's length; where t is larger than the next panel, of 1.
  [[nodiscard]] static Traction envelope(const Panel& panel, const Point& point);
  void add_hats(const Panel& panel, const Point& point, Shares& shares) const;
  /// The factor of a hat at a point. At the last nodes it also stands for all that would follow, sum_k e^(-k h).
  [[nodiscard]] double hat_factor(const Panel& panel, const Point& point) const;
  [[nodiscard]] Rows rows(std::size_t count, const auto& point) const;
  void add_nodes(const Panel& panel, const Point& point, Shares& shares) const;
  void add_shear_of_step(const Panel& panel, const Point& point, Shares& shares) const;

  double nats_, step_;
  double friction_;
  std::vector<Panel> panels_;
  std::vector<std::vector<double>> gaps_;  ///< from a panel's right end to a later one's left end
  std::vector<Point> nodes_;
  std::vector<Midpoint> midpoints_;
  int unknowns_ = 0;
  Rows at_nodes_, at_midpoints_;
};

}  // namespace nipref::fast
