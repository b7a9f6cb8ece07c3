#pragma once
#include <string>

#include <nipref/data/scene/scene.hpp>

namespace nipref::verify {

/// Seconds that solve_by_ref() will take, by what the reference says that it has to solve for and by the places that
/// are wanted, as measured on one core of a server of 2022, within a factor of three or so; a length that a load needs
/// is found in double. 0 where that is refused, for line loads and for bodies on half-spaces.
[[nodiscard]] double likely_seconds_by_ref(const data::Scene& scene, int digits);

/// A line that says so if they are more than ten; otherwise nothing.
[[nodiscard]] std::string warning_of_time(double seconds);

}  // namespace nipref::verify
