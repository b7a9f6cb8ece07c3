#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <string>
#include <vector>

#include <nipref/verify/golden/confirm/history.hpp>
#include <nipref/verify/golden/confirm/rational.hpp>

namespace nipref::verify::confirm {
namespace {

using SolidFunction = Exponentials<700>;

struct SolidTerms {
  SolidFunction theta1, theta2;
};

enum class MovingModel { thesis = 1, prony, operators, two_moduli };

SolidFunction relaxing(const Long& at_once, const Long& rate, int rate_factor) {
  return {at_once, {{LongComplex(at_once * rate), LongComplex(rate * rate_factor)}}};
}

/// function: theta1 or theta2.
SolidFunction terms_of(Arguments x, const std::string& function) {
  SolidFunction sum{Long(x[function + "_instantaneous"]), {}};
  const auto amplitudes = x.list(function + "_amplitude"), rates = x.list(function + "_rate");
  for (std::size_t k = 0; k < amplitudes.size(); ++k) {
    if (amplitudes[k] != 0) sum.terms.push_back({LongComplex(amplitudes[k]), LongComplex(rates[k])});
  }
  return sum;
}

/// The material of a moving load. Roots of the operators by the method of Durand and Kerner.
SolidTerms solid_terms(Arguments x) {
  const auto model = static_cast<MovingModel>(static_cast<int>(x["material"]));
  if (model == MovingModel::prony) return {terms_of(x, "theta1"), terms_of(x, "theta2")};
  if (model == MovingModel::operators) {
    const auto of = [&](const std::string& name) {
      const auto coefficients = x.list(name + "_0");
      Polynomial<Long> polynomial(coefficients.begin(), coefficients.end());
      polynomial.normalize();
      return polynomial;
    };
    const Polynomial<Long> p = of("P"), q = of("Q"), p_bulk = of("P_dilatation"), q_bulk = of("Q_dilatation");
    const SolidFunction theta1 = in_exponentials<700>({p, Long(2) * q});
    // A common factor of p and p_bulk would be a double root of their product.
    if (p == p_bulk) return {theta1, in_exponentials<700>({Long(3) * p, Long(6) * q_bulk + Long(2) * q})};
    return {theta1,
            in_exponentials<700>({Long(3) * p * p_bulk, Long(6) * q_bulk * p + Long(2) * q * p_bulk})};
  }
  const Long bulk = x["bulk"], rate = 1 / Long(x["relaxation_time"]);
  const Long shear = model == MovingModel::two_moduli ? Long(x["shear"]) : Long(3 * bulk / 8);
  return {relaxing(1 / (2 * shear), rate, 1),
          relaxing(3 / (6 * bulk + 2 * shear), rate, model == MovingModel::thesis ? 2 : 1)};
}

using Closed = Number<250>;
using ClosedComplex = ComplexNumber<250>;

Confirmation closed_form(const Closed& value) {
  return confirmation<Closed>("closed form", value, abs(value) * Closed("1e-100"));
}

/// e^shift int_from^to e^(rate w) dw by its antiderivative.
ClosedComplex exponential(const ClosedComplex& rate, const Closed& shift, const Closed& from,
                          const Closed& to) {
  if (rate == ClosedComplex(0)) return exp(shift) * (to - from);
  return (exp(ClosedComplex(rate * to + shift)) - exp(ClosedComplex(rate * from + shift))) / rate;
}

/// J2 + i J1 as an integral over the distances w = T - tau ahead of the load.
ClosedComplex ahead(Arguments x) {
  const Closed lambda = x["lambda"], a = x["a"], b = x["b"], t = x["t"], T = x["T"];
  if (T <= 0) return 0;
  return exponential(ClosedComplex(-lambda - a, b), lambda * (T - t), std::max<Closed>(T - t, 0), T);
}

/// J4 - i J3 as an integral over the distances w = tau - T behind the load.
ClosedComplex behind(Arguments x) {
  const Closed lambda = x["lambda"], a = x["a"], b = x["b"], t = x["t"], T = x["T"];
  if (t <= T) return 0;
  return exponential(ClosedComplex(lambda - a, b), -lambda * (t - T), std::max<Closed>(-T, 0), t - T);
}

/// int_from^to e^(-lambda v) dv by Gauss's rule on panels, until the integrand is negligible.
Float faded_by_gauss(const Float& lambda, const Float& from, const Float& to) {
  Float sum = 0, at = from;
  while (at < to && lambda * (at - from) < 300) {
    const Float end = lambda > 0 ? std::min<Float>(to, at + 8 / lambda) : to;
    sum += boost::math::quadrature::gauss<Float, 60>::integrate(
        [&](const Float& v) -> Float { return exp(-lambda * v); }, at, end);
    at = end;
  }
  return sum;
}

/// J5, J6.
Confirmation of_sign(Arguments x) {
  const Float gamma0 = x["gamma0"], gamma = x["gamma"], lambda = x["lambda"], t = x["t"], T = x["T"];
  const Float passed = std::clamp<Float>(t - T, 0, t);  // the time since the load passed
  const Float behind = passed > 0 ? faded_by_gauss(lambda, 0, passed) : Float(0);
  const Float ahead = passed < t ? faded_by_gauss(lambda, passed, t) : Float(0);
  const Float at_once = T > t ? gamma0 : T < t ? Float(-gamma0) : Float(0);
  return confirmation<Float>("Gauss's rule", at_once + gamma * (ahead - behind),
                             (abs(gamma0) + abs(gamma) * (ahead + behind)) * Float("1e-90"));
}

/// The load's path relative to a point, in half-thicknesses: the present distance, and the distance at the start.
struct LoadPath {
  mpq_class alpha;
  std::optional<mpq_class> start;
};

/// The convolution theta * I.
class Convolution {
 public:
  Convolution(SolidFunction theta, double speed, double half_thickness) : theta_(std::move(theta)) {
    const Long way_per_time = Long(speed) / Long(half_thickness);
    for (auto& [amplitude, rate] : theta_.terms) {
      amplitude /= way_per_time;
      rate /= way_per_time;
    }
  }

