#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/elliptic.hpp>
#include <nipref/ref/half_space/internal/contact.hpp>
#include <nipref/ref/number/internal/complex.hpp>

namespace nipref::ref {
namespace {

/// All lines of half a turn from some of them, by polynomials in v, where the angle of a line is centre + width sinh(v), from the
/// peak of the compliance: its singularities about the peak are at v = +-i pi/2.
class SmoothLines {
 public:
  /// Y e3 and, if asked for, the rows of G, in the axes along a line, across it and into the half-space.
  using Line = std::vector<ComplexFloat>;

  /// Y e3 and G each have an error of about 10^-digits of their size, which is estimated: the polynomials are compared with
  /// the lines half-way between those from which they are made, and panels of v are halved until both agree. BadInput
  /// "surface" where they never do.
  SmoothLines(const WorkingSurface& surface, const PeakOfCompliance& peak, bool with_decay, int digits);

  [[nodiscard]] Float angle(const Float& v) const { return centre_ + width_ * sinh(v); }  ///< radians
  [[nodiscard]] Float slope(const Float& v) const { return width_ * cosh(v); }
  /// Of the line at this angle, or turned by half turns.
  [[nodiscard]] Float v(const Float& angle) const;
  [[nodiscard]] const Float& last() const { return last_; }  ///< v is from -last to last
  [[nodiscard]] Line at(const Float& v) const;

 private:
  /// The lines at count + 1 Chebyshev points up to `right`.
  struct Panel {
    Float right;
    std::vector<Float> places;
    std::vector<Line> lines;

    [[nodiscard]] Line at(const Float& v) const;
  };
  template <class Of>
  void add_panels(const Float& left, const Float& right, int digits, const Of& line);

