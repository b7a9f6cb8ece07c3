#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <nipref/verify/golden/confirm/half_space_number.hpp>
#include <nipref/verify/support/mapped.hpp>

namespace nipref::verify::confirm {
namespace {

/// c_T^2/c_L^2.
Wave squared_ratio(const Wave& poisson) { return (1 - 2 * poisson) / (2 - 2 * poisson); }

/// v_R^2/v_S^2, the root in (0, 1) of Rayleigh's cubic.
Wave rayleigh_squared(const Wave& poisson) {
  const Wave k = squared_ratio(poisson);
  const auto cubic = [&](const auto& x, const auto& ratio) {
    return ((x - 8) * x + (24 - 16 * ratio)) * x - 16 * (1 - ratio);
  };
  double low = 0, high = 1;
  const auto rough = static_cast<double>(k);
  for (int step = 0; step < 50; ++step) (cubic((low + high) / 2, rough) < 0 ? low : high) = (low + high) / 2;
  Wave x = (low + high) / 2;
  for (int step = 0; step < 6; ++step) x -= cubic(x, k) / ((3 * x - 16) * x + (24 - 16 * k));
  return x;
}

Wave squared_speed(double speed, const Wave& cosine) {
  const Wave along = Wave(speed) * cosine;
  return along * along;
}

LineAnswerByFormula line_at(Arguments x, const Wave& cosine) {
  return isotropic_answer(x["poisson"], squared_speed(x["speed"], cosine));
}
LineAnswerByFormula line_at(Arguments x) { return line_at(x, cosine_of(x["psi_deg"])); }

Confirmation closed(const Wave& value) {
  return confirmation<Wave>("closed form", value, abs(value) * Wave("1e-80"));
}

/// d ln K/d ln speed by the derivative of the closed form.
Wave condition(Arguments x) {
  const Wave k = squared_ratio(x["poisson"]), X = squared_speed(x["speed"], cosine_of(x["psi_deg"]));
  const Wave wS = sqrt(1 - X), wD = sqrt(1 - k * X), product = wS * wD;
  const Wave product_slope = -(wD / wS + k * wS / wD) / 2;
  const Wave defect = (1 + k - k * X) / (1 + product);
  const Wave defect_slope = -(k + defect * product_slope) / (1 + product);
  return 2 * X * ((1 + 4 * defect_slope) / (4 - X - 4 * defect) - k / (2 * wD * wD));
}

SlidingShape shape_at(Arguments x, double friction, const Wave& degrees) {
  const Wave cosine = cosine_of(degrees);
  return {line_at(x, cosine), friction, cosine, sine_of(degrees)};
}

/// int_0^b (b - s) s^a (1 - s)^b ds with a = 1 - b by the binomial series; b is at most about 1/2.
Wave small_moment(const Wave& b) {
  const Wave a = 1 - b;
  Wave sum = 0, term = pow(b, a + 2);
  for (int n = 0; n < 1000; ++n) {
    const Wave next = term / ((a + n + 1) * (a + n + 2));
    sum += next;
    if (abs(next) < abs(sum) * Wave("1e-110")) break;
    term *= (n - b) / (n + 1) * b;
  }
  return sum;
}

/// sum (-1)^k a/((2k + 1)^2 + a^2) = (1/2) int_0^inf sin(a v)/cosh(v) dv, by the acceleration of Cohen, Villegas and
/// Zagier: an error of 5.8^-terms.
Wave alternating_sum(const Wave& a) {
  constexpr int terms = 130;
  Wave d = pow(3 + sqrt(Wave(8)), terms);
  d = (d + 1 / d) / 2;
  Wave b = -1, c = -d, sum = 0;
  for (int k = 0; k < terms; ++k) {
    c = b - c;
    const Wave odd = 2 * k + 1;
    sum += c * a / (odd * odd + a * a);
    b *= Wave(k + terms) * (k - terms) / ((Wave(k) + Wave("0.5")) * (k + 1));
  }
  return sum / d;
}

/// The integral over t of brock2012 (54), by parts with t = tanh v.
Wave rolling_moment(const Wave& index) {
  const Wave a = 2 * index;
  return Wave(1) / 3 - a / 6 * ((1 + a * a) * 2 * alternating_sum(a) - a);
}

Wave rolling_index(Arguments x, const Wave& cosine) {
  const LineAnswerByFormula line = line_at(x, cosine);
  const Wave q = line.coupling / sqrt(line.compliance * line.in_line);
  return log((1 + q) / (1 - q)) / (2 * pi<Wave>());
}

Wave rolling_amplitude(Arguments x, const Wave& cosine) {
  const LineAnswerByFormula line = line_at(x, cosine);
  return sqrt(line.in_line /
              (line.compliance * (line.compliance * line.in_line - line.coupling * line.coupling)));
}

/// By Newton's method for the span L of L B Q = L1 B1 Q1, from the root of first order.
Wave finite_span_ratio(Arguments x) {
  const auto slowness = [&](const Wave& cosine) -> Wave {
    const LineAnswerByFormula line = line_at(x, cosine);
    return sqrt(line.in_line / line.compliance);
  };
  const auto scale = [&](const Wave& cosine) -> Wave {
    return rolling_amplitude(x, cosine) / slowness(cosine);
  };
  const Wave cosine = cosine_of(x["psi_deg"]), span = x["span_over_radius"], one = 1;
  const Wave half = rolling_index(x, cosine) / 2, s = slowness(cosine);
  const Wave same = span * (slowness(one) - rolling_index(x, one) / 2 * span) * scale(one) / scale(cosine);
  Wave found = same / s;
  for (int step = 0; step < 40; ++step) found -= (found * (s - half * found) - same) / (s - 2 * half * found);
  return found / span;
}

/// poisson, speed, span over radius, degrees.
Wave rolling_creep(Arguments x) {
  const Wave cosine = cosine_of(x["psi_deg"]), index = rolling_index(x, cosine);
  const LineAnswerByFormula line = line_at(x, cosine);
  const Wave span = rolling_amplitude(x, 1) / rolling_amplitude(x, cosine) * x["span_over_radius"];
  return span * (span / 16 * (1 - 4 * index * index) + index * sqrt(line.in_line / line.compliance));
}

using Integrand = std::function<Wave(const Wave& psi)>;

/// The ends of panels from 0 to pi/2, radians, whose lengths grow from `first` at 0 and from `last` at pi/2.
std::vector<Wave> panels(const Wave& first, const Wave& last) {
  std::vector<Wave> ends{Wave(0)}, behind{pi<Wave>() / 2};
  const Wave middle = pi<Wave>() / 4;
  for (Wave step = std::min<Wave>(first, middle); ends.back() < middle; step = ends.back())
    ends.push_back(std::min<Wave>(middle, ends.back() + step));
  for (Wave step = std::min<Wave>(last, middle); pi<Wave>() / 2 - behind.back() < middle;
       step = pi<Wave>() / 2 - behind.back())
    behind.push_back(std::max<Wave>(middle, behind.back() - step));
  ends.insert(ends.end(), behind.rbegin() + 1, behind.rend());
  return ends;
}

/// The directions and weights of Gauss's rule on the panels.
struct Direction {
  Wave cosine, sine, weight;
};

template <unsigned points>
std::vector<Direction> directions_of(const std::vector<Wave>& ends) {
  using Rule = boost::math::quadrature::gauss<Wave, points>;
  std::vector<Direction> all;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const Wave middle = (ends[i] + ends[i - 1]) / 2, half = (ends[i] - ends[i - 1]) / 2;
    for (std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
      const Wave offset = half * Rule::abscissa()[k], weight = half * Rule::weights()[k];
      for (const Wave& psi : {Wave(middle - offset), Wave(middle + offset)}) {
        all.push_back({cos(psi), sin(psi), weight});
        if (offset == 0) break;
      }
    }
  }
  return all;
}

std::vector<Direction> directions_between(const std::vector<Wave>& ends, bool coarse) {
  return coarse ? directions_of<40>(ends) : directions_of<52>(ends);
}

/// About the logarithm of the ratio of an ellipse's axes.
double rough_slenderness(double curvature_ratio) { return 0.62 * std::log(curvature_ratio); }

/// The width of the peak of K about the direction of motion, radians.
Wave peak_width(Arguments x) {
  const Wave X = squared_speed(x["speed"], 1), critical = rayleigh_squared(x["poisson"]);
  return X == 0 ? Wave(1) : std::min<Wave>(1, sqrt((critical - X) / X));
}

Wave die_force(Arguments x, bool coarse) {
  const SlidingShape along = shape_at(x, x["friction"], 0);
  const Wave steepness = along.Q / along.h;
  Wave sum = 0;
  for (const Direction& at : directions_between(panels(peak_width(x), 1), coarse)) {
    const SlidingShape line(line_at(x, at.cosine), x["friction"], at.cosine, at.sine);
    const Wave span = steepness * line.h / line.Q;
    sum += at.weight * span * span * span / line.h * line.moment();
  }
  return 2 * sum;
}

Wave rolling_force(Arguments x, bool coarse) {
  const Wave along = rolling_amplitude(x, 1);
  Wave sum = 0;
  for (const Direction& at : directions_between(panels(peak_width(x), 1), coarse)) {
    const Wave ratio = along / rolling_amplitude(x, at.cosine);
    sum += at.weight * ratio * ratio * rolling_moment(rolling_index(x, at.cosine));
  }
  return sum * along / 2;
}

ContactEllipse ellipse_at(Arguments x, bool coarse) {
  const double rough = rough_slenderness(x["curvature_ratio"]);
  // The first panel also resolves an ellipse that the peak of K makes longer.
  const Wave narrow = exp(-Wave(std::fabs(rough) * 1.2)) / 2, width = peak_width(x) / 2;
  const auto ends = panels(rough < 0 ? std::min<Wave>(narrow, width) : width,
                           rough > 0 ? std::min<Wave>(narrow, width) : Wave(width));
  std::vector<WeightedLine> lines;
  for (const auto& [cosine, sine, weight] : directions_between(ends, coarse)) {
    const Wave compliance = line_at(x, cosine).compliance, sine2 = 2 * sine * cosine;
    for (const int side : {1, -1})
      lines.push_back({2 * cosine * cosine - 1, side * sine2, weight, compliance});
  }
  return {lines, x["curvature_ratio"]};
}

Wave axis_ratio(Arguments x, bool coarse) { return exp(-ellipse_at(x, coarse).eta); }

Wave stiffness(Arguments x, bool coarse) {
  const auto [eta, first, third] = ellipse_at(x, coarse);
  return 8 * pi<Wave>() / 3 * sqrt(third / (first * first * first));
}

Confirm by_gauss_rule(Wave (*value)(Arguments, bool coarse)) {
  return [value](Arguments x) {
    const Wave fine = value(x, false);
    return confirmation<Wave>("Gauss's rule over the lines", fine,
                              abs(fine - value(x, true)) + abs(fine) * Wave("1e-70"));
  };
}

}  // namespace

