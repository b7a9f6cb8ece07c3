#pragma once
#include <nipref/verify/golden/confirm/number.hpp>

namespace nipref::verify::confirm {

inline Float radians(const Float& degrees) { return degrees * pi() / 180; }
/// The cosine of an angle in degrees. It is exactly 0 at 90 degrees.
inline Float cosine_of(const Float& degrees) { return sin(radians(90 - abs(degrees))); }
inline Float sine_of(const Float& degrees) { return sin(radians(degrees)); }

/// The response of a half-space along a line (see fast::LineResponse), multiplied by the shear modulus mu.
struct LineAnswerByFormula {
  Float compliance, coupling, coupling_across, in_line;
};
/// The response of a surface as a function of the angle between line and direction of motion, in degrees.
using LineAnswers = std::function<LineAnswerByFormula(const Float& degrees)>;

/// The response of an isotropic half-space with mu = 1 at the squared phase speed X, in closed form without 0/0 at X
/// = 0. (brock2012 18a and its counterpart for the shear)
LineAnswerByFormula isotropic_answer(const Float& poisson, const Float& X);

/// A node of a quadrature rule for integrals over all lines, that is over half a turn.
struct WeightedLine {
  Float degrees, weight;
};
/// Gauss's rule on panels on both sides of the line at `centre`, in degrees. The panels' lengths, in radians, grow from
/// `first` at this line, and from `last` at the line across it. The coarse rule has fewer points.
std::vector<WeightedLine> lines_about(const Float& centre, const Float& first, const Float& last,
                                      bool coarse);
/// Returns the method with the value of the fine rule and, as error estimate, its difference from the coarse rule.
Confirm by_gauss_rule(Float (*value)(Arguments, bool coarse));

/// The contact ellipse w^2 = cosh eta + sinh eta/eta (p cos 2 psi + q sin 2 psi), eta = |(p, q)|. Newton's method with
/// difference quotients makes the tensor int K n n/w^3 diagonal, with a ratio 1/curvature_ratio of its components along
/// and across the motion. eta is the logarithm of the axes' ratio, `first` int K/w, and `third` int K/w^3.
struct ContactEllipse {
  Float eta, first, third;

  ContactEllipse(const LineAnswers& answers, const std::vector<WeightedLine>& lines, double curvature_ratio);
};

/// A line of a sliding contact: the parts of the span ahead of the load and behind it, and h and Q of brock2012 (33).
struct SlidingLine {
  Float ahead, behind, h, Q;

  /// int |s - behind| s^ahead (1 - s)^behind ds over 0 < s < 1.
  [[nodiscard]] Float moment() const;
};

/// A sliding contact of a body with equal curvatures.
struct SlidingBody {
  LineAnswers answers;
  Float friction;

  [[nodiscard]] SlidingLine line(const Float& degrees) const;
  [[nodiscard]] Float span_ratio(const Float& degrees) const;  ///< the line's span over that along the motion
  [[nodiscard]] Float force(const std::vector<WeightedLine>& lines) const;
};

/// d ln K/d ln speed by a central difference, which loses 40 digits. compliance_at(f) is K at f times the speed.
Confirmation condition_by_difference(const char* method,
                                     const std::function<Float(const Float& factor)>& compliance_at);

}  // namespace nipref::verify::confirm