  Float centre_, width_, last_;
  std::vector<Panel> panels_;
};

/// The pressure peak sqrt(1 - (x/a)^2 - (y/b)^2), x along the major axis, whose angle from the motion is in radians.
struct EllipticPressure {
  Float a, b, major, peak;
};

/// A place at the distance x from the centre, in the direction psi, in radians, below the surface if the depth is not 0.
struct PlaceInside {
  Float psi, x, depth;
};

/// Along the motion, across it and into the half-space.
struct Displaced {
  std::array<Float, 3> value, error;
};

/// Along the motion, across it and into the half-space, or along a line, across it and into the half-space.
using Moved = std::array<Float, 3>;
using ComplexVector = std::array<ComplexFloat, 3>;
using ComplexRows = std::array<ComplexVector, 3>;

ComplexVector product(const ComplexRows& matrix, const ComplexVector& x, const ComplexFloat& shift) {
  ComplexVector result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = -(shift * x[i]);
    for (std::size_t k = 0; k < 3; ++k) result[i] = result[i] + matrix[i][k] * x[k];
  }
  return result;
}

/// The eigenvalues by Cardano's formula, which must not all be equal.
ComplexVector eigenvalues(const ComplexRows& g) {
  const ComplexFloat third = (g[0][0] + g[1][1] + g[2][2]) / Float(3);
  ComplexRows h = g;  // its trace is 0: x^3 + 3 p x - 2 q = 0
  for (std::size_t i = 0; i < 3; ++i) h[i][i] = g[i][i] - third;
  const auto minor = [&](std::size_t i, std::size_t k) { return h[i][i] * h[k][k] - h[i][k] * h[k][i]; };
  const ComplexFloat p = (minor(0, 1) + minor(1, 2) + minor(0, 2)) / Float(3);
  const ComplexFloat q = (h[0][0] * minor(1, 2) - h[0][1] * (h[1][0] * h[2][2] - h[1][2] * h[2][0]) +
                          h[0][2] * (h[1][0] * h[2][1] - h[1][1] * h[2][0])) /
                         Float(2);
  const ComplexFloat root = exp(log(q * q + p * p * p) * Float(0.5));
  const ComplexFloat cube = abs(q + root) > abs(q - root) ? q + root : q - root;
  const ComplexFloat third_of_turn(Float(-0.5), sqrt(Float(3)) / 2);
  ComplexFloat one = exp(log(cube) / Float(3));
  ComplexVector result;
  for (ComplexFloat& value : result) {
    value = third + one - p / one;
    one = one * third_of_turn;
  }
  return result;
}

/// int_-1^1 (1 - s^2)/(s - z) ds for Im z > 0, and its limit where z is real.
ComplexFloat parabola_over(const ComplexFloat& z) {
  const ComplexFloat one(Float(1)), rest = one - z * z;
  if (abs(rest) == Float(0)) return z * Float(-2);
  if (abs(z) < Float(100)) return rest * log((z - one) / (z + one)) - z * Float(2);
  // In powers of 1/z, as the terms above cancel by 4 digits from here on.
  ComplexFloat sum, power = one / z;
  const ComplexFloat factor = power * power;
  for (long k = 1; k == 1 || abs(power) > std::numeric_limits<Float>::epsilon() * abs(sum);
       k += 2, power = power * factor)
    sum = sum - power * Float(4) / Float(k * (k + 2));
  return sum;
}

/// Y e3 = the sum of these parts, each of which falls like e^(-exponent kappa depth).
struct FallingPart {
  ComplexFloat exponent;
  ComplexVector pushed;
};

/// By Lagrange's interpolation between the eigenvalues of G. They differ by 10^-digits at least, as G is changed by about
/// its error; it is divided by two such differences, so that what cancels has four times the digits.
std::vector<FallingPart> parts_of(const SmoothLines::Line& line) {
  const ComplexVector at_surface{line[0], line[1], line[2]};
  if (line.size() == at_surface.size()) return {{{}, at_surface}};
  const int digits = static_cast<int>(Float::thread_default_precision());
  const WorkingDigits scope(4 * digits);
  ComplexRows g;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) g[i][k] = line[3 * (i + 1) + k];
    g[i][i] = g[i][i] * (1 + static_cast<long>(i * i + 1) * tolerance(digits));
  }
  const ComplexVector values = eigenvalues(g);
  std::vector<FallingPart> parts;
  for (std::size_t i = 0; i < 3; ++i) {
    const ComplexFloat &own = values[i], &second = values[(i + 1) % 3], &third = values[(i + 2) % 3];
    ComplexVector pushed = product(g, product(g, at_surface, second), third);
    for (ComplexFloat& each : pushed) each = each / ((own - second) * (own - third));
    parts.push_back({own, pushed});
  }
  // From here on only what cancels between the parts is lost.
  const auto size = [](const ComplexVector& x) { return std::max({abs(x[0]), abs(x[1]), abs(x[2])}); };
  Float largest = size(at_surface);
  for (const FallingPart& part : parts) largest = std::max(largest, size(part.pushed));
  const Float cancelled = log10(Float(largest / size(at_surface)));
  const WorkingDigits enough(digits + 1 + static_cast<int>(cancelled));
  for (FallingPart& part : parts) {
    for (ComplexFloat* each : {&part.exponent, &part.pushed[0], &part.pushed[1], &part.pushed[2]})
      *each = {at_working_precision(each->re), at_working_precision(each->im)};
  }
  return parts;
}

/// Im(P(t + i G depth)/pi Y e3), P = parabola_over.
Moved moved_by(const std::vector<FallingPart>& parts, const Float& t, const Float& depth) {
  const WorkingDigits scope(digits_of(bits_of(parts[0].pushed[0].re)));
  Moved result;
  for (const auto& [exponent, pushed] : parts) {
    const ComplexFloat factor = parabola_over({t - depth * exponent.im, depth * exponent.re}) / pi();
    for (std::size_t k = 0; k < 3; ++k) result[k] += (factor * pushed[k]).im;
  }
  return result;
}

/// An integral over a stretch of the lines and its change by the last halving of the rule's step.
struct Stretch {
  Float left, right;
  Moved integral{}, change{};
  bool is_settled = false;
};

