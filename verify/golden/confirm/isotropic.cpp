#include <boost/math/quadrature/gauss.hpp>

#include <nipref/verify/golden/confirm/half_space.hpp>
#include <nipref/verify/golden/confirm/rational.hpp>
#include <nipref/verify/support/mapped.hpp>

namespace nipref::verify::confirm {
namespace {

/// c_T^2/c_L^2.
Float squared_ratio(const Float& poisson) { return (1 - 2 * poisson) / (2 - 2 * poisson); }

/// v_R^2/v_S^2, the root in (0, 1) of Rayleigh's cubic.
Float rayleigh_squared(const Float& poisson) {
  const Float k = squared_ratio(poisson);
  const PolynomialOf<Float> cubic{Float(16 * k - 16), Float(24 - 16 * k), Float(-8), Float(1)};
  Float found = 1;
  for (const Complex& root : roots_of<150>(cubic))
    if (abs(root.imag()) < Float("1e-60")) found = std::min<Float>(found, root.real());
  return found;
}

Float squared_speed(double speed, const Float& cosine) {
  const Float along = Float(speed) * cosine;
  return along * along;
}

LineAnswerByFormula line_at(Arguments x, const Float& cosine) {
  return isotropic_answer(x["poisson"], squared_speed(x["speed"], cosine));
}
LineAnswerByFormula line_at(Arguments x) { return line_at(x, cosine_of(x["psi_deg"])); }

Confirmation closed(const Float& value) {
  return confirmation("closed form", value, abs(value) * Float("1e-80"));
}

SlidingBody die(Arguments x) {
  return {[x](const Float& degrees) { return line_at(x, cosine_of(degrees)); }, x["friction"]};
}

/// int_0^b (b - s) s^a (1 - s)^b ds with a = 1 - b by the binomial series; b is at most about 1/2.
Float small_moment(const Float& b) {
  const Float a = 1 - b;
  Float sum = 0, term = pow(b, a + 2);
  for (int n = 0; n < 1000; ++n) {
    const Float next = term / ((a + n + 1) * (a + n + 2));
    sum += next;
    if (abs(next) < abs(sum) * Float("1e-110")) break;
    term *= (n - b) / (n + 1) * b;
  }
  return sum;
}

/// sum (-1)^k a/((2k + 1)^2 + a^2) = (1/2) int_0^inf sin(a v)/cosh(v) dv, by the acceleration of Cohen, Villegas and
/// Zagier, with an error of 5.8^-terms.
Float alternating_sum(const Float& a) {
  constexpr int terms = 130;
  Float d = pow(3 + sqrt(Float(8)), terms);
  d = (d + 1 / d) / 2;
  Float b = -1, c = -d, sum = 0;
  for (int k = 0; k < terms; ++k) {
    c = b - c;
    const Float odd = 2 * k + 1;
    sum += c * a / (odd * odd + a * a);
    b *= Float(k + terms) * (k - terms) / ((Float(k) + Float("0.5")) * (k + 1));
  }
  return sum / d;
}

/// The integral over t of brock2012 (54), by parts with t = tanh v.
Float rolling_moment(const Float& index) {
  const Float a = 2 * index;
  return Float(1) / 3 - a / 6 * ((1 + a * a) * 2 * alternating_sum(a) - a);
}

Float rolling_index(Arguments x, const Float& cosine) {
  const LineAnswerByFormula line = line_at(x, cosine);
  const Float q = line.coupling / sqrt(line.compliance * line.in_line);
  return log((1 + q) / (1 - q)) / (2 * pi());
}

Float rolling_amplitude(Arguments x, const Float& cosine) {
  const LineAnswerByFormula line = line_at(x, cosine);
  return sqrt(line.in_line /
              (line.compliance * (line.compliance * line.in_line - line.coupling * line.coupling)));
}

/// Solves L B Q = L1 B1 Q1 for the span L by Newton's method, from the solution to first order.
Float finite_span_ratio(Arguments x) {
  const auto slowness = [&](const Float& cosine) -> Float {
    const LineAnswerByFormula line = line_at(x, cosine);
    return sqrt(line.in_line / line.compliance);
  };
  const auto scale = [&](const Float& cosine) -> Float {
    return rolling_amplitude(x, cosine) / slowness(cosine);
  };
  const Float cosine = cosine_of(x["psi_deg"]), span = x["span_over_radius"], one = 1;
  const Float half = rolling_index(x, cosine) / 2, s = slowness(cosine);
  const Float same = span * (slowness(one) - rolling_index(x, one) / 2 * span) * scale(one) / scale(cosine);
  Float found = same / s;
  for (int step = 0; step < 40; ++step) found -= (found * (s - half * found) - same) / (s - 2 * half * found);
  return found / span;
}

Float rolling_creep(Arguments x) {
  const Float cosine = cosine_of(x["psi_deg"]), index = rolling_index(x, cosine);
  const LineAnswerByFormula line = line_at(x, cosine);
  const Float span = rolling_amplitude(x, 1) / rolling_amplitude(x, cosine) * x["span_over_radius"];
  return span * (span / 16 * (1 - 4 * index * index) + index * sqrt(line.in_line / line.compliance));
}

/// The ends of panels from 0 to pi/2, radians, whose lengths grow from `first` at 0 and from `last` at pi/2.
std::vector<Float> panels(const Float& first, const Float& last) {
  const Float middle = pi() / 4;
  std::vector<Float> ends{Float(0), middle, 2 * middle};
  for (Float end = first; end < middle; end *= 2) ends.push_back(end);
  for (Float end = last; end < middle; end *= 2) ends.push_back(2 * middle - end);
  std::ranges::sort(ends);
  return ends;
}

template <unsigned points>
std::vector<WeightedLine> lines_between(const Float& centre, const std::vector<Float>& ends) {
  using Rule = boost::math::quadrature::gauss<Float, points>;
  std::vector<WeightedLine> all;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const Float middle = (ends[i] + ends[i - 1]) / 2, half = (ends[i] - ends[i - 1]) / 2;
    for (std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
      const Float offset = half * Rule::abscissa()[k], weight = half * Rule::weights()[k];
      for (const Float& psi : {Float(middle - offset), Float(middle + offset)})
        for (const int side : {1, -1}) all.push_back({centre + side * psi * 180 / pi(), weight});
    }
  }
  return all;
}

/// An approximation of the logarithm of the ratio of the contact ellipse's axes.
double rough_slenderness(double curvature_ratio) { return 0.62 * std::log(curvature_ratio); }

/// The width of the peak of K about the direction of motion, radians.
Float peak_width(Arguments x) {
  const Float X = squared_speed(x["speed"], 1), critical = rayleigh_squared(x["poisson"]);
  return X == 0 ? Float(1) : std::min<Float>(1, sqrt((critical - X) / X));
}

std::vector<WeightedLine> lines_about_motion(Arguments x, bool coarse) {
  return lines_about(0, peak_width(x), 1, coarse);
}

Float die_force(Arguments x, bool coarse) { return die(x).force(lines_about_motion(x, coarse)); }

Float rolling_force(Arguments x, bool coarse) {
  const Float along = rolling_amplitude(x, 1);
  Float sum = 0;
  for (const auto& [degrees, weight] : lines_about_motion(x, coarse)) {
    const Float cosine = cosine_of(degrees), ratio = along / rolling_amplitude(x, cosine);
    sum += weight * ratio * ratio * rolling_moment(rolling_index(x, cosine));
  }
  return sum * along / 4;
}

ContactEllipse ellipse_at(Arguments x, bool coarse) {
  const double rough = rough_slenderness(x["curvature_ratio"]);
  // The factor 1.2 lets the first panel also resolve an ellipse that the peak of K makes longer.
  const Float narrow = exp(-Float(std::fabs(rough) * 1.2)) / 2, width = peak_width(x) / 2;
  const auto lines = lines_about(0, rough < 0 ? std::min<Float>(narrow, width) : width,
                                 rough > 0 ? std::min<Float>(narrow, width) : Float(width), coarse);
  return {[x](const Float& degrees) { return line_at(x, cosine_of(degrees)); }, lines, x["curvature_ratio"]};
}

Float axis_ratio(Arguments x, bool coarse) { return exp(-ellipse_at(x, coarse).eta); }

Float stiffness(Arguments x, bool coarse) {
  const auto [eta, first, third] = ellipse_at(x, coarse);
  return 8 * pi() / 3 * sqrt(third / (first * first * first));
}

}  // namespace

