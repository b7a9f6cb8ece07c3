#pragma once
#include <string>

#include <nipref/data/scene/scene.hpp>

namespace nipref::verify {

/// An estimate of the seconds that solve_by_ref() takes on one core of a server of 2022, good to a factor of about
/// three. It follows from the number of unknowns and the number of wanted places; the length for a given load is
/// computed in double. It is 0 for scenes that double refuses, for line loads and for bodies on half-spaces.
[[nodiscard]] double likely_seconds_by_ref(const data::Scene& scene, int digits);

/// A warning of one line if the seconds are more than ten; otherwise empty.
[[nodiscard]] std::string warning_of_time(double seconds);

}  // namespace nipref::verify
