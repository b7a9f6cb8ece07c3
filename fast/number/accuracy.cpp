#include <nipref/data/bad_input.hpp>
#include <nipref/fast/number/accuracy.hpp>
#include <nipref/fast/number/internal/tiers.hpp>

namespace nipref::fast {

static_assert(Accuracy().tier() == internal::kFullTier &&
              internal::cheapest_tier(Accuracy::kBest) == internal::kFullTier);

Accuracy::Accuracy(double rtol) : rtol_(rtol) {
  if (!(rtol >= kBest && rtol < 1)) {
    throw data::BadInput("rtol", rtol,
                         "must satisfy 4.44e-16 <= rtol < 1 (best reachable: 2^-51 = 4.44e-16)");
  }
  tier_ = internal::cheapest_tier(rtol);
}

}  // namespace nipref::fast