Methods isotropic_methods() {
  return {
      {"halfspace.compliance", [](Arguments x) { return closed(line_at(x).compliance); }},
      {"halfspace.coupling", [](Arguments x) { return closed(line_at(x).coupling); }},
      {"halfspace.compliance_beyond", [](Arguments x) { return closed(line_at(x).compliance); }},
      {"halfspace.coupling_beyond", [](Arguments x) { return closed(line_at(x).coupling); }},
      {"halfspace.rolling_index_beyond",
       [](Arguments x) {
         const LineAnswerByFormula line = line_at(x);
         return closed(atanh(sqrt(line.compliance * line.in_line) / abs(line.coupling)) / pi());
       }},
      {"halfspace.condition",
       [](Arguments x) {
         return condition_by_difference("difference of the closed form", [x](const Float& factor) {
           return line_at(x, factor * cosine_of(x["psi_deg"])).compliance;
         });
       }},
      {"halfspace.rayleigh",
       [](Arguments x) {
         const Float value = sqrt(rayleigh_squared(x["poisson"]));
         return confirmation("root of Rayleigh's cubic", value, value * Float("1e-80"));
       }},
      {"die.exponent", [](Arguments x) { return closed(-die(x).line(x["psi_deg"]).ahead); }},
      {"die.peak_place", [](Arguments x) { return closed(die(x).line(x["psi_deg"]).ahead - Float(1) / 2); }},
      {"die.span_ratio", [](Arguments x) { return closed(die(x).span_ratio(90)); }},
      {"die.force", by_gauss_rule(die_force)},
      {"rolling.index", [](Arguments x) { return closed(rolling_index(x, cosine_of(x["psi_deg"]))); }},
      {"rolling.span_ratio",
       [](Arguments x) { return closed(rolling_amplitude(x, 1) / rolling_amplitude(x, 0)); }},
      {"rolling.finite_span_ratio",
       [](Arguments x) {
         const Float value = finite_span_ratio(x);
         return confirmation("Newton's method for the span", value, abs(value) * Float("1e-60"));
       }},
      {"rolling.strip",
       [](Arguments x) { return closed(exp(-pi() / (2 * rolling_index(x, cosine_of(x["psi_deg"]))))); }},
      {"rolling.creep", [](Arguments x) { return closed(rolling_creep(x)); }},
      {"rolling.force", by_gauss_rule(rolling_force)},
      {"halfspace.in_line", [](Arguments x) { return closed(line_at(x).in_line); }},
      {"halfspace.across",
       [](Arguments x) { return closed(1 / sqrt(1 - squared_speed(x["speed"], cosine_of(x["psi_deg"])))); }},
      {"halfspace.separation",
       [](Arguments x) {
         const Float rayleigh = sqrt(rayleigh_squared(x["poisson"]));
         return closed(acos(rayleigh / x["speed"]) * 180 / pi());
       }},
      {"ellipse.axis_ratio", by_gauss_rule(axis_ratio)},
      {"ellipse.stiffness", by_gauss_rule(stiffness)}};
}

