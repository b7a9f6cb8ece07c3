#include <nipref/data/bad_input.hpp>
#include <nipref/fast/number/accuracy.hpp>
#include <nipref/fast/number/internal/tiers.hpp>

namespace nipref::fast {

static_assert(Accuracy().tier() == internal::full_tier &&
              internal::cheapest_tier(Accuracy::best_rtol) == internal::full_tier);

Accuracy::Accuracy(double rtol) : rtol_(rtol) {
  if (!(rtol >= best_rtol && rtol < 1)) {
    throw data::BadInput("rtol", rtol,
                         "must satisfy 4.44e-16 <= rtol < 1 (best reachable: 2^-51 = 4.44e-16)");
  }
  tier_ = internal::cheapest_tier(rtol);
}

}  // namespace nipref::fast
