#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <nipref/ref/number/internal/cache.hpp>
#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/sheet/internal/field_integral.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/internal/residues.hpp>

namespace nipref::ref {
namespace {

/// The N for which the truncation error is below about e^{-nats}.
long field_terms_needed(double alpha, double nats) {
  double terms = 1;
  for (int pass = 0; pass < 3; ++pass) {
    terms = (nats + std::log(static_cast<double>(field_series_remainder)) + 2 * std::log(terms + 1)) /
                (std::numbers::pi * alpha) -
            0.5;
    terms = std::max(terms, 1.0);
  }
  return static_cast<long>(std::ceil(terms));
}

/// The sum of factor 2 c e^{i alpha z} over the terms, with the residues c of ref/sheet/README.md, Inside the sheet.
ComplexInterval pole_term(const FieldIntegrand& integrand, const FieldPoint& at, const SheetPole& pole) {
  const mpfr_prec_t precision = pole.z.re.precision();
  const Interval alpha(at.alpha, precision), s(at.depth, precision);
  const Interval size = exp(-(alpha * pole.z.im)), angle = alpha * pole.z.re;
  const Interval a = s * pole.z.re, b = s * pole.z.im;
  const ComplexInterval grows{cosh(a) * cos(b), sinh(a) * sin(b)}, rises{sinh(a) * cos(b), cosh(a) * sin(b)};
  const ComplexInterval cubed = pole.sech * pole.sech * pole.sech;
  const ComplexInterval of_sinh = -(pole.z * cubed);
  ComplexInterval sum{Interval(precision), Interval(precision)};
  for (const FieldTerm& term : integrand.terms) {
    ComplexInterval next =
        (term.symbol == FieldSymbol::sinh_over_S ? of_sinh : pole.sech) * (term.sinh ? rises : grows);
    if (term.power > 0) next = next * pole.z;
    if (term.power < 0) next = next * inverse(pole.z);
    sum = sum + Interval(term.factor, precision) * next;
  }
  return ComplexInterval{size * cos(angle), size * sin(angle)} * sum;
}

/// The contribution of a term's pole at 0, which does not decay with alpha, over pi/4.
mpq_class at_origin(const FieldTerm& term, const FieldPoint& at) {
  const int order = term.power + (term.sinh ? 1 : 0) - (term.symbol == FieldSymbol::cosh_over_S ? 1 : 0);
  if (order == -1) return term.sinh ? mpq_class(term.factor * at.depth.value()) : term.factor;
  return order == -2 ? mpq_class(-term.factor * at.alpha.value()) : mpq_class(0);
}

}  // namespace

Interval field_by_residues(const FieldIntegrand& integrand, const FieldPoint& at, double nats) {
  const double alpha = at.alpha.approximate();
  const long terms = field_terms_needed(alpha, nats);
  Interval sum(mpfr_prec_t{64});
  for (long n = terms; n >= 1; --n) {
    const auto pole = sheet_pole(n, term_precision(n, alpha, nats));
    const ComplexInterval next = pole_term(integrand, at, *pole);
    sum = integrand.sine ? sum + next.re : sum - next.im;
  }
  mpq_class quarters = 0;
  for (const FieldTerm& term : integrand.terms) quarters += at_origin(term, at);
  Interval value = sum;
  if (quarters != 0) {
    const mpfr_prec_t precision = std::max(sum.precision(), working_precision(nats, alpha));
    value = Interval(mpq_class(quarters / 4), precision) + sum;
  }
  const long count = terms + 1;
  Interval tail =
      field_series_remainder *
      (count * (count * exp(-((2 * terms + 1) * (Interval::pi(64) * Interval(at.alpha, 64)) / 2))));
  if (integrand.odd_in_depth) tail = Interval(at.depth, 64) * tail;
  return value.widened(tail);
}

namespace {

/// The number of successive nodes whose waves the addition theorems give from one base.
constexpr long stride = 16;

/// -2z/(S cosh z) and -2z/(S sinh z).
struct FieldNode {
  Interval z, of_sinh, of_cosh;
};

/// Nodes z = (j + 1/2) step, j < nodes.size(), for which aliasing and truncation are below about e^{-nats} at any
/// depth. Only a few values of `nats` occur, so that many points share the nodes.
struct FieldNodes {
  double step;  ///< with few bits, so that multiples are exact
  mpfr_prec_t precision;
  std::vector<FieldNode> nodes;
};

/// The position of the last node.
double field_end(double depth, double nats) {
  double end = 8;
  for (int pass = 0; pass < 4; ++pass) {
    end = std::max(
        8.0, (nats + std::log(static_cast<double>(field_sum_remainder)) + 4 * std::log(end)) / (3 - depth));
  }
  return end;
}

/// The number of nodes, a multiple of `stride`.
long field_count(double end, double step) {
  return stride * static_cast<long>(std::ceil((end / step + 0.5) / stride));
}

FieldNodes make_field_nodes(const long& nats) {
  const auto wanted = static_cast<double>(nats);
  const double frequency = wanted + std::log(4 * field_line_integral) + field_line;
  FieldNodes made{
      of_few_bits(2 * std::numbers::pi * field_line / frequency, 4), working_precision(wanted, 1e4), {}};
  const long count = field_count(field_end(1, wanted), made.step);
  const Interval fall_in_step = exp(-Interval(made.step, made.precision));
  Interval e1(1L, made.precision);
  for (long j = 0; j < count; ++j) {
    const Interval z((static_cast<double>(j) + 0.5) * made.step, made.precision);
    e1 = j % stride == 0 ? exp(-z) : e1 * fall_in_step;
    const Interval e2 = square(e1), fall = 1 - e2;
    const Interval common = -(8 * z * (e1 * e2)) / (fall * (e2 + 1) + 4 * z * e2);
    made.nodes.push_back({z, common / (e2 + 1), common / fall});
  }
  return made;
}

std::size_t size_of_nodes(const FieldNodes& made) {
  return made.nodes.size() * 6 * static_cast<std::size_t>(made.precision) / CHAR_BIT;
}

/// Nodes for at least this many nats.
std::shared_ptr<const FieldNodes> field_nodes(double nats) {
  static Cache<long, FieldNodes> kept(make_field_nodes, size_of_nodes);
  const double grain = std::exp2(std::max(3.0, std::floor(std::log2(nats)) - 3));
  return kept.at(static_cast<long>(std::ceil(nats / grain) * grain));
}

/// cos, sin of alpha z and cosh, sinh of s z.
struct Waves {
  Interval cosine, sine, grows, rises;

