#pragma once
#include <map>

#include <nipref/fast/nip/internal/solution.hpp>

namespace nipref::fast {

/// A functional that belongs to no place, made once for each solution. To be emptied when the solutions change.
class KeptFunctional {
 public:
  template <class Make>
  Functional of(const Solution& solution, const Make& make) {
    const auto found = kept_.find(&solution);
    return found != kept_.end() ? found->second : kept_.emplace(&solution, make()).first->second;
  }

 private:
  std::map<const Solution*, Functional> kept_;
};

}  // namespace nipref::fast
