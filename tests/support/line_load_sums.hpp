#pragma once
#include <vector>

#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/sheet/displacements.hpp>

namespace line_load_tests {

/// A line load anywhere in the nip, both sides, in the thesis's numbering.
struct Load {
  double position;
  double normal;
  double shear;
};

inline std::vector<Load> all_loads(const nipref::fast::LineLoadSolution& solution) {
  const auto m = static_cast<int>(solution.line_loads.size());
  std::vector<Load> loads;
  for (int k = -m; k < m; ++k) {
    const auto mirrored = static_cast<std::size_t>(k < 0 ? -k - 1 : k);
    const double shear = solution.shear_loads.empty() ? 0 : solution.shear_loads[mirrored];
    loads.push_back(
        {(k + 0.5) * solution.element_width(), solution.line_loads[mirrored], k < 0 ? -shear : shear});
  }
  return loads;
}

/// Displacements at Y by the sum over all loads, no symmetry used: the middle of the nip as pinned point.
struct Displacement {
  double u;
  double v;
};

inline Displacement displacement(const nipref::data::ElasticNip& nip,
                                 const nipref::fast::LineLoadSolution& solution, double y) {
  namespace fast = nipref::fast;
  const double b = nip.half_thickness();
  Displacement sum{0, 0};
  for (const Load& load : all_loads(solution)) {
    const double alpha = (y - load.position) / b;
    const double eta = -load.position / b;
    sum.u += load.normal * fast::un(alpha, nip.material) + load.shear * fast::us(alpha, nip.material);
    sum.v +=
        load.normal * fast::vn(alpha, eta, nip.material) + load.shear * fast::vs(alpha, eta, nip.material);
  }
  return sum;
}

}  // namespace line_load_tests
