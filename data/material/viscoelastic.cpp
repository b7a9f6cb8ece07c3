#include <nipref/data/internal/common.hpp>
#include <nipref/data/material/viscoelastic.hpp>

namespace nipref::data {
namespace {

using Complex = std::complex<double>;

void check_term(const RelaxationTerm& term, const std::string& name) {
  if (!(std::isfinite(term.amplitude.real()) && std::isfinite(term.amplitude.imag())))
    throw NoMaterial(name + " amplitude", term.amplitude.real(), "must be finite");
  const bool is_viscous = term.rate == 0.0 && term.amplitude.real() > 0 && term.amplitude.imag() == 0;
  if (is_viscous) return;
  if (!(std::isfinite(term.rate.imag()) && std::isfinite(term.rate.real()) && term.rate.real() > 0))
    throw NoMaterial(name + " rate", term.rate.real(),
                     "must be finite, its real part > 0: what is gone must be forgotten; or 0, of a fluid");
  if (!(std::abs(term.amplitude) / std::abs(term.rate) <= greatest_magnitude))
    throw NoMaterial(name + " amplitude", term.amplitude.real(),
                     "must be at most 1e60 times its rate's size");
}

void check_conjugates(const MaterialFunction& function, const std::string& name) {
  for (const RelaxationTerm& term : function.terms) {
    const bool paired = std::ranges::any_of(function.terms, [&](const RelaxationTerm& other) {
      return other.rate == std::conj(term.rate) && other.amplitude == std::conj(term.amplitude);
    });
    if (!paired) throw NoMaterial(name + " rate", term.rate.imag(), "must come with its complex conjugate");
  }
}

void check_function(const MaterialFunction& function, const std::string& name) {
  const double at_once = function.instantaneous;
  const bool is_nothing = at_once == 0 && !function.terms.empty();
  if (!is_nothing && !(std::isfinite(at_once) && at_once > 0))
    throw NoMaterial(name + " instantaneous", at_once, "must be finite and > 0, or 0 where it creeps");
  // theta2 of a nearly incompressible material is far smaller than the inverse of a modulus.
  if (!is_nothing && !(at_once >= 1e-20 * least_magnitude && at_once <= greatest_magnitude))
    throw NoMaterial(name + " instantaneous", function.instantaneous, "must be from 1e-80 to 1e60");
  for (std::size_t i = 0; i < function.terms.size(); ++i) {
    check_term(function.terms[i], name);
    for (std::size_t j = 0; j < i; ++j) {
      if (function.terms[i].rate == function.terms[j].rate)
        throw NoMaterial(name + " rate", function.terms[i].rate.real(), "must not occur twice");
    }
  }
  check_conjugates(function, name);
  if (!function.is_fluid() && !(function.long_time() > 0))
    throw NoMaterial(name + " long-time compliance", function.long_time(), "must be > 0");
}

std::string gains_energy(double frequency) {
  return fmt::format("must be >= 0 at every frequency: this one gains energy at {:.3g} rad per unit of time",
                     frequency);
}

/// A transform and an estimate of its relative rounding error, which is large if the terms nearly cancel.
struct Transformed {
  Complex value;
  double rounding;

