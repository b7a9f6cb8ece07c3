#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/ref/material/exact_material.hpp>
#include <nipref/ref/material/internal/polynomial.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {
namespace {

/// The function with the exact values of the doubles. BadInput unless all rates are real.
ExactFunction as_given(const data::MaterialFunction& function, const char* name) {
  ExactFunction result{function.instantaneous, {}, {}};
  for (const data::RelaxationTerm& term : function.terms) {
    if (term.rate.imag() != 0)
      throw data::BadInput(std::string(name) + " rate", term.rate.imag(),
                           "must be real on the reference path");
    result.terms.push_back({term.amplitude.real(), term.rate.real()});
  }
  return result;
}

mpq_class at_zero(const Polynomial& p) { return p.is_zero() ? mpq_class(0) : p[0]; }

ExactFunction exact_function(ExactRatio theta, const std::string& last) {
  cancel(theta.numerator, theta.denominator);
  const auto& [above, below] = theta;
  const Polynomial at_once = above / below, later = above % below;
  if (at_once.size() > 1 || (at_once.is_zero() && later.size() + 1 < below.size()))
    throw data::NoMaterial(last, "(its degree)",
                           "must give way at once by a finite compliance or by a dashpot");
  if (has_repeated_root(below))
    throw data::NoMaterial(last, "(its roots)",
                           "must not be repeated: t e^(-rate t) is not among the terms of a material");
  ExactFunction result{at_zero(at_once), {}, {}};
  // later/below = flow/p + numerator/denominator; only a fluid has the first term, whose rate is 0.
  const bool is_fluid = below[0] == 0;
  const Polynomial denominator = is_fluid ? below >> 1 : below;
  const mpq_class flow = is_fluid ? at_zero(later) / denominator[0] : mpq_class(0);
  const Polynomial rest = later - flow * denominator;
  const Polynomial numerator = is_fluid && !rest.is_zero() ? rest >> 1 : rest;
  if (is_fluid) result.terms.push_back({flow, 0});
  if (numerator.is_zero()) return result;
  if (!(slowest_rate(denominator) > 0))
    throw data::NoMaterial(last, "(its roots)", "must have negative real parts: strains fade");
  if (denominator.size() == 2) {
    result.terms.push_back({numerator[0] / denominator[1], denominator[0] / denominator[1]});
    return result;
  }
  result.fractions.push_back({numerator, denominator});
  return result;
}

/// The exact material from the constants of each material model.
struct FromConstants {
  const data::ViscoelasticMaterial& material;

  ExactMaterial operator()(std::monostate) const {
    const auto& [theta1, theta2] = *material.functions();
    return {as_given(theta1, "theta1"), as_given(theta2, "theta2")};
  }
  ExactMaterial operator()(const data::ElasticMaterial& solid) const {
    const mpq_class young = solid.young, poisson = solid.poisson;
    return {{(1 + poisson) / young, {}, {}}, {(1 + poisson) * (1 - 2 * poisson) / young, {}, {}}};
  }
  ExactMaterial operator()(const data::SingleRelaxationTimeSolid& solid) const {
    return exact_material(exact_single_time(Exact(solid.bulk), Exact(solid.shear),
                                            Exact(solid.relaxation_time), solid.theta2_rate_factor));
  }
  ExactMaterial operator()(const data::StandardLinearSolid& s) const {
    const auto modulus = [](double first, double second, double viscosity, const char* name) {
      return exact_modulus(data::SpringModel::standard_linear, Exact(first), Exact(second), Exact(viscosity),
                           name);
    };
    return exact_material(exact_moduli(modulus(s.shear_1, s.shear_2, s.shear_viscosity, "shear"),
                                       modulus(s.bulk_1, s.bulk_2, s.bulk_viscosity, "bulk")));
  }
  ExactMaterial operator()(const data::DifferentialOperators& operators) const {
    const auto ratio = [](const std::vector<double>& above, const std::vector<double>& below) -> ExactRatio {
      return {{above.begin(), above.end()}, {below.begin(), below.end()}};
    };
    return exact_material(
        exact_moduli(ratio(operators.q, operators.p), ratio(operators.q_dilatation, operators.p_dilatation)));
  }
};

ExactFunction given_part(ExactFunction function) {
  function.fractions.clear();
  return function;
}

/// The middle of the interval of a real number. Raises `error` to at least the relative error of the middle.
mpq_class middle_and_error(const ComplexInterval& number, mpq_class& error) {
  Float middle = zero_of_bits(number.re.precision());
  mpfi_mid(raw(middle), number.re.get());
  const ComplexInterval off{number.re - interval_of(middle), number.im};
  const Exact share = to_exact(upper_end(abs(off) / magnitude_of(interval_of(middle))));
  error = std::max(error, share.value());
  return to_exact(middle).value();
}

}  // namespace

ExactFunction ExactMaterial::normal() const {
  ExactFunction sum{theta1.instantaneous + theta2.instantaneous, theta1.terms, theta1.fractions};
  sum.fractions.insert(sum.fractions.end(), theta2.fractions.begin(), theta2.fractions.end());
  for (const ExactFunction::Term& term : theta2.terms) {
    const auto same =
        std::ranges::find_if(sum.terms, [&](const ExactFunction::Term& x) { return x.rate == term.rate; });
    if (same == sum.terms.end()) {
      sum.terms.push_back(term);
    } else {
      same->amplitude += term.amplitude;
    }
  }
  return sum;
}

ExactMaterial exact_material(const ExactRationalSolid& solid) {
  return {exact_function(solid.theta1, "Q"), exact_function(solid.theta2, "Q_dilatation")};
}

ExactMaterial exact_material(const data::ViscoelasticMaterial& material) {
  return std::visit(FromConstants{material}, material.constants());
}

NearMaterial with_given_rates(const ExactMaterial& material, mpfr_prec_t bits) {
  NearMaterial result{{given_part(material.theta1), given_part(material.theta2)}, 0};
  for (const auto& [from, to] : {std::pair(&material.theta1, &result.material.theta1),
                                 std::pair(&material.theta2, &result.material.theta2)}) {
    for (const ExactRatio& fraction : from->fractions) {
      for (const OscillatingTerm& term : partial_fractions(fraction.numerator, fraction.denominator, bits)) {
        if (mpfi_has_zero(term.rate.im.get()) == 0)
          throw data::BadInput("material rate", mpfi_get_d(term.rate.im.get()),
                               "must be real on the reference path");
        to->terms.push_back({middle_and_error(term.amplitude, result.memory_error),
                             middle_and_error(term.rate, result.memory_error)});
      }
    }
  }
  return result;
}

ExactMaterial exact_solid(Solid solid, const Exact& bulk, const Exact& tau) {
  const Exact shear(mpq_class(data::thesis_shear_over_bulk * bulk.value()));
  return exact_material(
      exact_single_time(bulk, shear, tau, solid == Solid::thesis ? data::misprinted_rate_factor : 1));
}

}  // namespace nipref::ref
