#include <cmath>

#include <nipref/fast/nip/inner_stresses.hpp>

namespace nipref::fast {
namespace {

Estimate mean_of(const InnerStresses& s) {
  return {(s.across.value + s.along.value) / 2, (s.across.error + s.along.error) / 2};
}

}  // namespace

Estimate InnerStresses::maximum_shear() const {
  // The radius is the distance of two points: it changes by no more than the points move.
  return {std::hypot((across.value - along.value) / 2, shear.value),
          std::hypot((across.error + along.error) / 2, shear.error)};
}

Estimate InnerStresses::highest() const {
  const Estimate mean = mean_of(*this), radius = maximum_shear();
  return {mean.value + radius.value, mean.error + radius.error};
}

Estimate InnerStresses::lowest() const {
  const Estimate mean = mean_of(*this), radius = maximum_shear();
  return {mean.value - radius.value, mean.error + radius.error};
}

}  // namespace nipref::fast
