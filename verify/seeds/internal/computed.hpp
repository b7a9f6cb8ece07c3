#pragma once
#include <functional>
#include <map>
#include <string>

#include <nipref/verify/seeds/propagated.hpp>

namespace nipref::verify {

/// Numbers of statements that are no formula of other numbers, by name.
const std::map<std::string, std::function<Propagated()>>& computed_numbers();

/// The value of a printed formula in double arithmetic without a bound on its rounding: eight of its sixteen digits are
/// trusted, enough to tell it from the truth.
Propagated printed_form(double value);

}  // namespace nipref::verify
