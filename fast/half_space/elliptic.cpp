#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/internal/compliance_table.hpp>
#include <nipref/fast/half_space/internal/direction_words.hpp>
#include <nipref/fast/half_space/internal/line_errors.hpp>
#include <nipref/fast/number/internal/adaptive_panels.hpp>
#include <nipref/fast/number/internal/checks.hpp>
#include <nipref/fast/number/internal/jacobi_amplitude.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {

using data::BadInput;
using internal::Compliance;

namespace {

/// An ellipse; its matrix is L L^T with L = [major, across] diag(a, b).
struct Ellipse {
  double a, b;
  Direction major;
};

/// The entries 11, 12 and 22 of a symmetric 2x2 matrix.
using Symmetric = Eigen::Vector3d;

/// The integrals over all directions psi that determine the shape. m is the unit vector along L^T n, and w = |L^T n|.
struct Balance {
  std::array<double, 5> sums;  ///< int K m1^(4-j) m2^j/w dpsi, j = 0 ... 4
  Symmetric curvatures;        ///< L^T curvatures L

  [[nodiscard]] double sum() const { return sums[0] + 2 * sums[2] + sums[4]; }  ///< int K/w dpsi
  /// A function of the ellipse that is concave in L L^T, and stationary where int K n n/w^3 dpsi = curvatures.
  [[nodiscard]] double objective() const { return -2 * sum() - curvatures[0] - curvatures[2]; }
  /// The gradient of the objective.
  [[nodiscard]] Symmetric gradient() const {
    return Symmetric(sums[0] + sums[2], sums[1] + sums[3], sums[2] + sums[4]) - curvatures;
  }
};

double checked_compliance(const SurfaceResponse& response, Direction psi) {
  const double compliance = response(psi).compliance;
  if (!(compliance > 0) || !std::isfinite(compliance))
    throw BadInput("compliance", compliance, "must be positive and finite: is the speed subcritical?");
  return compliance;
}

Symmetric scaled_curvatures(const Ellipse& ellipse, const Indenter& body) {
  const auto [a, b, major] = ellipse;
  const Direction across{-major.sine, major.cosine, -major.sine_low, major.cosine_low};
  const double twist = (body.curvature_2 - body.curvature_1) * major.cosine * major.sine;
  return {a * a * body.curvature(major), a * b * twist, b * b * body.curvature(across)};
}

/// The variable u with psi - major = am(u, k), k' = b/a, -K <= u <= K. As functions of u, w = a dn(u) and
/// m = (cd, k' sd) are smooth however slender the ellipse is.
class Parameter {
 public:
  explicit Parameter(double ratio) : ratio_(ratio), jacobi_(ratio) {}

  struct Point {
    Direction from_major, m;
  };

  /// The point at u = share K, -1 <= share <= 1.
  [[nodiscard]] Point at(double share) const {
    const double magnitude = std::fabs(share);
    const bool near_major = magnitude <= 0.5;
    const auto [sn, cn, dn] = jacobi_((near_major ? magnitude : 1 - magnitude) * quarter_period());
    const double cd = cn / dn, sd = ratio_ * sn / dn;
    // Nearer to the minor axis the functions of K - u are used.
    const auto [c, s, m1, m2] = near_major ? std::array{cn, sn, cd, sd} : std::array{sd, cd, sn, cn};
    return {{c, std::copysign(s, share)}, {m1, std::copysign(m2, share)}};
  }
  [[nodiscard]] double quarter_period() const { return jacobi_.quarter_period(); }

 private:
  double ratio_;
  JacobiAmplitude jacobi_;
};

/// The integrands of Balance::sums as functions of u/K.
class Terms {
 public:
  Terms(const Ellipse& ellipse, const Compliance& compliance)
      : ellipse_(ellipse),
        compliance_(compliance),
        parameter_(ellipse.b / ellipse.a),
        factor_(parameter_.quarter_period() / ellipse.a) {}

  std::array<double, 5> operator()(double share) const {
    const auto [from_major, m] = parameter_.at(share);
    const double weight = factor_ * compliance_(from_major.turned(ellipse_.major));
    const double m11 = m.cosine * m.cosine, m12 = m.cosine * m.sine, m22 = m.sine * m.sine;
    return {weight * m11 * m11, weight * m11 * m12, weight * m11 * m22, weight * m12 * m22,
            weight * m22 * m22};
  }

