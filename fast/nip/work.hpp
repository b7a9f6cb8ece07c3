#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

namespace nipref::fast {

/// What solving a contact has cost so far: counts, not times.
struct Work {
  /// Evaluations of the kernels I1 .. I7, in this order. I2, a sign, is not counted.
  std::array<std::uint64_t, 7> kernel_evaluations{};
  std::uint64_t terms = 0;           ///< series terms behind those values
  std::uint64_t systems = 0;         ///< linear systems solved
  int unknowns = 0;                  ///< of the largest system
  std::uint64_t line_responses = 0;  ///< compliances and couplings of lines on half-spaces

  void count_system(int size) {
    ++systems;
    unknowns = std::max(unknowns, size);
  }
  Work& operator+=(const Work& other);
};

}  // namespace nipref::fast
