#pragma once
#include <vector>

#include <nipref/verify/figures/figure.hpp>

namespace nipref::verify {

/// All figures that can be drawn, the rows of data/statements/figures.csv: the thesis's that hold curves, in the order of their numbers, and what is behind the
/// tables of the papers on half-spaces. The seeds' own drawings are lost: axes follow their captions and text.
[[nodiscard]] std::vector<FigurePlan> figures();

/// Computes it: a part of a second, of rolling sheets seconds. Where the seed printed a table, its cells are in it with their rounding, those
/// in doubt left out, and what the seed's own method gives for their rows.
[[nodiscard]] Figure compute(const FigurePlan& plan);

}  // namespace nipref::verify
