#pragma once
#include <vector>

#include <nipref/data/problem/friction.hpp>
#include <nipref/fast/nip/line_loads.hpp>

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

}  // namespace line_load_tests