 private:
  Ellipse ellipse_;
  const Compliance& compliance_;
  Parameter parameter_;
  double factor_;
};

using Mesh = internal::AdaptedPanels<5>;

Mesh adapted_mesh(const Ellipse& ellipse, const Compliance& compliance) {
  return internal::adapt_panels<5>(Terms(ellipse, compliance), -1, 1);
}

/// The integrals for an ellipse, on panels that were made for a similar ellipse.
Balance balance(const Ellipse& ellipse, const Indenter& body, const Compliance& compliance,
                const std::vector<internal::Subinterval>& panels) {
  Balance result{{}, scaled_curvatures(ellipse, body)};
  const Terms terms(ellipse, compliance);
  for (const internal::Subinterval& panel : panels) {
    internal::visit_nodes(panel, [&](double share, double weight) {
      const std::array<double, 5> term = terms(share);
      for (std::size_t j = 0; j < term.size(); ++j) result.sums[j] += weight * term[j];
    });
  }
  return result;
}

/// Minus the second derivative of the objective with respect to E, where L becomes L (1 + E/2).
Eigen::Matrix3d curvature_of(const Balance& at) {
  const auto& q = at.sums;
  Eigen::Matrix3d hessian;
  hessian << q[0], 2 * q[1], q[2], q[1], 2 * q[2], q[3], q[2], 2 * q[3], q[4];
  return 1.5 * hessian;
}

/// The change E of a step of Newton's method.
Symmetric newton_step(const Balance& at) { return Elimination(curvature_of(at)).solve(at.gradient()); }

/// The ellipse of L (1 + E/2). Its minor axis is computed from the determinant, where nothing cancels.
Ellipse moved(const Ellipse& from, const Symmetric& change) {
  const double e11 = change[0], e12 = change[1], e22 = change[2];
  const double b11 = from.a * (1 + e11 / 2), b12 = from.a * e12 / 2;
  const double b21 = from.b * e12 / 2, b22 = from.b * (1 + e22 / 2);
  const double m11 = b11 * b11 + b12 * b12, m12 = b11 * b21 + b12 * b22, m22 = b21 * b21 + b22 * b22;
  const double a = std::sqrt((m11 + m22) / 2 + std::hypot((m11 - m22) / 2, m12));
  const double determinant = from.a * from.b * ((1 + e11 / 2) * (1 + e22 / 2) - e12 * e12 / 4);
  const double angle = std::atan2(2 * m12, m11 - m22) / 2;
  return {a, std::min(a, std::fabs(determinant) / a), Direction::of_angle(angle).turned(from.major)};
}

double contraction(const Symmetric& a, const Symmetric& b) { return a.dot(b) + a[1] * b[1]; }

/// Improves `ellipse` by Newton's method and returns the length of the first step, or infinity if the method has not
/// converged. `balance_at` gives the Balance of an ellipse.
template <class BalanceAt>
double solve(Ellipse& ellipse, const BalanceAt& balance_at) {
  constexpr int most_steps = 12;
  Balance here = balance_at(ellipse);
  double first = 0;
  for (int count = 0; count < most_steps; ++count) {
    const Symmetric step = newton_step(here);
    const double length = std::sqrt(contraction(step, step)), slope = contraction(here.gradient(), step);
    if (count == 0) first = length;
    if (length < 1e-7) {  // convergence is quadratic: after this step the error is rounding
      ellipse = moved(ellipse, step);
      return first;
    }
    for (double part = std::min(1.0, 1 / length);; part /= 2) {
      const Ellipse there = moved(ellipse, part * step);
      const Balance next = balance_at(there);
      const double rounding = 1e-13 * std::fabs(here.objective());
      if (next.objective() >= here.objective() + 0.1 * part * slope - rounding || part < 1. / 64) {
        ellipse = there;
        here = next;
        break;
      }
    }
  }
  return std::numeric_limits<double>::infinity();
}

/// int K/w dpsi.
Estimate sum_of(const Mesh& mesh) {
  const auto& sums = mesh.integral;
  return {sums[0].value + 2 * sums[2].value + sums[4].value,
          sums[0].error + 2 * sums[2].error + sums[4].error};
}

/// Eight roundings of 2^-53. The formulas to whose relative errors it is added have no more: seven in a^2 times the
/// curvature along an axis, five in a volume, eight in the edge's distance along the major axis; or a cube root to four
/// units in the last place.
constexpr double few_roundings = 8 * 0x1p-53;

/// The largest change E of the ellipse that can result from errors of the integrals, including the rounding of K, and
/// of the curvatures.
Symmetric error_of_change(const Balance& at, const Mesh& mesh) {
  const auto of_pair = [&](std::size_t j) { return mesh.integral[j].error + mesh.integral[j + 2].error; };
  const Symmetric gradient =
      Symmetric(of_pair(0), of_pair(1), of_pair(2)) + few_roundings * at.curvatures.cwiseAbs();
  return curvature_of(at).inverse().cwiseAbs() * gradient;
}

/// The first approximation: its axes are along those of the body, and its axis ratio is Hertz's to a few per cent.
Ellipse first_shape(const Indenter& body) {
  const auto [small, large] = std::minmax(body.curvature_1, body.curvature_2);
  const Direction major = body.curvature_1 <= body.curvature_2 ? Direction{1, 0} : Direction{0, 1};
  return {1, std::pow(small / large, 0.62), major};
}

/// The ellipse of this shape for which the traces of int K n n/w^3 dpsi and of the curvatures agree in its frame.
Ellipse of_fitting_size(const Ellipse& shape, const Indenter& body, const Mesh& mesh) {
  const Symmetric curvatures = scaled_curvatures(shape, body);
  const double scale = std::cbrt(sum_of(mesh).value / (curvatures[0] + curvatures[2]));
  return {shape.a * scale, shape.b * scale, shape.major};
}

/// Finds the ellipse with a table of the compliance. As the ellipse may turn, while the peaks of the compliance do not,
/// the panels of the first ellipse may not suffice. If the iteration fails with them, each ellipse gets its own panels.
Ellipse approximate_ellipse(const Indenter& body, const Compliance& table) {
  const Ellipse shape = first_shape(body);
  const Mesh mesh = adapted_mesh(shape, table);
  Ellipse ellipse = of_fitting_size(shape, body, mesh);
  const auto on = [&](const Ellipse& at, const Mesh& used) { return balance(at, body, table, used.panels); };
  if (std::isinf(solve(ellipse, [&](const Ellipse& at) { return on(at, mesh); })))
    solve(ellipse, [&](const Ellipse& at) { return on(at, adapted_mesh(at, table)); });
  return ellipse;
}

}  // namespace

