#pragma once
#include <nipref/verify/golden/confirm/number.hpp>

namespace nipref::verify::confirm {

inline Float radians(const Float& degrees) { return degrees * pi() / 180; }
/// Exactly 0 at 90 degrees.
inline Float cosine_of(const Float& degrees) { return sin(radians(90 - abs(degrees))); }
inline Float sine_of(const Float& degrees) { return sin(radians(degrees)); }

/// The response of a line times mu.
struct LineAnswerByFormula {
  Float compliance, coupling, coupling_across, in_line;
};

/// The response of an isotropic half-space with mu = 1 at the squared phase speed X, in closed form without 0/0 at X
/// = 0. (brock2012 18a and its counterpart for the shear)
LineAnswerByFormula isotropic_answer(const Float& poisson, const Float& X);

/// A line of an ellipse's integrals over half a turn: cosine and sine of twice its angle from the motion.
struct WeightedLine {
  Float cosine2, sine2, weight, compliance;
};

/// The ellipse w^2 = cosh eta + sinh eta/eta (p cos 2 psi + q sin 2 psi), eta = |(p, q)|, for which int K n n/w^3 is 1
/// across the motion where it is 1/curvature_ratio along it, by Newton's method with difference quotients: eta is the
/// logarithm of the axes' ratio, `first` int K/w, and `third` int K/w^3.
struct ContactEllipse {
  Float eta, first, third;

  ContactEllipse(const std::vector<WeightedLine>& lines, double curvature_ratio);
};

/// A line of a sliding contact: the parts of the span ahead of the load and behind it, and h and Q of brock2012 (33).
struct SlidingShape {
  Float ahead, behind, h, Q;

  SlidingShape(const LineAnswerByFormula& line, const Float& friction, const Float& cosine,
               const Float& sine);
  /// int |s - behind| s^ahead (1 - s)^behind ds over 0 < s < 1.
  [[nodiscard]] Float moment() const;
};

}  // namespace nipref::verify::confirm
