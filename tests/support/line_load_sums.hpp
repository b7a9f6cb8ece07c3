#pragma once
#include <vector>

#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/data/problem/friction.hpp>
#include <nipref/fast/nip/line_loads.hpp>
#include <nipref/fast/sheet/displacements.hpp>

namespace line_load_tests {

constexpr nipref::data::Grip thesis_grip{nipref::data::Grip::Creep::thesis};
constexpr nipref::data::Grip grip_with(double creep) { return {nipref::data::Grip::Creep::given, creep}; }

/// The normal or the shear loads of one side, from the middle outwards.
inline std::vector<double> side_of(const nipref::fast::LineLoadNip& solution,
                                   double nipref::fast::FaceLoad::*kind) {
  std::vector<double> loads;
  for (auto k = static_cast<std::size_t>(solution.leading_elements); k > 0; --k)
    loads.push_back(solution.loads[k - 1].*kind);
  return loads;
}
inline std::vector<double> normal_loads(const nipref::fast::LineLoadNip& solution) {
  return side_of(solution, &nipref::fast::FaceLoad::normal);
}
inline std::vector<double> shear_loads(const nipref::fast::LineLoadNip& solution) {
  return side_of(solution, &nipref::fast::FaceLoad::shear);
}

/// Displacements at Y by the sum over all loads, no symmetry used: the middle of the nip as pinned point.
struct Displacement {
  double u;
  double v;
};

inline Displacement displacement(const nipref::data::ElasticNip& nip,
                                 const nipref::fast::LineLoadNip& solution, double y) {
  namespace fast = nipref::fast;
  const double b = nip.half_thickness();
  Displacement sum{0, 0};
  for (const fast::FaceLoad& load : solution.loads) {
    const double alpha = (y - load.y) / b;
    const double eta = -load.y / b;
    sum.u += load.normal * fast::un(alpha, nip.material) + load.shear * fast::us(alpha, nip.material);
    sum.v +=
        load.normal * fast::vn(alpha, eta, nip.material) + load.shear * fast::vs(alpha, eta, nip.material);
  }
  return sum;
}

}  // namespace line_load_tests