const Methods& isotropic_methods() {
  static const Methods methods{
      {"halfspace.compliance", [](Arguments x) { return closed(line_at(x).compliance); }},
      {"halfspace.coupling", [](Arguments x) { return closed(line_at(x).coupling); }},
      {"halfspace.compliance_beyond", [](Arguments x) { return closed(line_at(x).compliance); }},
      {"halfspace.coupling_beyond", [](Arguments x) { return closed(line_at(x).coupling); }},
      {"halfspace.rolling_index_beyond",
       [](Arguments x) {
         const LineAnswerByFormula line = line_at(x);
         return closed(atanh(sqrt(line.compliance * line.in_line) / abs(line.coupling)) / pi<Wave>());
       }},
      {"halfspace.condition", [](Arguments x) { return closed(condition(x)); }},
      {"halfspace.rayleigh",
       [](Arguments x) {
         const Wave value = sqrt(rayleigh_squared(x["poisson"]));
         return confirmation<Wave>("root of Rayleigh's cubic", value, value * Wave("1e-80"));
       }},
      {"die.exponent", [](Arguments x) { return closed(-shape_at(x, x["friction"], x["psi_deg"]).ahead); }},
      {"die.peak_place",
       [](Arguments x) { return closed(shape_at(x, x["friction"], x["psi_deg"]).ahead - Wave(1) / 2); }},
      {"die.span_ratio",
       [](Arguments x) {
         const SlidingShape along = shape_at(x, x["friction"], 0), across = shape_at(x, x["friction"], 90);
         return closed(along.Q / across.Q * across.h / along.h);
       }},
      {"die.force", by_gauss_rule(die_force)},
      {"rolling.index", [](Arguments x) { return closed(rolling_index(x, cosine_of(x["psi_deg"]))); }},
      {"rolling.span_ratio",
       [](Arguments x) { return closed(rolling_amplitude(x, 1) / rolling_amplitude(x, 0)); }},
      {"rolling.finite_span_ratio",
       [](Arguments x) {
         const Wave value = finite_span_ratio(x);
         return confirmation<Wave>("Newton's method for the span", value, abs(value) * Wave("1e-60"));
       }},
      {"rolling.strip",
       [](Arguments x) {
         return closed(exp(-pi<Wave>() / (2 * rolling_index(x, cosine_of(x["psi_deg"])))));
       }},
      {"rolling.creep", [](Arguments x) { return closed(rolling_creep(x)); }},
      {"rolling.force", by_gauss_rule(rolling_force)},
      {"halfspace.in_line", [](Arguments x) { return closed(line_at(x).in_line); }},
      {"halfspace.across",
       [](Arguments x) { return closed(1 / sqrt(1 - squared_speed(x["speed"], cosine_of(x["psi_deg"])))); }},
      {"halfspace.separation",
       [](Arguments x) {
         const Wave rayleigh = sqrt(rayleigh_squared(x["poisson"]));
         return closed(acos(rayleigh / x["speed"]) * 180 / pi<Wave>());
       }},
      {"ellipse.axis_ratio", by_gauss_rule(axis_ratio)},
      {"ellipse.stiffness", by_gauss_rule(stiffness)}};
  return methods;
}