Float largest_of(const Moved& x) { return std::max({Float(abs(x[0])), Float(abs(x[1])), Float(abs(x[2]))}); }

void add(Moved& sum, const Moved& term, const Float& factor) {
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += factor * term[k];
}

/// They end across the place, along the minor axis, at the peak of the compliance, where lines touch the ellipse, and where
/// they come nearest to that if the place is within it.
std::vector<Stretch> stretches_of(const SmoothLines& lines, const EllipticPressure& on,
                                  const PlaceInside& place) {
  const auto& [psi, x, depth] = place;
  const Float right = pi() / 2;
  // In the plane in which the ellipse is the unit circle.
  const Float first = x * cos(Float(psi - on.major)) / on.a, second = x * sin(Float(psi - on.major)) / on.b;
  const Float angle = atan2(second, first), distance = hypot(first, second);
  const Float off = distance > Float(1) ? acos(Float(1 / distance)) : Float(0);
  const auto touching = [&](const Float& at) {
    return lines.v(on.major + atan2(Float(sin(at) / on.b), Float(cos(at) / on.a)));
  };
  std::vector<Float> ends{
      -lines.last(),         lines.last(),         0, lines.v(psi + right), lines.v(on.major + right),
      touching(angle - off), touching(angle + off)};
  std::ranges::sort(ends);
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    if (ends[i + 1] - ends[i] > std::numeric_limits<Float>::epsilon())
      stretches.push_back({ends[i], ends[i + 1]});
  return stretches;
}

/// What a line adds under a pressure, per dv.
Moved moved_by_line(const SmoothLines& lines, const Float& v, const std::vector<FallingPart>& parts,
                    const EllipticPressure& on, const PlaceInside& place) {
  const auto& [psi, x, depth] = place;
  const Float angle = lines.angle(v), c = cos(angle), s = sin(angle);
  const Float width =
      hypot(Float(on.a * cos(Float(angle - on.major))), Float(on.b * sin(Float(angle - on.major))));
  const Float share = lines.slope(v) * on.peak * on.a * on.b / (4 * width);
  const auto [along, across, into] = moved_by(parts, x * cos(Float(angle - psi)) / width, depth / width);
  return {share * (c * along - s * across), share * (s * along + c * across), share * into};
}

Float size_of(std::span<const ComplexFloat> numbers) {
  Float largest;
  for (const ComplexFloat& each : numbers) largest = std::max(largest, abs(each));
  return largest;
}

bool agree(const SmoothLines::Line& found, const SmoothLines::Line& truth, int digits) {
  SmoothLines::Line off;
  for (std::size_t i = 0; i < truth.size(); ++i) off.push_back(found[i] - truth[i]);
  const auto is_small = [&](auto part) {
    return size_of(part(std::span(off))) <= tolerance(digits) * size_of(part(std::span(truth)));
  };
  return is_small([](auto all) { return all.first(3); }) && is_small([](auto all) { return all.subspan(3); });
}

SmoothLines::SmoothLines(const WorkingSurface& surface, const PeakOfCompliance& peak, bool with_decay,
                         int digits)
    : centre_(peak.degrees * pi() / 180), width_(peak.width), last_(asinh(Float(pi() / 2 / width_))) {
  const auto line = [&](const Float& v) {
    const Exact off = to_exact(Float(width_ * sinh(v) * 180 / pi()));
    const LineAnswer y = surface.at(Exact(mpq_class(Exact(peak.degrees).value() + off.value())));
    Line found{
        {y.shear_compliance, y.coupling}, {y.shear_compliance_across, y.coupling_across}, y.compliance};
    if (!with_decay) return found;
    const Decay& decay = y.decay.value();
    for (std::size_t k = 0; k < 9; ++k) found.emplace_back(decay.re[k], decay.im[k]);
    return found;
  };
  const auto panels = static_cast<long>(ceil(Float(2 * last_)));
  for (long i = 0; i < panels; ++i)
    add_panels((Float(2 * i) / panels - 1) * last_, (Float(2 * i + 2) / panels - 1) * last_, digits, line);
}