EllipticContact::EllipticContact(const SurfaceResponse& response, const Indenter& body) {
  body.check();
  const double ratio = body.curvature_1 / body.curvature_2;
  if (!(ratio >= 1e-10 && ratio <= 1e10))
    throw BadInput("curvature_1/curvature_2", ratio, "must lie between 1e-10 and 1e10");
  // A narrow range of supercritical lines about the motion could lie between the nodes of a panel. As the motion is
  // mostly along an axis of the body, these axes are checked.
  for (const Direction axis : {Direction{1, 0}, Direction{0, 1}})
    static_cast<void>(checked_compliance(response, axis));
  constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
  constexpr int most_meshes = 10;
  const Compliance exact = [&](Direction psi) { return checked_compliance(response, psi); };
  Ellipse ellipse = approximate_ellipse(body, internal::ComplianceTable(exact));
  Mesh mesh = adapted_mesh(ellipse, exact);
  const auto on_panels = [&](const Ellipse& at) { return balance(at, body, exact, mesh.panels); };
  double change = solve(ellipse, on_panels);
  for (int meshes = 1; meshes < most_meshes && !(change < rounding); ++meshes) {
    const double before = change;
    mesh = adapted_mesh(ellipse, exact);
    change = solve(ellipse, on_panels);
    if (std::isfinite(before) && change > before / 2) break;  // stagnation at the rounding of the compliance
  }
  major_length_ = ellipse.a;
  minor_length_ = ellipse.b;
  const bool backwards = ellipse.major.cosine < 0 || (ellipse.major.cosine == 0 && ellipse.major.sine < 0);
  major_ = backwards ? ellipse.major.turned({-1, 0}) : ellipse.major;
  const Balance found = balance(ellipse, body, exact, mesh.panels);
  sum_ = found.sum();
  const Symmetric error = error_of_change(found, mesh).array() + change;
  set_errors(error[0], error[1], error[2]);
  const auto share = [&](std::size_t j) { return std::fabs(found.sums[j] + found.sums[j + 2]) / sum_; };
  sum_error_ =
      sum_of(mesh).error / sum_ + share(0) * major_error_ + share(2) * minor_error_ + share(1) * twist_error_;
}