LineAnswerByFormula isotropic_answer(const Wave& poisson, const Wave& X) {
  const Wave k = squared_ratio(poisson), wS = sqrt(1 - X), wD = sqrt(1 - k * X);
  const Wave defect = (1 + k - k * X) / (1 + wS * wD), rayleigh = 4 - X - 4 * defect;
  return {wD / rayleigh, (2 * defect - 1) / rayleigh, 0, wS / rayleigh};
}

SlidingShape::SlidingShape(const LineAnswerByFormula& line, const Wave& friction, const Wave& cosine,
                           const Wave& sine) {
  const Wave shear = friction * (cosine * line.coupling - sine * line.coupling_across);
  ahead = atan2(line.compliance, shear) / pi<Wave>();
  behind = 1 - ahead;
  h = sqrt(line.compliance * line.compliance + shear * shear);
  Q = pow(behind, behind) * pow(ahead, ahead);
}

Wave SlidingShape::moment() const {
  const Wave& b = behind <= ahead ? behind : ahead;
  const Wave a = 1 - b, beta = a * b * pi<Wave>() / (2 * sin(pi<Wave>() * b));
  return 2 * small_moment(b) + beta * ((a + 1) / 3 - b);
}

ContactEllipse::ContactEllipse(const std::vector<WeightedLine>& lines, double curvature_ratio) {
  const Wave ratio = curvature_ratio, wanted = (1 - ratio) / (1 + ratio);
  const auto defect = [&](const Wave& p, const Wave& q) {
    eta = sqrt(p * p + q * q);
    const Wave turning = eta == 0 ? Wave(1) : Wave(sinh(eta) / eta), mean = cosh(eta);
    Wave cosine = 0, sine = 0;
    first = third = 0;
    for (const WeightedLine& line : lines) {
      const Wave square = mean + turning * (p * line.cosine2 + q * line.sine2);
      const Wave term = line.weight * line.compliance / sqrt(square), cubed = term / square;
      first += term;
      third += cubed;
      cosine += cubed * line.cosine2;
      sine += cubed * line.sine2;
    }
    return std::pair<Wave, Wave>{cosine / third - wanted, sine / third};
  };
  const Wave step("1e-40");
  Wave p = rough_slenderness(curvature_ratio), q = 0, length = 1;
  for (int k = 0; k < 60 && length > Wave("1e-60"); ++k) {
    const auto [c_p, s_p] = defect(p + step, q);
    const auto [c_q, s_q] = defect(p, q + step);
    const auto [c, s] = defect(p, q);
    const Wave a = (c_p - c) / step, b = (c_q - c) / step, d = (s_p - s) / step, e = (s_q - s) / step;
    const Wave determinant = a * e - b * d, dp = -(c * e - s * b) / determinant,
               dq = -(s * a - c * d) / determinant;
    length = sqrt(dp * dp + dq * dq);
    p += dp / std::max<Wave>(1, length);
    q += dq / std::max<Wave>(1, length);
  }
  defect(p, q);
}

}  // namespace nipref::verify::confirm