template <class Of>
void SmoothLines::add_panels(const Float& left, const Float& right, int digits, const Of& line) {
  // On a panel of length 1 the polynomial converges like (pi + sqrt(pi^2 + 1))^-count = 10^(-0.81 count). The lines between
  // its own are compared in every fifth gap, the first and the last included.
  constexpr int gaps = 5;
  const int count = gaps * static_cast<int>((digits + 4) / (0.75 * gaps)) + 1;
  const Float middle = (left + right) / 2, half = (right - left) / 2;
  if (half < Float(1e-4))
    throw data::BadInput("surface", "(as given)", "must be smooth from line to line, to all its digits");
  const auto place = [&](int twice) -> Float { return middle - half * cos(pi() * twice / (2 * count)); };
  Panel panel{right, {}, {}};
  for (int k = 0; k <= count; ++k) {
    panel.places.push_back(place(2 * k));
    panel.lines.push_back(line(panel.places.back()));
  }
  for (int k = 0; k < count; k += gaps) {
    const Float between = place(2 * k + 1);
    if (agree(panel.at(between), line(between), digits)) continue;
    add_panels(left, middle, digits, line);
    return add_panels(middle, right, digits, line);
  }
  panels_.push_back(std::move(panel));
}

/// By the barycentric formula, whose weights at Chebyshev's points are 1 by turns of sign, and half at the ends.
SmoothLines::Line SmoothLines::Panel::at(const Float& v) const {
  Line sum(lines[0].size());
  Float total, scratch;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Float off = v - places[k];
    if (off == Float(0)) return lines[k];
    const bool is_end = k == 0 || k + 1 == places.size();
    const Float weight = (k % 2 == 0 ? 1 : -1) / (is_end ? Float(2 * off) : off);
    total += weight;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      add_product(sum[i].re, scratch, weight, lines[k][i].re);
      add_product(sum[i].im, scratch, weight, lines[k][i].im);
    }
  }
  for (ComplexFloat& each : sum) each = each / total;
  return sum;
}

Float SmoothLines::v(const Float& angle) const {
  const Float off = angle - centre_;
  return asinh(Float((off - pi() * round(Float(off / pi()))) / width_));
}

SmoothLines::Line SmoothLines::at(const Float& v) const {
  const auto panel = std::ranges::find_if(panels_, [&](const Panel& each) { return v <= each.right; });
  return (panel == panels_.end() ? panels_.back() : *panel).at(v);
}

/// The displacement under the first of two nearly equal pressures. By the double exponential rule between the lines where
/// the integrand has its peaks or no derivative; the error is the sum of the differences between the last two levels of
/// the rule and that between both pressures. Derivation: ref/half_space/README.md, Displacements.
Displaced displacement_under(const std::array<EllipticPressure, 2>& pressures, const SmoothLines& lines,
                             const PlaceInside& place, const std::vector<UnitPoint>& nodes, int digits) {
  Displaced result{};
  const auto add_line = [&](Moved& sum, const Float& v, const Float& dv, bool is_first_level) {
    const std::vector<FallingPart> parts = parts_of(lines.at(v));
    const Moved term = moved_by_line(lines, v, parts, pressures[0], place);
    add(sum, term, dv);
    if (!is_first_level) return;
    add(result.error, term, dv);
    add(result.error, moved_by_line(lines, v, parts, pressures[1], place), -dv);
  };
  // The steps are 32, 16, ... 1 of those between these nodes. The nodes left out are so near the ends of 7 stretches that all of
  // them together are less than a rounding, 10^-(digits + 6).
  constexpr std::size_t widest = 32;
  const auto halve_step = [&](Stretch& on, std::size_t step) {
    const bool is_first = step == widest;
    const Float length = on.right - on.left;
    Moved added;
    for (std::size_t i = is_first ? 0 : step; i < nodes.size(); i += is_first ? step : 2 * step) {
      const auto& [left, right, weight] = nodes[i];
      if (weight < tolerance(digits + 8)) continue;
      add_line(added, left < right ? Float(on.left + length * left) : Float(on.right - length * right),
               length * weight * step, is_first);
    }
    for (std::size_t k = 0; k < added.size(); ++k) {
      const Float finer = on.integral[k] / 2 + added[k];
      on.change[k] = abs(finer - on.integral[k]);
      on.integral[k] = finer;
    }
  };
  std::vector<Stretch> stretches = stretches_of(lines, pressures[0], place);
  for (std::size_t step = widest; step > 0; step /= 2) {
    Float all;
    for (Stretch& each : stretches) {
      if (!each.is_settled) halve_step(each, step);
      all += largest_of(each.integral);
    }
    for (Stretch& each : stretches)
      each.is_settled = step < widest && largest_of(each.change) <= tolerance(digits + 2) * all;
  }
  for (Float& apart : result.error) apart = abs(apart);
  for (const Stretch& each : stretches) {
    add(result.value, each.integral, 1);
    add(result.error, each.change, 1);
  }
  return result;
}

