#pragma once
#include <vector>

#include <nipref/verify/figures/figure.hpp>

namespace nipref::verify {

// The figures by what they are of.

std::vector<FigurePlan> kernel_figures();           ///< thesis 7-13
std::vector<FigurePlan> creep_range_figure();       ///< thesis 15
std::vector<FigurePlan> elastic_load_figures();     ///< thesis 17-25
std::vector<FigurePlan> elastic_profile_figures();  ///< thesis 26-29
std::vector<FigurePlan> moving_load_figures();      ///< thesis 32-38
std::vector<FigurePlan> rolling_figures();          ///< thesis 41-53
std::vector<FigurePlan> stress_figures();           ///< inside the sheet, thesis ch. III
std::vector<FigurePlan> half_space_figures();       ///< behind the papers' tables

}  // namespace nipref::verify
