#pragma once
#include <nipref/verify/solve/internal/solved_contact.hpp>

namespace nipref::verify {

/// The measures of a solved nip that are too large for linear theory: the mean strain across the sheet in the middle of
/// the nip, indentation/half-thickness, and the slope of the roller's parabola at the farther end of the contact, Y/R.
/// Throws BadInput, naming the given load or length, if that strain is 1 or more: the rollers' faces would meet.
template <class Number>
std::vector<BeyondTheory> beyond_theory(const data::Scene& scene, const SolvedContact<Number>& contact);

/// Whether the scene is solved by line loads.
bool is_by_line_loads(const data::Scene& scene);

/// Computes all results that the scene wants, and the indentation of a nip, see beyond_theory. `accuracy` is the
/// requested one.
template <class Number>
SceneSolution<Number> collect_results(const data::Scene& scene, const SolvedContact<Number>& contact,
                                      long double accuracy);

/// Computes again, by a contact that was refined, the results that miss the accuracy. More terms may increase rounding
/// errors, so that a result is replaced only by a better one.
void collect_better(const data::Scene& scene, const SolvedContact<fast::Estimate>& contact,
                    SceneSolution<fast::Estimate>& solution);

}  // namespace nipref::verify
