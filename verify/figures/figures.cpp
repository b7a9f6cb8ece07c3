#include <algorithm>
#include <iterator>

#include <nipref/verify/figures/figures.hpp>
#include <nipref/verify/figures/internal/groups.hpp>

namespace nipref::verify {

std::vector<FigurePlan> figures() {
  std::vector<FigurePlan> all;
  for (const auto& group : {kernel_figures, creep_range_figure, elastic_load_figures, elastic_profile_figures,
                            moving_load_figures, rolling_figures, stress_figures, half_space_figures})
    std::ranges::move(group(), std::back_inserter(all));
  return all;
}

Figure compute(const FigurePlan& plan) { return {plan.id, plan.title, plan.parameters, plan.compute()}; }

}  // namespace nipref::verify
