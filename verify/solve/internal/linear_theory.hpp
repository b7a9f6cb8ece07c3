#pragma once
#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include <nipref/verify/solve/internal/refuse_given.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>
#include <nipref/verify/solve/solve.hpp>

namespace nipref::verify {

/// The measures of a solved nip that are too large for linear theory: the mean strain across the sheet in the middle of
/// the nip, indentation/half-thickness, and the slope of the roller's parabola at the farther end of the contact, Y/R.
/// Throws BadInput, naming the given load or length, if that strain is 1 or more: the rollers' faces would meet.
template <class Number>
std::vector<BeyondTheory> beyond_theory(const data::Scene& scene, const SolvedContact<Number>& contact) {
  const auto of_nip = [&](const auto& problem) {
    const double indentation = value_of(contact.number(ResultId::indentation)),
                 half = problem.nip.half_thickness();
    if (!(indentation < half)) refuse_meeting_faces(scene, problem.given, indentation, half);
    const auto [first, last] = contact.profile_extent();
    const double farther = std::max(std::fabs(first), std::fabs(last));
    std::vector<BeyondTheory> found{
        {"compressive_strain", indentation / half, linear_theory_limit},
        {"roller_slope", farther / problem.nip.roller_radius, linear_theory_limit}};
    std::erase_if(found, [](const BeyondTheory& one) { return one.value <= one.limit; });
    return found;
  };
  if (const auto* nip = std::get_if<data::ElasticNipProblem>(&scene.system)) return of_nip(*nip);
  if (const auto* nip = std::get_if<data::ViscoelasticNipProblem>(&scene.system)) return of_nip(*nip);
  return {};
}

}  // namespace nipref::verify
