#pragma once
#include <string>

#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// For people: numbers with units and error estimates, profiles as a table, the work in one line.
/// Instantiated for fast::Estimate and LongEstimate.
template <class Number>
std::string solution_text(const SceneSolution<Number>& solution);

/// What `solve` answers. The reference's numbers are text.
template <class Number>
Json solution_json(const SceneSolution<Number>& solution);

}  // namespace nipref::verify