using Lines = std::vector<DirectionValue>;

/// An ellipse with a/b = exp(eta) and its major axis at the angle alpha from the motion, by (p, q) = eta (cos 2 alpha,
/// sin 2 alpha). In these variables the equations are nearly linear for however slender an ellipse.
struct Ellipse {
  Float p = 0, q = 0;

  [[nodiscard]] Float eta() const { return hypot(p, q); }
  [[nodiscard]] Float alpha() const { return atan2(q, p) / 2; }
};

/// The square of the half-width along a line over a b, which is e^eta C^2 + e^-eta S^2 with C and S the cosine and
/// sine of the angle from the major axis.
class SquaredWidth {
 public:
  explicit SquaredWidth(const Ellipse& ellipse)
      : wide_(exp(ellipse.eta())),
        narrow_(1 / wide_),
        cosine_(cos(ellipse.alpha())),
        sine_(sin(ellipse.alpha())) {}

  [[nodiscard]] Float at(const CrowdedDirections::Direction& line) const {
    const Float c = line.cosine * cosine_ + line.sine * sine_, s = line.sine * cosine_ - line.cosine * sine_;
    return wide_ * c * c + narrow_ * s * s;
  }

 private:
  Float wide_, narrow_, cosine_, sine_;
};

/// What is 0 if m = int K n n/w^3 dpsi is proportional to the curvatures: ln(m11/m22) less the logarithm of their ratio, and
/// m12 over the mean of the others. By the trapezoidal sums.
struct Mismatch {
  Float ratio, turn;

  Mismatch(const Lines& lines, const Float& curvature_ratio, const Ellipse& ellipse) {
    const SquaredWidth squared_width(ellipse);
    Float m11, m12, m22;
    for (const auto& [at, compliance] : lines) {
      const Float width = squared_width.at(at), term = at.weight * compliance / (width * sqrt(width));
      m11 += term * at.cosine * at.cosine;
      m12 += term * at.cosine * at.sine;
      m22 += term * at.sine * at.sine;
    }
    ratio = log(m11 / m22 * curvature_ratio);
    turn = m12 / sqrt(m11 * m22);
  }
};

/// The ellipse without mismatch, by Newton's method with differences over so little that each step about doubles the digits;
/// nothing if it does not converge.
std::optional<Ellipse> solve_ellipse(const Lines& lines, const Float& curvature_ratio, Ellipse ellipse) {
  const Float little = sqrt(std::numeric_limits<Float>::epsilon());
  for (int step = 0; step < 60; ++step) {
    const auto at = [&](const Float& p, const Float& q) -> Mismatch {
      return {lines, curvature_ratio, {ellipse.p + p, ellipse.q + q}};
    };
    const Mismatch here = at(0, 0), beside = at(little, 0), above = at(0, little);
    const Float j11 = (beside.ratio - here.ratio) / little, j12 = (above.ratio - here.ratio) / little,
                j21 = (beside.turn - here.turn) / little, j22 = (above.turn - here.turn) / little;
    const Float determinant = j11 * j22 - j12 * j21;
    const Float dp = (here.turn * j12 - here.ratio * j22) / determinant,
                dq = (here.ratio * j21 - here.turn * j11) / determinant;
    const Float length = hypot(dp, dq);
    if (mpfr_number_p(raw(length)) == 0) return std::nullopt;
    const Float part = 1 / std::max(Float(1), length);
    ellipse.p += part * dp;
    ellipse.q += part * dq;
    if (length < little * Float(1e-3)) return ellipse;
  }
  return std::nullopt;
}