  Transformed(const MaterialFunction& function, Complex p) : value(function.transform(p)) {
    double size = function.instantaneous;
    for (const RelaxationTerm& term : function.terms) size += std::abs(term.amplitude / (p + term.rate));
    rounding = 1e-12 + 0x1p-50 * size / std::abs(value);
  }
};

/// Throws unless a cycle of this frequency loses energy: -Im 1/(2G) >= 0 and Im 6K >= 0 with 6K = 3/theta2 - 1/theta1.
/// Both hold up to rounding errors: the loss of a modulus that does not relax is 0.
void check_loss(const MaterialFunction& theta1, const MaterialFunction& theta2, double frequency) {
  const Complex p(0, frequency);
  const Transformed shear(theta1, p), plane(theta2, p);
  if (shear.value.imag() > shear.rounding * std::abs(shear.value)) {
    throw NoMaterial("material shear loss", -shear.value.imag(), gains_energy(frequency));
  }
  const Complex dilatation = 3.0 / plane.value - 1.0 / shear.value;
  if (dilatation.imag() <
      -(plane.rounding * std::abs(3.0 / plane.value) + shear.rounding * std::abs(1.0 / shear.value))) {
    throw NoMaterial("material dilatation loss", dilatation.imag(), gains_energy(frequency));
  }
}

/// Frequencies at one of which the loss is negative if it is negative anywhere: dense compared with the width of the
/// peak of a real rate, far beyond the lowest and the highest rate, and about the resonance of each complex rate in
/// steps of its width.
std::vector<double> telling_frequencies(const MaterialFunction& theta1, const MaterialFunction& theta2) {
  std::vector<double> frequencies;
  double least = HUGE_VAL, greatest = 0;
  for (const MaterialFunction* function : {&theta1, &theta2}) {
    for (const RelaxationTerm& term : function->terms) {
      // After the inverse of this rate, the flow is as large as the instantaneous deformation.
      const double rate = term.rate != 0.0              ? std::abs(term.rate)
                          : function->instantaneous > 0 ? term.amplitude.real() / function->instantaneous
                                                        : 1;
      least = std::min(least, rate);
      greatest = std::max(greatest, rate);
      const double resonance = std::fabs(term.rate.imag());
      for (double widths = 1e-2; resonance > 0 && widths < 1e4; widths *= 1.1) {
        const double off = widths * term.rate.real();
        frequencies.push_back(resonance + off);
        if (off < resonance) frequencies.push_back(resonance - off);
      }
    }
  }
  // Each step must change the frequency, and all frequencies must be doubles.
  const double first = std::max(least / 1e3, std::numeric_limits<double>::min());
  const double last = std::min(greatest * 1e3, std::numeric_limits<double>::max() / 2);
  for (double frequency = first; frequency <= last; frequency *= 1.02) frequencies.push_back(frequency);
  return frequencies;
}

/// Returns the polynomial without the zeros at its end.
std::vector<double> trimmed(std::vector<double> polynomial, const char* name) {
  for (const double c : polynomial) {
    if (!std::isfinite(c)) throw NoMaterial(name, c, "must have finite coefficients");
  }
  while (!polynomial.empty() && polynomial.back() == 0) polynomial.pop_back();
  if (polynomial.empty()) throw NoMaterial(name, "0", "must have a coefficient that is not 0");
  return polynomial;
}

Compliances compliances(double bulk, double shear) {
  check_magnitude("bulk", bulk);
  check_magnitude("shear", shear);
  return {1 / (2 * shear), 3 / (6 * bulk + 2 * shear)};
}

/// The solid with theta = at_once (delta(t) + e^(-rate t)/relaxation_time). The rate is 1/relaxation_time for theta1
/// and `theta2_rate_factor` times as large for theta2.
ViscoelasticMaterial relaxing(const Compliances& at_once, double relaxation_time, int theta2_rate_factor,
                              const MaterialConstants& constants) {
  // The relaxation time may be so short or so long that it no longer matters: it need not be a magnitude.
  if (!(std::isfinite(relaxation_time) && relaxation_time > 0))
    throw NoMaterial("relaxation_time", relaxation_time, "must be finite and > 0");
  const auto function = [&](double compliance, int rate_factor) -> MaterialFunction {
    const double amplitude = compliance / relaxation_time, rate = rate_factor / relaxation_time;
    if (!(std::isfinite(amplitude) && std::isfinite(rate)))
      throw NoMaterial("relaxation_time", relaxation_time,
                       "must be so long that what is divided by it stays within the range of doubles");
    return {compliance, {{amplitude, rate}}};
  };
  return {function(at_once.theta1, 1), function(at_once.theta2, theta2_rate_factor), constants};
}

MaterialFunction prony_function(const PronyList& list, const std::string& name) {
  if (list.amplitudes.empty())
    throw NoMaterial(name + "_amplitudes", "[]",
                     "must hold at least one: without it the material is elastic");
  if (list.rates.size() != list.amplitudes.size()) {
    throw NoMaterial(name + "_rates", std::to_string(list.rates.size()) + " of them",
                     "must be as many as amplitudes, " + std::to_string(list.amplitudes.size()));
  }
  MaterialFunction function{list.instantaneous, {}};
  for (std::size_t i = 0; i < list.rates.size(); ++i)
    function.terms.push_back({list.amplitudes[i], list.rates[i]});
  return function;
}

}  // namespace

Complex MaterialFunction::transform(Complex p) const {
  Complex sum = instantaneous;
  for (const RelaxationTerm& term : terms) sum += term.amplitude / (p + term.rate);
  return sum;
}

bool MaterialFunction::is_fluid() const {
  return std::ranges::any_of(terms, [](const RelaxationTerm& term) { return term.rate == 0.0; });
}

std::string NoMaterial::key() const {
  constexpr std::string_view prefix = "material ";
  const bool is_prefixed = argument().starts_with(prefix);
  return "material." + argument().substr(is_prefixed ? prefix.size() : 0);
}

void MaterialFunctions::check() const {
  check_function(theta1, "theta1");
  check_function(theta2, "theta2");
  for (const double frequency : telling_frequencies(theta1, theta2)) check_loss(theta1, theta2, frequency);
}

MaterialFunction MaterialFunctions::normal_compliance() const {
  MaterialFunction sum{theta1.instantaneous + theta2.instantaneous, theta1.terms};
  for (const RelaxationTerm& term : theta2.terms) {
    const auto same = std::ranges::find(sum.terms, term.rate, &RelaxationTerm::rate);
    if (same == sum.terms.end()) {
      sum.terms.push_back(term);
    } else {
      same->amplitude += term.amplitude;
    }
  }
  return sum;
}

ViscoelasticMaterial::ViscoelasticMaterial(MaterialFunction theta1, MaterialFunction theta2,
                                           MaterialConstants constants)
    : functions_({std::move(theta1), std::move(theta2)}), constants_(std::move(constants)) {
  functions_->check();
}

ViscoelasticMaterial::ViscoelasticMaterial(const StandardLinearSolid& s) : constants_(s) {
  check_magnitude("shear_1", s.shear_1);
  check_magnitude("shear_2", s.shear_2);
  check_magnitude("bulk_1", s.bulk_1);
  check_magnitude("bulk_2", s.bulk_2);
  check_magnitude("shear_viscosity", s.shear_viscosity);
  check_magnitude("bulk_viscosity", s.bulk_viscosity);
}

ViscoelasticMaterial::ViscoelasticMaterial(DifferentialOperators x)
    : constants_(DifferentialOperators{trimmed(std::move(x.p), "P"), trimmed(std::move(x.q), "Q"),
                                       trimmed(std::move(x.p_dilatation), "P_dilatation"),
                                       trimmed(std::move(x.q_dilatation), "Q_dilatation")}) {}

bool ViscoelasticMaterial::gives_way_at_once() const {
  if (functions_) return functions_->theta1.instantaneous > 0;
  const auto* operators = std::get_if<DifferentialOperators>(&constants_);
  return operators == nullptr || operators->p.size() >= operators->q.size();
}

ViscoelasticMaterial elastic_solid(const ElasticMaterial& material) {
  material.check();
  // An incompressible elastic solid is refused here: its theta2 is 0, which no viscoelastic material has.
  return {{material.theta1(), {}}, {material.theta2(), {}}, material};
}

ViscoelasticMaterial standard_linear_solid(const StandardLinearSolid& solid) {
  return ViscoelasticMaterial(solid);
}

ViscoelasticMaterial single_relaxation_time_solid(double bulk, double shear, double relaxation_time,
                                                  int theta2_rate_factor) {
  return relaxing(compliances(bulk, shear), relaxation_time, theta2_rate_factor,
                  SingleRelaxationTimeSolid{bulk, shear, relaxation_time, theta2_rate_factor});
}
ViscoelasticMaterial single_relaxation_time_solid(const Compliances& at_once, double relaxation_time,
                                                  int theta2_rate_factor) {
  return relaxing(at_once, relaxation_time, theta2_rate_factor, {});
}

ViscoelasticMaterial prony_solid(const PronyList& theta1, const PronyList& theta2) {
  return {prony_function(theta1, "theta1"), prony_function(theta2, "theta2")};
}

ViscoelasticMaterial operator_solid(const DifferentialOperators& operators) {
  return ViscoelasticMaterial(operators);
}

}  // namespace nipref::data
