#pragma once
#include <string>
#include <vector>

#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// The warnings about linear theory, one line each.
std::string warnings_text(const std::vector<BeyondTheory>& warnings);
Json warnings_json(const std::vector<BeyondTheory>& warnings);

/// A number, and its error rounded upwards, as decimals.
std::string value_text(const fast::Estimate& number);
std::string error_text(const fast::Estimate& number);
std::string value_text(const ref::Estimate& number);
std::string error_text(const ref::Estimate& number);

/// The text for people: whether the accuracy is met, numbers with errors and units, in `full` with their meanings,
/// profiles as a table, the work in one line. Instantiated for fast::Estimate and ref::Estimate.
template <class Number>
std::string solution_text(const SceneSolution<Number>& solution, bool full = false);

/// The JSON output of `solve`. The reference's numbers are text.
template <class Number>
Json solution_json(const SceneSolution<Number>& solution);

}  // namespace nipref::verify
