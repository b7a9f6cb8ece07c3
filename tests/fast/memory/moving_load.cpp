#include <nipref/fast/memory/internal/fading.hpp>
#include <nipref/fast/memory/moving_load.hpp>
#include <nipref/fast/sheet/kernels.hpp>

#include "support/test.hpp"

using namespace nipref::fast;

namespace {

/// Compliances that double with time, with one rate; Poisson's ratio is 1/3 throughout.
nipref::data::ViscoelasticMaterial softening_solid(double rate) {
  return {{1, {{rate, rate}}}, {0.5, {{rate / 2, rate}}}};
}

/// int_alpha^inf e^(-rate (w - alpha)) I1(w) dw: the memory of a point at alpha of the load, from the time when the
/// point was farther ahead of the load.
double steady_I1(double alpha, double rate, Accuracy accuracy = {}) {
  using internal::Kernel;
  return internal::steady_memory(Kernel::I1, internal::surface_point({alpha, 0}, accuracy),
                                 internal::fade(internal::Two{rate, 0}, {Kernel::I1}, accuracy), accuracy);
}

}  // namespace

TEST_CASE("the steady memory keeps every tolerance that is asked for") {
  for (const double alpha : {-40.0, -2.0, -0.7, -1e-5, 0.0, 1e-9, 0.3, 0.8, 1.5, 30.0}) {
    const double value = steady_I1(alpha, 0.8);
    for (const double rtol : {1e-3, 1e-6, 1e-8, 1e-12}) {
      CHECK(std::fabs(steady_I1(alpha, 0.8, Accuracy(rtol)) - value) <= rtol * std::fabs(value) * 4);
    }
  }
}

TEST_CASE("rates beyond any scale of the sheet neither overflow nor lose digits") {
  for (const double alpha : {-1e4, -300.0, -1.0, -1e-9, 1e-9, 1.0, 300.0, 1e4}) {
    for (const double rate : {1e-12, 1.0, 1e12}) {
      const MovingLoad load(softening_solid(rate), 1, 1);
      const double un = load.steady_normal_displacement(alpha);
      CHECK(std::isfinite(un));
      CHECK(std::isfinite(load.normal_displacement(2e4, 2e4 + alpha)));
      if (std::fabs(alpha) > 200 && rate >= 1) CHECK(std::fabs(un) < 1e-120);
      if (rate == 1e12 && std::fabs(alpha) <= 1) {
        CHECK(un == doctest::Approx(3 * I1(alpha) / std::numbers::pi).epsilon(1 / std::fabs(alpha * 1e12)));
      }
    }
  }
}

TEST_CASE("a way too short to be seen beside the distance still counts") {
  const MovingLoad load(softening_solid(1e25), 1, 1);
  for (const double T : {-2.5, -0.75, -0.4, 0.4, 0.75, 2.5}) {
    CHECK(load.normal_displacement(1e-25, T) ==
          doctest::Approx(1.5 * I1(T) * (2 - std::exp(-1.0)) / std::numbers::pi).epsilon(1e-14));
  }
}

TEST_CASE("after a long way the displacements next to the load are as accurate as if it had always moved") {
  const MovingLoad load(softening_solid(3), 1, 1);
  for (const double alpha : {-1e-3, -1e-9, 1e-12, 1e-3}) {
    CAPTURE(alpha);
    CHECK(load.normal_displacement_after(1e4, alpha) ==
          approx(load.steady_normal_displacement(alpha), 1e-14));
    CHECK(load.tangential_displacement_after(1e4, alpha, 2 * alpha) ==
          approx(load.steady_tangential_displacement(alpha, 2 * alpha), 1e-14));
  }
}

TEST_CASE("bad input to the moving load is refused by name") {
  CHECK_REFUSED(MovingLoad(softening_solid(1), 1, HUGE_VAL), "half_thickness = inf");
  CHECK_REFUSED(MovingLoad(softening_solid(-1), 1, 1), "theta1 rate = -1");
  const MovingLoad load(softening_solid(1), 1, 1), far(softening_solid(1), 90, 1e-12);
  CHECK_REFUSED(load.normal_displacement(1, not_a_number), "T = nan");
  CHECK_REFUSED(load.tangential_displacement(1, 2, HUGE_VAL), "t0 = inf");
  CHECK_NOTHROW(static_cast<void>(load.tangential_displacement(2, 2, 2)));
  CHECK_REFUSED(far.normal_displacement(1000, -1e308),
                "T = -1e+308: must be within 1e100 half_thickness/speed of both 0 and t");
  CHECK_REFUSED(far.tangential_displacement(1, 2, -1e308), "t0 = -1e+308: must be within 1e100");
  CHECK_REFUSED(load.normal_displacement_after(1, 0), "alpha = 0");
  CHECK_REFUSED(load.normal_displacement_after(-1, 1), "way = -1");
  CHECK_REFUSED(load.tangential_displacement_after(1, 2, 1e101), "eta = 1e+101");
  CHECK(load.normal_displacement(1e100, 1) == 0);
}
