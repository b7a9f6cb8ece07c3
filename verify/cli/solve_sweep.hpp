#pragma once
#include <optional>
#include <ostream>

#include <nipref/data/scene/file.hpp>
#include <nipref/verify/catalogue/axes.hpp>
#include <nipref/verify/cli/command_line.hpp>

namespace nipref::verify {

/// What a scene sweeps over, and the command line beside it, in that order; the command line's assignment
/// stands for what the file has. One combination, of what is assigned, if there is no sweep. BadInput as axis_of
/// and AxesProduct have it.
AxesProduct swept_scenes(const data::SceneText& text, const CommandLine& line);

/// solve of a scene for each combination: a row each with its results and errors, with the names of those that missed
/// the accuracy, and with what is beyond linear theory. digits: of ref; nothing: by fast. 1 if a scene was refused or
/// missed its accuracy. BadInput if all are refused, and if a profile is wanted.
int solve_sweep(const data::SceneText& text, const AxesProduct& scenes, std::optional<int> digits,
                const CommandLine& line, std::ostream& out);

}  // namespace nipref::verify
