#include <nipref/ref/half_space/rolling_sphere.hpp>

#include "support/isotropic_surface.hpp"
#include "support/test.hpp"

using namespace nipref;
using ref::Exact;

TEST_CASE("the reference's rolling sphere keeps its digits where K Knn - S^2 vanishes") {
  const double rayleigh = 0.92741270970293665;  // nu = 0.3
  const auto surface = isotropic_surface(0.3, (1 - 1e-13) * rayleigh);
  const auto agree = [](const ref::Estimate& few, const ref::Estimate& many) {
    const ref::Float off = abs(ref::at_working_precision(few.value) - ref::at_working_precision(many.value));
    CHECK(off <= ref::at_working_precision(few.error) + ref::at_working_precision(many.error));
  };
  agree(ref::rolling_index(surface, Exact(0.0), 30), ref::rolling_index(surface, Exact(0.0), 60));
  agree(ref::rolling_span_ratio(surface, Exact(90.0), 30), ref::rolling_span_ratio(surface, Exact(90.0), 60));
  CHECK_THROWS_AS((void)ref::rolling_span_ratio(surface, Exact(90.0), 101), data::BadInput);
  const ref::SurfaceAnswer too_near = [](const Exact&, int) -> ref::LineAnswer {
    return {1, 1 - ref::Float(1e-36), 0, 1};
  };
  CHECK_REFUSED(ref::rolling_index(too_near, Exact(0.0), 16), "speed = ");
}
