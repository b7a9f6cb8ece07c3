#include <cmath>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/internal/proven_elastic.hpp>
#include <nipref/ref/nip/internal/converged_parts.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>

namespace nipref::ref {
namespace {

/// In sheet thicknesses.
double longest_proven(data::Friction friction) { return friction == data::Friction::full ? 4 : 80; }

/// theta2/N
Exact beta_of(const data::ElasticMaterial& material) {
  return Exact(ThetaShares(Exact(material.poisson)).theta2);
}

NipTask task_of(const data::ElasticNip& nip, int digits) {
  nip.check();
  const NipTask task{nip.roller_radius, nip.sheet_thickness, "an elastic contact", 100, 1e-8, digits};
  task.check_digits();
  return task;
}

ConvergedNip::Parts parts_of(const data::ElasticNip& nip, data::Friction friction, int digits) {
  const mpq_class compliance = normal_compliance(Exact(nip.material.young), Exact(nip.material.poisson));
  const WorkingDigits working(SolvedNip::working_digits(digits, 0));
  return {NipUnits(nip.roller_radius, nip.sheet_thickness, compliance),
          std::make_shared<ElasticSheet>(friction == data::Friction::full, to_float(beta_of(nip.material))),
          digits};
}

}  // namespace

int proven_terms(const data::ElasticNip& nip, data::Friction friction, double contact_length, int digits,
                 int most_terms) {
  const double half_length = task_of(nip, digits).half_length(contact_length).approximate();
  if (half_length > longest_proven(friction)) return 0;
  const int terms = friction == data::Friction::full
                        ? proven_gripped_terms(half_length, beta_of(nip.material).approximate(), digits)
                        : proven_elastic_terms(half_length, digits);
  return terms <= most_terms ? terms : 0;
}

int elastic_unknowns(const data::ElasticNip& nip, data::Friction friction, double contact_length,
                     int digits) {
  const Exact half_length = task_of(nip, digits).half_length(contact_length);
  const WorkingDigits working(SolvedNip::working_digits(digits, 0));
  return SolvedNip::first_unknowns(*parts_of(nip, friction, digits).sheet, to_float(half_length), digits);
}

ConvergedNip converged_for_length(const data::ElasticNip& nip, data::Friction friction, double contact_length,
                                  int digits, int most_terms) {
  const Exact half_length = task_of(nip, digits).half_length(contact_length);
  ConvergedNip::Parts parts = parts_of(nip, friction, digits);
  parts.half_length = half_length;
  if (proven_terms(nip, friction, contact_length, digits, most_terms) > 0) {
    parts.proof = parts.sheet->sticks()
                      ? proven_gripped(half_length, beta_of(nip.material), digits, {})
                      : proven_elastic(half_length, beta_of(nip.material), digits, I1_interval, most_terms);
  }
  return ConvergedNip(std::move(parts));
}

ConvergedNip converged_for_load(const data::ElasticNip& nip, data::Friction friction, double load, int digits,
                                int most_terms) {
  const NipTask task = task_of(nip, digits);
  if (!(std::isfinite(load) && load > 0)) throw data::BadInput("load", load, "must be finite and > 0");
  ConvergedNip::Parts parts = parts_of(nip, friction, digits);
  const Exact wanted(mpq_class(load) / parts.units.force);
  const double guess = guessed_half_length(wanted.approximate(), [](double) { return 1; });
  const auto is_allowed = [&](double half_length) {
    return half_length <= longest_proven(friction) && task.allows(half_length * nip.sheet_thickness);
  };
  // The guess is good to a tenth or so.
  if (is_allowed(0.8 * guess) && is_allowed(1.25 * guess)) {
    parts.proof = parts.sheet->sticks()
                      ? proven_gripped_for_load(wanted, guess, is_allowed, beta_of(nip.material), digits, {},
                                                most_terms)
                      : proven_elastic_for_load(wanted, guess, is_allowed, beta_of(nip.material), digits,
                                                I1_interval, most_terms);
  }
  if (!parts.proof) {
    const WorkingDigits working(parts.working_digits());
    parts.solved = task.solved_for_load(parts.sheet, load, to_float(wanted), guess);
  }
  return ConvergedNip(std::move(parts));
}

}  // namespace nipref::ref