constexpr double slenderest = 1e-12;

/// The first approximation: Hertz's axis ratio to within a few per cent, with axes along and across the motion.
Ellipse first_ellipse(const Float& curvature_ratio) { return {Float(0.62) * log(curvature_ratio), 0}; }

/// Directions for that ellipse, with a margin: a peak of the compliance makes it longer, by up to the inverse of the
/// peak's width.
CrowdedDirections directions_for(const SurfaceAnswer& surface, double curvature_ratio) {
  const auto [degrees, width] = peak_of_compliance(surface);
  const double slenderness = std::exp(-0.7 * std::fabs(std::log(curvature_ratio)));
  const bool is_along = curvature_ratio >= 1;  // then the singularities are at |tan| = 1/slenderness
  const double smallest = is_along ? width : std::min(width, slenderness);
  return {Exact(degrees), smallest, 1 / (is_along ? std::min(width, slenderness) : width)};
}

/// The solution on one set of lines: the ellipse whose half-axes have the product 1, and its integrals.
struct Level {
  Ellipse ellipse;
  Float first;   ///< int K/w dpsi
  Float third;   ///< int K/w^3 dpsi
  Float moment;  ///< int K cos^2/w^3 dpsi

  Level(const Ellipse& found, const Lines& lines) : ellipse(found) {
    const SquaredWidth squared_width(found);
    for (const auto& [at, compliance] : lines) {
      const Float square = squared_width.at(at);
      const Float term = at.weight * compliance / sqrt(square);
      first += term;
      third += term / square;
      moment += term / square * at.cosine * at.cosine;
    }
    for (Float* sum : {&first, &third, &moment}) *sum /= static_cast<long>(lines.size());
  }
  [[nodiscard]] Float axis_ratio() const { return exp(-ellipse.eta()); }
  [[nodiscard]] Float stiffness() const { return 8 * pi() / 3 * sqrt(third) / pow(first, Float(1.5)); }
  /// The distance from the centre to the edge.
  [[nodiscard]] Float radius(const Exact& degrees) const {
    const Float psi = to_float(degrees) * pi() / 180, c = cos(psi), s = sin(psi);
    // The half-width of the ellipse turned by 90 degrees is 1 over the radius of this one.
    return 1 / sqrt(SquaredWidth({-ellipse.p, -ellipse.q}).at({degrees, c, s, 1}));
  }
};

/// The solutions with two numbers of directions.
struct TwoLevels {
  Level coarse, fine;
};

/// Doubles the number of lines until ellipse and integrals have converged. The curvature ratio has been checked, and
/// `lines` has the working digits.
TwoLevels solve_levels(const SurfaceAnswer& surface, const WorkingSurface& lines,
                       const Exact& curvature_ratio, int digits) {
  const Float curvatures = to_float(curvature_ratio);
  Ellipse ellipse = first_ellipse(curvatures);
  std::optional<Level> coarse, fine;
  const auto agree = [&](const auto& value) {
    return abs(value(*fine) - value(*coarse)) <= tolerance(digits) * abs(value(*fine)) / 10;
  };
  double_directions(
      digits, directions_for(surface, curvature_ratio.approximate()),
      [&](const Exact& degrees) { return lines.at(degrees).compliance; },
      [&](const Lines& compliance) {
        const std::optional<Ellipse> found = solve_ellipse(compliance, curvatures, ellipse);
        if (!found) return false;
        ellipse = *found;
        coarse = fine;
        fine = Level(ellipse, compliance);
        return coarse && agree([](const Level& level) { return level.axis_ratio(); }) &&
               agree([](const Level& level) { return level.first; }) &&
               agree([](const Level& level) { return level.third; }) &&
               agree([](const Level& level) { return level.moment; }) &&
               agree([](const Level& level) { return level.radius(Exact(0.0)); }) &&
               agree([](const Level& level) { return level.radius(Exact(90.0)); });
      });
  return {*coarse, *fine};
}

