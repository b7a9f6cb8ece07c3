#include <boost/math/quadrature/gauss.hpp>

#include <nipref/verify/golden/confirm/kernels.hpp>
#include <nipref/verify/golden/confirm/rational.hpp>

namespace nipref::verify::confirm {
namespace {

enum class MovingModel { thesis = 1, prony, operators, two_moduli };

/// The Prony series of `function`, which is theta1 or theta2.
Exponentials terms_of(Arguments x, const std::string& function) {
  Exponentials sum{Long(x[function + "_instantaneous"]), {}};
  const auto amplitudes = x.list(function + "_amplitude"), rates = x.list(function + "_rate");
  for (std::size_t k = 0; k < amplitudes.size(); ++k)
    if (amplitudes[k] != 0) sum.terms.push_back({LongComplex(amplitudes[k]), LongComplex(rates[k])});
  return sum;
}

/// The material of the sheet under a moving load.
BothFunctions material_of(Arguments x) {
  const auto model = static_cast<MovingModel>(static_cast<int>(x["material"]));
  if (model == MovingModel::prony) return {terms_of(x, "theta1"), terms_of(x, "theta2")};
  const Long bulk = x["bulk"],
             shear = model == MovingModel::two_moduli ? Long(x["shear"]) : Long(3 * bulk / 8);
  const Compliance of = model == MovingModel::operators ? Compliance(operator_moduli(x))
                                                        : Compliance(bulk, shear, x["relaxation_time"],
                                                                     model == MovingModel::thesis ? 2 : 1);
  return BothFunctions(of);
}

Confirmation closed_form(const Long& value) {
  return confirmation("closed form", value, abs(value) * Long("1e-100"));
}

/// e^shift int_from^to e^(rate w) dw by its antiderivative.
LongComplex exponential(const LongComplex& rate, const Long& shift, const Long& from, const Long& to) {
  if (rate == LongComplex(0)) return exp(shift) * (to - from);
  return (exp(LongComplex(rate * to + shift)) - exp(LongComplex(rate * from + shift))) / rate;
}

/// J2 + i J1 as an integral over the distances w = T - tau ahead of the load.
LongComplex ahead(Arguments x) {
  const Long lambda = x["lambda"], a = x["a"], b = x["b"], t = x["t"], T = x["T"];
  if (T <= 0) return 0;
  return exponential(LongComplex(-lambda - a, b), lambda * (T - t), std::max<Long>(T - t, 0), T);
}

/// J4 - i J3 as an integral over the distances w = tau - T behind the load.
LongComplex behind(Arguments x) {
  const Long lambda = x["lambda"], a = x["a"], b = x["b"], t = x["t"], T = x["T"];
  if (t <= T) return 0;
  return exponential(LongComplex(lambda - a, b), -lambda * (t - T), std::max<Long>(-T, 0), t - T);
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

/// J5 and J6.
Confirmation of_sign(Arguments x) {
  const Float gamma0 = x["gamma0"], gamma = x["gamma"], lambda = x["lambda"], t = x["t"], T = x["T"];
  const Float passed = std::clamp<Float>(t - T, 0, t);  // the time since the load passed
  const Float behind = passed > 0 ? faded_by_gauss(lambda, 0, passed) : Float(0);
  const Float ahead = passed < t ? faded_by_gauss(lambda, passed, t) : Float(0);
  const Float at_once = T > t ? gamma0 : T < t ? Float(-gamma0) : Float(0);
  return confirmation("Gauss's rule", at_once + gamma * (ahead - behind),
                      (abs(gamma0) + abs(gamma) * (ahead + behind)) * Float("1e-90"));
}

/// The load's path relative to a point, in half-thicknesses: the present distance, and that at the start, if any.
struct LoadPath {
  mpq_class alpha;
  std::optional<mpq_class> start;
};

/// The convolution of theta with a kernel I along the load's path.
class Convolution {
 public:
  Convolution(Exponentials theta, double speed, double half_thickness) : theta_(std::move(theta)) {
    const Long way_per_time = Long(speed) / Long(half_thickness);
    for (auto& [amplitude, rate] : theta_.terms) {
      amplitude /= way_per_time;
      rate /= way_per_time;
    }
  }

  void add(Long& sum, Float& error, int sign, const SymbolTransform& kernel, const LoadPath& way) const {
    const auto part = [&](const LongComplex& amplitude, const Complex& fine, const Complex& coarse) {
      const LongComplex whole(Long(fine.real()), Long(fine.imag()));
      sum += sign * LongComplex(amplitude * whole).real();
      error += Float(abs(amplitude)) * Float(abs(Complex(fine - coarse)) + abs(fine) * Float("1e-65"));
    };
    if (!kernel.is_odd || sgn(way.alpha) != 0) {
      const Split now = kernel(way.alpha);
      const Float rest = kernel.is_odd ? Float(now.value() - sgn(way.alpha) * pi() / 4) : now.rest;
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

  /// Adds `share` times the convolution of theta with pi sign(w).
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

  Exponentials theta_;
};

struct Sheet {
  Convolution theta1, theta2;

  explicit Sheet(Arguments x) : Sheet(material_of(x), x["speed"], x["half_thickness"]) {}
  Sheet(const BothFunctions& solid, double speed, double half_thickness)
      : theta1(solid.theta1, speed, half_thickness), theta2(solid.theta2, speed, half_thickness) {}
};

Confirmation over_pi(const Long& sum, const Float& error) {
  return confirmation("direct convolution over the way", sum / pi<Long>(), Long(error / pi()));
}

Confirmation Un(const Sheet& sheet, const LoadPath& way) {
  Long sum = 0;
  Float error = 0;
  for (const Convolution* theta : {&sheet.theta1, &sheet.theta2}) theta->add(sum, error, 1, I1, way);
  return over_pi(sum, error);
}

Confirmation Vn(const Sheet& sheet, const LoadPath& alpha, const LoadPath& eta) {
  Long sum = 0;
  Float error = 0;
  for (const Convolution* theta : {&sheet.theta1, &sheet.theta2}) theta->add(sum, error, 1, I3, alpha);
  sheet.theta2.add_sign(sum, -1, mpq_class(1, 2), alpha);
  sheet.theta2.add(sum, error, 1, I4, eta);
  sheet.theta1.add(sum, error, -1, I5, eta);
  return over_pi(sum, error);
}

/// The load's path at the time t after its start, relative to the point that it passes at the time T.
LoadPath started(Arguments x, const char* T_name) {
  const mpq_class T(x[T_name]), way_per_time = mpq_class(x["speed"]) / mpq_class(x["half_thickness"]);
  return {(T - mpq_class(x["t"])) * way_per_time, mpq_class(T * way_per_time)};
}

LoadPath steady(double alpha) { return {alpha, std::nullopt}; }

}  // namespace

Methods memory_methods() {
  return {{"J1", [](Arguments x) { return closed_form(ahead(x).imag()); }},
          {"J2", [](Arguments x) { return closed_form(ahead(x).real()); }},
          {"J3", [](Arguments x) { return closed_form(-behind(x).imag()); }},
          {"J4", [](Arguments x) { return closed_form(behind(x).real()); }},
          {"J5", of_sign},
          {"J6", of_sign},
          {"Un", [](Arguments x) { return Un(Sheet(x), started(x, "T")); }},
          {"Vn", [](Arguments x) { return Vn(Sheet(x), started(x, "T"), started(x, "t0")); }},
          {"Un_steady", [](Arguments x) { return Un(Sheet(x), steady(x["alpha"])); }},
          {"Vn_steady", [](Arguments x) { return Vn(Sheet(x), steady(x["alpha"]), steady(x["eta"])); }}};
}

}  // namespace nipref::verify::confirm
