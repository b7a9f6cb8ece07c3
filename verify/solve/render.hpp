#pragma once
#include <string>

#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// For people: numbers with units and error estimates, profiles as a table, the work in one line.
/// Instantiated for fast::Estimate and LongEstimate.
template <class Number>
std::string solution_text(const SceneSolution<Number>& solution);

/// {"title", "results": {name: number, or list of numbers for a profile}, "error_estimate": {the same keys},
/// "positions": of the profiles, if any is wanted, "work": {"kernel_evaluations": {"I1": ..., "I7": ...},
/// "terms", "unknowns", "systems"}, "error_work": the same, if there was any, "seconds"}. The reference's
/// numbers are strings; "proven": {the same keys} tells which of its errors are; where all are, they stand
/// under "error_bound" instead.
template <class Number>
Json solution_json(const SceneSolution<Number>& solution);

}  // namespace nipref::verify