std::vector<WeightedLine> lines_about(const Float& centre, const Float& first, const Float& last,
                                      bool coarse) {
  return coarse ? lines_between<40>(centre, panels(first, last))
                : lines_between<52>(centre, panels(first, last));
}

Confirm by_gauss_rule(Float (*value)(Arguments, bool coarse)) {
  return [value](Arguments x) {
    const Float fine = value(x, false);
    return confirmation("Gauss's rule over the lines", fine,
                        abs(fine - value(x, true)) + abs(fine) * Float("1e-70"));
  };
}

Confirmation condition_by_difference(const char* method,
                                     const std::function<Float(const Float& factor)>& compliance_at) {
  const Float step("1e-40");
  const Float slope = log(compliance_at(1 + step) / compliance_at(1 - step)) / (2 * step);
  return confirmation(method, slope, std::max<Float>(1, abs(slope)) * Float("1e-58"));
}

LineAnswerByFormula isotropic_answer(const Float& poisson, const Float& X) {
  const Float k = squared_ratio(poisson), wS = sqrt(1 - X), wD = sqrt(1 - k * X);
  const Float defect = (1 + k - k * X) / (1 + wS * wD), rayleigh = 4 - X - 4 * defect;
  return {wD / rayleigh, (2 * defect - 1) / rayleigh, 0, wS / rayleigh};
}