void check_ratio(const Exact& curvature_ratio) {
  const double ratio = curvature_ratio.approximate();
  if (!(ratio >= slenderest && ratio <= 1 / slenderest))
    throw data::BadInput("curvature_ratio", curvature_ratio.text(), "must lie between 1e-12 and 1e12");
}

Estimate of_ellipse(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits,
                    Float (Level::*value)() const) {
  check_ratio(curvature_ratio);
  const int working = working_digits(digits);
  const WorkingDigits scope(working);
  const auto [coarse, fine] =
      solve_levels(surface, WorkingSurface(surface, working), curvature_ratio, digits);
  return estimated((fine.*value)(), abs((fine.*value)() - (coarse.*value)()), digits);
}

}  // namespace

Estimate elliptic_axis_ratio(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits) {
  return of_ellipse(surface, curvature_ratio, digits, &Level::axis_ratio);
}

Estimate elliptic_stiffness(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits) {
  return of_ellipse(surface, curvature_ratio, digits, &Level::stiffness);
}

// On the ellipse multiplied by s, a pressure p0 sqrt(1 - ...) causes the displacement
// (p0 s^2/4) int K (1 - (n.x)^2/w^2)/w. With the curvature C along the motion it follows that p0 = 2 s C/moment,
// F = (2 pi/3) p0 s^2 and approach = p0 s first/4.
struct EllipticContact::Implementation {
  HalfSpaceLoad load;
  Float curvature;  ///< along the motion
  int digits, working;
  TwoLevels levels;

  template <class Function>
  [[nodiscard]] Estimate of(const Function& function) const {
    const WorkingDigits scope(working);
    return of_levels(function(levels.fine), function(levels.coarse), digits);
  }
  /// p0/s = 2 C/moment.
  [[nodiscard]] Float pressure_over_scale(const Level& level) const { return 2 * curvature / level.moment; }
  /// Force over the cube of the span along the motion.
  [[nodiscard]] Float factor(const Level& level) const {
    const Float span = 2 * level.radius(Exact(0.0));
    return 2 * pi() / 3 * pressure_over_scale(level) / (span * span * span);
  }
  /// The factor s between the level's ellipse and that of the contact.
  [[nodiscard]] Float scale(const Level& level) const {
    return span_along_of(load, factor(level)) / (2 * level.radius(Exact(0.0)));
  }
};

EllipticContact::EllipticContact(SurfaceAnswer surface, const Indenter& body, const HalfSpaceLoad& load,
                                 int digits) {
  const Exact ratio(mpq_class(body.across.value() / body.along.value()));
  check_ratio(ratio);
  const int working = working_digits(digits);
  const WorkingDigits scope(working);
  implementation_ = std::make_shared<const Implementation>(
      Implementation{load, to_float(body.along), digits, working,
                     solve_levels(surface, WorkingSurface(surface, working), ratio, digits)});
}

Estimate EllipticContact::axis_ratio() const {
  return implementation_->of([](const Level& level) { return level.axis_ratio(); });
}