  Waves(const Interval& angle, const Interval& hyperbolic)
      : cosine(cos(angle)), sine(sin(angle)), grows(cosh(hyperbolic)), rises(sinh(hyperbolic)) {}

  /// The functions at the sums of the arguments. Nothing cancels where the arguments are small.
  Waves(const Waves& a, const Waves& b)
      : cosine(a.cosine * b.cosine - a.sine * b.sine),
        sine(a.sine * b.cosine + a.cosine * b.sine),
        grows(a.grows * b.grows + a.rises * b.rises),
        rises(a.rises * b.grows + a.grows * b.rises) {}
};

bool has_twofold_pole(const FieldTerm& term) {
  return term.power < 0 && term.symbol == FieldSymbol::cosh_over_S && !term.sinh;
}

class Summation {
 public:
  Summation(const FieldIntegrand& integrand, const FieldPoint& at, const FieldNodes& nodes, long count)
      : integrand_(integrand),
        nodes_(nodes),
        count_(count),
        alpha_(at.alpha, nodes.precision),
        depth_(at.depth, nodes.precision) {
    for (const FieldTerm& term : integrand.terms) factors_.emplace_back(Exact(term.factor), nodes.precision);
  }

  /// step times the sum over all nodes.
  [[nodiscard]] Interval value() const {
    std::vector<Waves> offsets;
    for (long k = 0; k < stride; ++k) offsets.push_back(waves(static_cast<double>(k)));
    Interval sum(nodes_.precision);
    for (long base = 0; base < count_; base += stride) {
      const Waves start = waves(static_cast<double>(base) + 0.5);
      for (long k = 0; k < stride; ++k)
        sum = sum + integrand_at(nodes_.nodes[static_cast<std::size_t>(base + k)],
                                 Waves(start, offsets[static_cast<std::size_t>(k)]));
    }
    return Interval(nodes_.step, nodes_.precision) * sum;
  }

 private:
  [[nodiscard]] Waves waves(double steps) const {
    const Interval z(steps * nodes_.step, nodes_.precision);
    return {alpha_ * z, depth_ * z};
  }

  [[nodiscard]] Interval integrand_at(const FieldNode& node, const Waves& at) const {
    Interval sum(nodes_.precision);
    for (std::size_t i = 0; i < factors_.size(); ++i) {
      const FieldTerm& term = integrand_.terms[i];
      Interval wave = (term.sinh ? at.rises : at.grows) * (integrand_.sine ? at.sine : at.cosine);
      if (has_twofold_pole(term)) wave = wave - 1;
      Interval next =
          factors_[i] * (term.symbol == FieldSymbol::sinh_over_S ? node.of_sinh : node.of_cosh) * wave;
      if (term.power > 0) next = next * node.z;
      if (term.power < 0) next = next / node.z;
      sum = sum + next;
    }
    return sum;
  }