SlidingLine SlidingBody::line(const Float& degrees) const {
  const auto [compliance, coupling, coupling_across, in_line] = answers(degrees);
  const Float shear = friction * (cosine_of(degrees) * coupling - sine_of(degrees) * coupling_across);
  const Float ahead = atan2(compliance, shear) / pi(), behind = 1 - ahead;
  return {ahead, behind, sqrt(compliance * compliance + shear * shear),
          pow(behind, behind) * pow(ahead, ahead)};
}

Float SlidingBody::span_ratio(const Float& degrees) const {
  const SlidingLine along = line(0), other = line(degrees);
  return along.Q / other.Q * other.h / along.h;
}

Float SlidingBody::force(const std::vector<WeightedLine>& lines) const {
  const SlidingLine along = line(0);
  Float sum = 0;
  for (const auto& [degrees, weight] : lines) {
    const SlidingLine there = line(degrees);
    const Float span = along.Q / along.h * there.h / there.Q;
    sum += weight * span * span * span / there.h * there.moment();
  }
  return sum;
}

Float SlidingLine::moment() const {
  const Float& b = behind <= ahead ? behind : ahead;
  const Float a = 1 - b, beta = a * b * pi() / (2 * sin(pi() * b));
  return 2 * small_moment(b) + beta * ((a + 1) / 3 - b);
}

ContactEllipse::ContactEllipse(const LineAnswers& answers, const std::vector<WeightedLine>& lines,
                               double curvature_ratio) {
  struct Term {
    Float cosine2, sine2, weighted;  ///< cosine and sine of twice the angle; the weight times K
  };
  const auto terms = mapped(lines, [&](const WeightedLine& line) -> Term {
    const Float twice = 2 * radians(line.degrees);
    return {cos(twice), sin(twice), line.weight * answers(line.degrees).compliance};
  });
  const Float ratio = curvature_ratio, wanted = (1 - ratio) / (1 + ratio);
  const auto defect = [&](const Float& p, const Float& q) {
    eta = sqrt(p * p + q * q);
    const Float turning = eta == 0 ? Float(1) : Float(sinh(eta) / eta), mean = cosh(eta);
    Float cosine = 0, sine = 0;
    first = third = 0;
    for (const auto& [cosine2, sine2, weighted] : terms) {
      const Float square = mean + turning * (p * cosine2 + q * sine2);
      const Float term = weighted / sqrt(square), cubed = term / square;
      first += term;
      third += cubed;
      cosine += cubed * cosine2;
      sine += cubed * sine2;
    }
    return std::pair<Float, Float>{cosine / third - wanted, sine / third};
  };
  const Float step("1e-40");
  Float p = rough_slenderness(curvature_ratio), q = 0, length = 1;
  for (int k = 0; k < 60 && length > Float("1e-60"); ++k) {
    const auto [c_p, s_p] = defect(p + step, q);
    const auto [c_q, s_q] = defect(p, q + step);
    const auto [c, s] = defect(p, q);
    const Float a = (c_p - c) / step, b = (c_q - c) / step, d = (s_p - s) / step, e = (s_q - s) / step;
    const Float determinant = a * e - b * d, dp = -(c * e - s * b) / determinant,
                dq = -(s * a - c * d) / determinant;
    length = sqrt(dp * dp + dq * dq);
    p += dp / std::max<Float>(1, length);
    q += dq / std::max<Float>(1, length);
  }
  defect(p, q);
}

}  // namespace nipref::verify::confirm
