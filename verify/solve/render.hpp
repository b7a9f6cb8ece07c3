#pragma once
#include <string>
#include <vector>

#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

Json warnings_json(const std::vector<BeyondTheory>& warnings);

/// A number, and its error rounded upwards, as decimals.
std::string value_text(const fast::Estimate& number);
std::string error_text(const fast::Estimate& number);
std::string value_text(const ref::Estimate& number);
std::string error_text(const ref::Estimate& number);

/// The answer of `solve`. The reference's numbers are text. The text of `full` has the meanings of the results. Instantiated
/// for fast::Estimate and ref::Estimate.
template <class Number>
Json solution_json(const SceneSolution<Number>& solution, bool full = false);

}  // namespace nipref::verify
