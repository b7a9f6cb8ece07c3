#pragma once
#include <vector>

#include <nipref/verify/golden/confirm/number.hpp>

namespace nipref::verify::confirm {

/// Numbers for half-spaces: at X = 1e-44 a hundred of their digits are left after cancellation.
using Wave = Number<150>;

inline Wave radians(const Wave& degrees) { return degrees * pi<Wave>() / 180; }
/// Exactly 0 at 90 degrees.
inline Wave cosine_of(const Wave& degrees) { return sin(radians(90 - abs(degrees))); }
inline Wave sine_of(const Wave& degrees) { return sin(radians(degrees)); }

/// The response of a line times mu.
struct LineAnswerByFormula {
  Wave compliance, coupling, coupling_across, in_line;
};

/// The response of an isotropic half-space with mu = 1 at the squared phase speed X, in closed form without 0/0 at X
/// = 0. (brock2012 18a and its counterpart for the shear)
LineAnswerByFormula isotropic_answer(const Wave& poisson, const Wave& X);

/// A line of an ellipse's integrals over half a turn: cosine and sine of twice its angle from the motion.
struct WeightedLine {
  Wave cosine2, sine2, weight, compliance;
};

/// The ellipse w^2 = cosh eta + sinh eta/eta (p cos 2 psi + q sin 2 psi), eta = |(p, q)|, for which int K n n/w^3 is 1
/// across the motion where it is 1/curvature_ratio along it, by Newton's method with difference quotients: eta is the
/// logarithm of the axes' ratio, `first` int K/w, and `third` int K/w^3.
struct ContactEllipse {
  Wave eta, first, third;

  ContactEllipse(const std::vector<WeightedLine>& lines, double curvature_ratio);
};

/// A line of a sliding contact: the parts of the span ahead of the load and behind it, and h and Q of brock2012 (33).
struct SlidingShape {
  Wave ahead, behind, h, Q;

  SlidingShape(const LineAnswerByFormula& line, const Wave& friction, const Wave& cosine, const Wave& sine);
  /// int |s - behind| s^ahead (1 - s)^behind ds over 0 < s < 1.
  [[nodiscard]] Wave moment() const;
};

}  // namespace nipref::verify::confirm