  void add(Long& sum, Float& error, int sign, const Remembered& kernel, const LoadPath& way) const {
    const auto part = [&](const LongComplex& amplitude, const Complex& fine, const Complex& coarse) {
      const LongComplex whole(Long(fine.real()), Long(fine.imag()));
      sum += sign * LongComplex(amplitude * whole).real();
      error += Float(abs(amplitude)) * Float(abs(Complex(fine - coarse)) + abs(fine) * Float("1e-65"));
    };
    if (!kernel.is_odd || sgn(way.alpha) != 0) {
      const Split now = kernel.at(way.alpha);
      const Float rest = kernel.is_odd ? Float(now.value() - sgn(way.alpha) * pi<Float>() / 4) : now.rest;
      const Float exact_rest = now.quarters != 0 ? now.rest : rest;
      part(LongComplex(theta_.instantaneous), exact_rest, exact_rest);
    }
    for (const auto& [amplitude, rate] : theta_.terms) {
      if (is_at_rest(way)) continue;
      const Complex short_rate(Float(rate.real()), Float(rate.imag()));
      part(amplitude, history(kernel, way.alpha, way.start, short_rate, false),
           history(kernel, way.alpha, way.start, short_rate, true));
    }
    if (kernel.is_odd) add_sign(sum, sign, mpq_class(1, 4), way);
  }

  /// Adds `share` times the convolution of theta with pi sign.
  void add_sign(Long& sum, int sign, const mpq_class& share, const LoadPath& way) const {
    Long total = theta_.instantaneous * sgn(way.alpha);
    for (const auto& [amplitude, rate] : theta_.terms) {
      if (!is_at_rest(way))
        total += LongComplex(amplitude * history_of_sign(way.alpha, way.start, rate)).real();
    }
    sum += sign * total * to_number<Long>(share) * pi<Long>();
  }

 private:
  static bool is_at_rest(const LoadPath& way) { return way.start && *way.start == way.alpha; }

  SolidFunction theta_;
};

/// The sheet's two convolutions.
struct Sheet {
  SolidTerms solid;
  Convolution theta1, theta2;

  explicit Sheet(Arguments x)
      : solid(solid_terms(x)),
        theta1(solid.theta1, x["speed"], x["half_thickness"]),
        theta2(solid.theta2, x["speed"], x["half_thickness"]) {}
};

Confirmation over_pi(const Long& sum, const Float& error) {
  return confirmation<Long>("direct convolution over the way", sum / pi<Long>(), Long(error / pi<Float>()));
}

Confirmation Un(const Sheet& sheet, const LoadPath& way) {
  Long sum = 0;
  Float error = 0;
  for (const Convolution* theta : {&sheet.theta1, &sheet.theta2})
    theta->add(sum, error, 1, remembered_I1, way);
  return over_pi(sum, error);
}

Confirmation Vn(const Sheet& sheet, const LoadPath& alpha, const LoadPath& eta) {
  Long sum = 0;
  Float error = 0;
  for (const Convolution* theta : {&sheet.theta1, &sheet.theta2})
    theta->add(sum, error, 1, remembered_I3, alpha);
  sheet.theta2.add_sign(sum, -1, mpq_class(1, 2), alpha);
  sheet.theta2.add(sum, error, 1, remembered_I4, eta);
  sheet.theta1.add(sum, error, -1, remembered_I5, eta);
  return over_pi(sum, error);
}

/// At the time t after the start, of the point that the load passes at the time T.
LoadPath started(Arguments x, const char* T_name) {
  const mpq_class T(x[T_name]), way_per_time = mpq_class(x["speed"]) / mpq_class(x["half_thickness"]);
  return {(T - mpq_class(x["t"])) * way_per_time, mpq_class(T * way_per_time)};
}

LoadPath steady(double alpha) { return {alpha, std::nullopt}; }

}  // namespace

const Methods& memory_methods() {
  static const Methods methods{
      {"J1", [](Arguments x) { return closed_form(ahead(x).imag()); }},
      {"J2", [](Arguments x) { return closed_form(ahead(x).real()); }},
      {"J3", [](Arguments x) { return closed_form(-behind(x).imag()); }},
      {"J4", [](Arguments x) { return closed_form(behind(x).real()); }},
      {"J5", of_sign},
      {"J6", of_sign},
      {"Un", [](Arguments x) { return Un(Sheet(x), started(x, "T")); }},
      {"Vn", [](Arguments x) { return Vn(Sheet(x), started(x, "T"), started(x, "t0")); }},
      {"Un_steady", [](Arguments x) { return Un(Sheet(x), steady(x["alpha"])); }},
      {"Vn_steady", [](Arguments x) { return Vn(Sheet(x), steady(x["alpha"]), steady(x["eta"])); }}};
  return methods;
}

}  // namespace nipref::verify::confirm
