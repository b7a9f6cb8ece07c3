#pragma once
#include <cstddef>
#include <vector>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/cli/command_line.hpp>

namespace nipref::verify {

/// Golden points are at most one in so many of the points that are asked for.
inline constexpr std::size_t golden_share = 10;

/// The points of the quantity's golden values that lie in the ranges, at most `most` of them, evenly taken; none if it
/// has no golden values. BadInput if their file cannot be read.
std::vector<Point> golden_points(const Quantity& quantity, const Ranges& ranges, std::size_t most);

/// Which points of a quantity are drawn: by the options points and seed, or a density in place of points, and by the
/// ranges that are assigned. Golden points are among them.
AuditOptions sampling_options(const CommandLine& line, const Quantity& quantity, double density = 1);

}  // namespace nipref::verify
