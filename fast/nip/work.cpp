#include <algorithm>

#include <nipref/fast/nip/work.hpp>

namespace nipref::fast {

Work& Work::operator+=(const Work& other) {
  for (std::size_t kernel = 0; kernel < kernel_evaluations.size(); ++kernel) {
    kernel_evaluations[kernel] += other.kernel_evaluations[kernel];
  }
  terms += other.terms;
  systems += other.systems;
  unknowns = std::max(unknowns, other.unknowns);
  line_responses += other.line_responses;
  return *this;
}

}  // namespace nipref::fast