Estimate EllipticContact::orientation() const {
  const WorkingDigits scope(implementation_->working);
  const auto& [coarse, fine] = implementation_->levels;
  const auto degrees = [](const Ellipse& ellipse) { return Float(180 * ellipse.alpha() / pi()); };
  const Float change = hypot(fine.ellipse.p - coarse.ellipse.p, fine.ellipse.q - coarse.ellipse.q);
  // The error of twice the angle, in radians; if it is not small, any angle is possible.
  const Float turn = (change + tolerance(implementation_->digits + 6)) / fine.ellipse.eta();
  const Float error = turn < Float(0.25) ? Float(90 * turn) : Float(90);
  return {degrees(fine.ellipse), error, implementation_->digits};
}

Estimate EllipticContact::span(const Exact& degrees) const {
  return implementation_->of(
      [&](const Level& level) -> Float { return 2 * implementation_->scale(level) * level.radius(degrees); });
}

Estimate EllipticContact::span_ratio(const Exact& degrees) const {
  return implementation_->of(
      [&](const Level& level) -> Float { return level.radius(degrees) / level.radius(Exact(0.0)); });
}

Estimate EllipticContact::approach() const {
  return implementation_->of([&](const Level& level) -> Float {
    const Float scale = implementation_->scale(level);
    return scale * scale * implementation_->curvature * level.first / (2 * level.moment);
  });
}

Estimate EllipticContact::force() const {
  return implementation_->of(
      [&](const Level& level) { return force_of(implementation_->load, implementation_->factor(level)); });
}

Estimate EllipticContact::peak_pressure() const { return pressure(Exact(0.0), Exact(0.0)); }

Estimate EllipticContact::pressure(const Exact& degrees, const Exact& x) const {
  const WorkingDigits scope(implementation_->working);
  const Float there = to_float(x);
  return with_shifted_ends(implementation_->digits, [&](const Float& change) {
    return implementation_->of([&](const Level& level) -> Float {
      const Float scale = implementation_->scale(level), end = scale * level.radius(degrees);
      const Float ahead = end * (1 + change) - there, behind = end * (1 + change) + there;
      if (!(ahead > Float(0) && behind > Float(0))) return 0;
      return scale * implementation_->pressure_over_scale(level) * sqrt(ahead * behind) / end;
    });
  });
}

EllipticContact::Displacement EllipticContact::displacement(const SurfaceAnswer& half_space,
                                                            const Exact& depth) const {
  if (depth.sign() < 0) throw data::BadInput("depth", depth.text(), "must not be negative");
  const WorkingDigits scope(implementation_->working);
  const WorkingSurface surface(half_space, implementation_->working);
  const PeakOfCompliance peak = peak_of_compliance(half_space);
  const auto lines =
      std::make_shared<const SmoothLines>(surface, peak, depth.sign() > 0, implementation_->digits + 7);
  const Float largest = surface.at(Exact(peak.degrees)).compliance;
  const auto nodes = std::make_shared<const std::vector<UnitPoint>>(unit_nodes(8 * implementation_->working));
  return [contact = implementation_, lines, nodes, largest, depth](const Exact& degrees, const Exact& x) {
    const WorkingDigits working(contact->working);
    const auto pressed = [&](const Level& level) -> EllipticPressure {
      const Float scale = contact->scale(level), root = exp(Float(level.ellipse.eta() / 2));
      return {scale * root, scale / root, level.ellipse.alpha(),
              scale * 2 * contact->curvature / level.moment};
    };
    const EllipticPressure fine = pressed(contact->levels.fine), coarse = pressed(contact->levels.coarse);
    const Float psi = to_float(degrees) * pi() / 180;
    const Displaced found = displacement_under({fine, coarse}, *lines, {psi, to_float(x), to_float(depth)},
                                               *nodes, contact->digits);
    // The rounding, what is left out as it is narrower than a rounding of the angle, and a tenth as much by the polynomials:
    // of the size of all lines together.
    const Float rounding = tolerance(contact->digits + 6) * fine.peak * fine.a * largest;
    const auto estimate = [&](std::size_t i) -> Estimate {
      return {found.value[i], found.error[i] + rounding, contact->digits};
    };
    return std::array{estimate(0), estimate(1), estimate(2)};
  };
}

}  // namespace nipref::ref