// In the frame of the ellipse its matrix is (a^2 (1 + E11), a b E12; ., b^2 (1 + E22)).
void EllipticContact::set_errors(double e11, double e12, double e22) {
  const double a = major_length_, b = minor_length_, twist = a * b * e12;
  // A lower bound of a^2 - b^2. If it is not positive, the ellipse may be a circle, and its axes may have any direction.
  const double apart = (a - b) * (a + b) - a * a * (e11 + few_roundings) - b * b * (e22 + few_roundings);
  const double turn = apart > 0 ? std::min(twist / apart, std::numbers::pi / 2) : std::numbers::pi / 2;
  const double of_turn = twist * std::min(1., turn);
  twist_error_ = e12;
  turn_ = turn;
  major_error_ = few_roundings + (e11 + of_turn / (a * a)) / 2;
  minor_error_ = few_roundings + (e22 + of_turn / (b * b)) / 2;
}

Estimate EllipticContact::axis_ratio() const {
  const double ratio = minor_length_ / major_length_;
  return {ratio, ratio * (major_error_ + minor_error_)};
}

Estimate EllipticContact::orientation() const {
  const double angle = std::atan2(major_.sine, major_.cosine);
  // The error is correct to first order in the turn; if the turn is not small, any angle is possible.
  constexpr double small = 0.25;
  return {angle, turn_ < small ? turn_ + few_roundings * std::fabs(angle) : std::numbers::pi / 2};
}

Estimate EllipticContact::radius_ratio(Direction psi) const {
  internal::check_direction("psi", psi);
  const double ratio = minor_length_ / major_length_;
  const double along = psi.cosine * major_.cosine + psi.sine * major_.sine;
  const double across = psi.sine * major_.cosine - psi.cosine * major_.sine;
  const double root = std::hypot(ratio * along, across), share = across / root;
  // The two products in `across` may cancel. Each has three roundings with those of its factors, six together.
  const double turn = turn_ + few_roundings * std::fabs(psi.sine * major_.cosine);
  const double of_turn = std::fabs(along * share / root) * turn;
  const double relative = share * share * (major_error_ + minor_error_) + std::min(of_turn, 1 / ratio);
  return {ratio / root, ratio / root * (relative + few_roundings)};
}

Estimate EllipticContact::span_ratio(Direction psi, Direction to) const {
  const Estimate radius = radius_ratio(psi), other = radius_ratio(to);
  const double ratio = radius.value / other.value;
  return {ratio, ratio * (radius.error / radius.value + other.error / other.value + few_roundings)};
}

Estimate EllipticContact::pressure(const EllipticLoad& load, Direction psi, double x) const {
  internal::check_finite("x", x);
  const Estimate end = radius_ratio(psi) * load.semi_major;
  // The distances from the ends are rounded by 2^-53 of at most |x| + end; the errors of `end` include eight of its own.
  const Estimate shape = internal::between_ends(
      end.value - x, end.value + x, end.error + 0x1p-52 * std::fabs(x),
      [&](double ahead, double behind) { return std::sqrt(ahead * behind) / end.value; });
  return load.peak_pressure * Estimate{shape.value, shape.error + shape.value * end.error / end.value};
}

// The load for axes multiplied by `factor`. The pressure follows from int K n n/w^3 dpsi = factor^-3 curvatures.
EllipticLoad EllipticContact::scaled(const Estimate& factor) const {
  const double factor_error = factor.error / factor.value + few_roundings;
  const auto estimate = [&](double value, double error) { return Estimate{value, value * error}; };
  const double root = factor.value, a = major_length_, b = minor_length_;
  return {estimate(root * a, factor_error + major_error_), estimate(root * b, factor_error + minor_error_),
          estimate(root * root * sum_ / 2, 2 * factor_error + sum_error_),
          estimate(4 * std::numbers::pi / 3 * root * root * root, 3 * factor_error),
          estimate(2 * root / (a * b), factor_error + major_error_ + minor_error_)};
}

EllipticLoad EllipticContact::for_force(double force) const {
  internal::check_positive("force", force);
  EllipticLoad load = scaled({std::cbrt(force / (4 * std::numbers::pi / 3)), 0});
  load.force = {force, 0};
  return load;
}

EllipticLoad EllipticContact::for_approach(double approach) const {
  internal::check_positive("approach", approach);
  const double root = std::sqrt(2 * approach / sum_);
  EllipticLoad load = scaled({root, root * sum_error_ / 2});
  load.approach = {approach, 0};
  return load;
}

EllipticLoad EllipticContact::for_radius(Direction psi, double radius) const {
  internal::check_positive("radius", radius);
  const auto [ratio, error] = radius_ratio(psi);
  const double root = radius / (ratio * major_length_);
  return scaled({root, root * (error / ratio + major_error_)});
}

}  // namespace nipref::fast
