#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/material/internal/material_compliances.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_loads.hpp>
#include <nipref/ref/viscoelastic_nip/line_loads.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

constexpr int most_elements = 100;
constexpr double farthest = 500;  ///< of the start, half-thicknesses

constexpr ExtraDigits extra_digits{24, 100};

RollingLoads checked(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                     int digits) {
  nip.check();
  if (digits < 16 || digits > 30)
    throw BadInput("digits", std::to_string(digits), "must be from 16 to 30 with line loads that roll");
  const int trailing = method.trailing_elements.value_or(method.leading_elements);
  for (const auto& [name, elements, least] : {std::tuple("leading_elements", method.leading_elements, 1),
                                              std::tuple("trailing_elements", trailing, 0)}) {
    if (elements < least || elements > most_elements)
      throw BadInput(name, std::to_string(elements),
                     "must be from " + std::to_string(least) + " to " + std::to_string(most_elements) +
                         " in the reference");
  }
  if (!(method.approach_lengths > 0 && method.approach_lengths <= farthest))
    throw BadInput("approach_lengths", method.approach_lengths,
                   "must be > 0 and at most 500 in the reference");
  if (method.residue_terms < 0 || method.residue_terms > 500)
    throw BadInput("residue_terms", std::to_string(method.residue_terms), "must be from 0 to 500");
  if (method.smallest_term != 0)
    throw BadInput("smallest_term", method.smallest_term, "must be 0 in the reference");
  (void)material_compliances(nip.material);  // which refuses what is no material
  const ExactMaterial material = exact_material(nip.material);
  if (method.residue_terms > 0 &&
      std::ranges::any_of(material.normal().terms, [](const auto& term) { return term.rate == 0; }))
    throw BadInput("residue_terms", std::to_string(method.residue_terms),
                   "must be 0: the material is a fluid, and the thesis's sums divide by its rate, 0");
  constexpr mpfr_prec_t bits = 512;  // of rates that are roots, so that what they miss is below all else
  const NearMaterial near = with_given_rates(material, bits);
  return {nip,
          MovingLoad(near.material, Exact(nip.speed), Exact(nip.half_thickness()), method.residue_terms),
          near.memory_error,
          method.leading_elements,
          trailing,
          mpq_class(method.approach_lengths),
          digits};
}

LengthSearch search_of(const RollingLoads& problem, double load) {
  const Float leading_length = sqrt(Float(load) * Float(problem.nip.roller_radius) * problem.instantaneous());
  return {Exact(load), leading_length / (2 * problem.leading * to_float(Exact(problem.half_thickness()))),
          to_float(Exact(problem.half_element(mpq_class(problem.nip.roller_radius))))};
}

}  // namespace

LineLoadNip line_loads_for_length(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                                  double contact_length, int digits) {
  RollingLoads problem = checked(nip, method, digits);
  if (!(contact_length > 0 && contact_length <= nip.roller_radius))
    throw BadInput("contact_length", contact_length, "must be > 0 and at most the roller's radius");
  auto solution = solved_to(digits, extra_digits, [&](int influence_digits) {
    problem.digits = influence_digits;
    return solve_loads(problem, {problem.half_element(mpq_class(contact_length)), 0});
  });
  if (solution) return *std::move(solution);
  throw BadInput("contact_length", contact_length,
                 "must be one whose system is farther from singular than the reference can tell");
}

LineLoadNip line_loads_for_load(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                                double load, int digits) {
  constexpr int digits_of_search = 16 - extra_digits.first;  // the influences', that is, are 16 at first
  RollingLoads problem = checked(nip, method, digits);
  if (!(std::isfinite(load) && load > 0)) throw BadInput("load", load, "must be finite and > 0");
  LengthSearch search = search_of(problem, load);
  const auto contact_of = [&](const Lengths& lengths) {
    return solve_loads(problem, {to_exact(lengths.length).value(),
                                 to_exact(Float(lengths.length * lengths.spread)).value()});
  };
  const auto carrying_to = [&](int least_digits) {
    return [&, least_digits](int influence_digits) {
      problem.digits = influence_digits;
      return search.contact_carrying(std::max(least_digits, 0) + (influence_digits - least_digits) / 2,
                                     contact_of);
    };
  };
  // Whether the loads press is known, and they do not.
  const auto pulls = [&] {
    std::optional<bool> presses;
    solved_until(digits_of_search, extra_digits, carrying_to(digits_of_search),
                 [&](const SolvedLineLoads& contact) {
                   presses = contact.presses_everywhere();
                   return presses.has_value();
                 });
    return presses == false;
  };
  while (!method.trailing_elements && problem.trailing > 0 && pulls()) --problem.trailing;
  if (auto solution = solved_to(digits, extra_digits, carrying_to(digits))) return *std::move(solution);
  throw BadInput("load", load, "must be one whose contact length can be proven");
}

}  // namespace nipref::ref