  const FieldIntegrand& integrand_;
  const FieldNodes& nodes_;
  long count_;
  Interval alpha_, depth_;
  std::vector<Interval> factors_;
};

/// The angle of (x, y) with x, y >= 0, not both 0.
Interval angle_of(const Interval& y, const Interval& x) {
  const bool steep = mpfr_cmp(x.upper(), y.upper()) < 0;
  return steep ? Interval::pi(y.precision()) / 2 - atan(x / y) : atan(y / x);
}

/// The integrals from 0 to infinity of 1/(z cosh z), 1/cosh z and z/cosh z, and of the same over sinh z, times sin wz
/// or cos wz, whichever makes the integrand even, at w = alpha + i depth. That of cos wz/(z sinh z) is a finite part.
struct ClosedForms {
  std::array<ComplexInterval, 3> over_cosh, over_sinh;
};

ClosedForms closed_forms(const FieldPoint& at, mpfr_prec_t precision) {
  const Interval pi = Interval::pi(precision), alpha(at.alpha, precision), depth(at.depth, precision);
  const Interval from_face(Exact(mpq_class(1 - at.depth.value())), precision);
  const Interval a = pi * alpha / 2;
  const Interval ca = cosh(a), sa = sinh(a), ss = sin(pi * depth / 2), cs = sin(pi * from_face / 2);
  const Interval size = square(ca * cs) + square(sa * ss);  // |cosh(pi w/2)|^2
  const ComplexInterval sech{ca * cs / size, -(sa * ss) / size}, tanh{sa * ca / size, ss * cs / size};
  const ComplexInterval ln_cosh{log(size) / 2, angle_of(sa * ss, ca * cs)};
  // cosh a - sin(pi depth/2) = 2 sinh^2(a/2) + 2 sin^2(pi from_face/4)
  const Interval below = 2 * (square(sinh(a / 2)) + square(sin(pi * from_face / 4)));
  const ComplexInterval gd{angle_of(sa, cs), log1p(2 * ss / below) / 2};  // gd(pi w/2)
  const Interval half_pi = pi / 2;
  return {{gd, half_pi * sech, square(half_pi) * (sech * tanh)},
          {-ln_cosh, half_pi * tanh, square(half_pi) * (sech * sech)}};
}

/// The integral of a term with the part 1/cosh z or 1/sinh z of its symbol.
Interval closed_term(const FieldTerm& term, bool sine, const ClosedForms& forms) {
  const auto& by_power = term.symbol == FieldSymbol::sinh_over_S ? forms.over_cosh : forms.over_sinh;
  const ComplexInterval& form = by_power[static_cast<std::size_t>(term.power + 1)];
  if (!term.sinh) return form.re;
  return sine ? -form.im : form.im;
}

/// The sum of the closed forms with an error of e^{-nats}. Near the loads they cancel, and the precision is raised
/// until the error is met.
Interval closed_part(const FieldIntegrand& integrand, const FieldPoint& at, mpfr_prec_t precision,
                     double nats) {
  constexpr mpfr_prec_t most_bits = 1 << 17;
  double log2_width = -nats / std::numbers::ln2;
  if (integrand.sine) log2_width += at.alpha.log2_magnitude();
  if (integrand.odd_in_depth) log2_width += at.depth.log2_magnitude();
  for (;; precision *= 2) {
    const ClosedForms closed = closed_forms(at, precision);
    Interval sum(precision);
    for (const FieldTerm& term : integrand.terms) {
      sum = sum + Interval(term.factor, precision) * closed_term(term, integrand.sine, closed);
    }
    Float width = zero_of_bits(64);
    mpfi_diam_abs(raw(width), sum.get());
    const bool narrow = mpfr_zero_p(raw(width)) || static_cast<double>(mpfr_get_exp(raw(width))) < log2_width;
    if (narrow || precision > most_bits) return sum;
  }
}

}  // namespace

Interval field_by_summation(const FieldIntegrand& integrand, const FieldPoint& at, double nats) {
  const double depth = at.depth.approximate();
  const auto nodes = field_nodes(nats);
  const long count =
      std::min(static_cast<long>(nodes->nodes.size()), field_count(field_end(depth, nats), nodes->step));
  Interval value = Summation(integrand, at, *nodes, count).value();
  value = value + closed_part(integrand, at, nodes->precision, nats);
  for (const FieldTerm& term : integrand.terms) {
    const Interval factor(Exact(term.factor), nodes->precision);
    if (has_twofold_pole(term)) value = value + factor * I6_eta_interval(Exact(0.0), nats);
  }
  const mpfr_prec_t precision = 64;
  const Interval rate =
      2 * Interval::pi(precision) * Interval(field_line, precision) / Interval(nodes->step, precision);
  const Interval aliasing = Interval(4 * field_line_integral, precision) *
                            exp(Interval(field_line, precision) * Interval(at.alpha, precision)) /
                            expm1(rate);
  const Interval end((static_cast<double>(count) - 0.5) * nodes->step, precision);
  const Interval truncation =
      field_sum_remainder * square(square(end)) * exp(-((3 - Interval(at.depth, precision)) * end));
  Interval error = aliasing + truncation;
  if (integrand.sine) error = error * Interval(at.alpha, precision);
  if (integrand.odd_in_depth) error = error * Interval(at.depth, precision);
  return value.widened(error) / Interval::pi(nodes->precision);
}

}  // namespace nipref::ref
