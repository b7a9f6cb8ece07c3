#include "support/kernels.hpp"
#include "support/test.hpp"

using namespace fast_tests;

TEST_SUITE_BEGIN("fast sheet kernels");

namespace {
/// Four tolerances a decade over everything that can be asked for.
std::vector<double> tolerances() {
  std::vector<double> all{Accuracy::best_rtol};
  for (int quarter = -61; quarter < 0; ++quarter) all.push_back(std::pow(10.0, quarter / 4.0));
  return all;
}

std::vector<double> arguments() {
  std::vector<double> x = log_uniform(1e-300, 1e-6, 20, 7);
  for (const double y : log_uniform(1e-6, 340, 500, 8)) x.push_back(y);
  return x;
}
}  // namespace

TEST_CASE("every tolerance is kept, measured against full accuracy") {
  const std::vector<double> x = arguments();
  for (const Kernel& kernel : kernels()) {
    std::vector<double> full;
    for (const double point : x) full.push_back(kernel.scalar(point, {}));
    double worst_use = 0;  // of the allowance
    for (const double rtol : tolerances()) {
      for (std::size_t i = 0; i < x.size(); ++i) {
        const double scale = kernel.scale(x[i], full[i]);
        const double allowed = rtol * scale + 2 * ulp(scale);
        const double use = std::fabs(kernel.scalar(x[i], Accuracy(rtol)) - full[i]) / allowed;
        worst_use = use <= worst_use ? worst_use : use;  // a NaN must not pass
      }
    }
    CAPTURE(kernel.name);
    CHECK(worst_use <= 1);
  }
}

TEST_CASE("every tolerance is kept by I6") {
  const std::vector<double> a = arguments();
  const std::vector<double> e = log_uniform(1e-3, 340, static_cast<int>(a.size()), 9);
  for (const double rtol : tolerances()) {
    double worst_use = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double full = nipref::fast::I6(a[i], e[i]);
      const double scale = I6_scale(a[i], e[i], full);
      const double use =
          std::fabs(nipref::fast::I6(a[i], e[i], Accuracy(rtol)) - full) / (rtol * scale + 2 * ulp(scale));
      worst_use = use <= worst_use ? worst_use : use;
    }
    CAPTURE(rtol);
    CHECK(worst_use <= 1);
  }
}

TEST_CASE("coarse tolerances really do less") {
  // Otherwise the sweep above would hold trivially.
  int different = 0;
  for (const double x : log_uniform(0.01, 30, 100, 10)) {
    different += nipref::fast::I1(x, Accuracy(1e-3)) != nipref::fast::I1(x) ? 1 : 0;
  }
  CHECK(different > 90);
}

TEST_CASE("tolerances that cannot be kept are refused with the best that can") {
  for (const double bad : {0.0, -1.0, 1.0, 2e-16, std::nan("")})
    CHECK_THROWS_AS(Accuracy{bad}, nipref::data::BadInput);
  CHECK_THROWS_WITH(Accuracy{0.0},
                    "rtol = 0: must satisfy 4.44e-16 <= rtol < 1 (best reachable: 2^-51 = 4.44e-16)");
  CHECK(Accuracy(Accuracy::best_rtol).tier() == Accuracy().tier());
  CHECK(Accuracy(0.5).tier() == 0);
}

TEST_SUITE_END();
