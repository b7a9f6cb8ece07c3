#include "support/kernels.hpp"

using namespace fast_tests;

namespace {
/// Four tolerances a decade over all tolerances that are allowed.
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
  const std::vector<double> alpha = arguments();
  const std::vector<double> eta = log_uniform(1e-3, 340, static_cast<int>(alpha.size()), 9);
  for (const char* const name : {"I1", "I3", "I4", "I5", "I6", "I7"}) {
    const nipref::verify::Quantity& kernel = nipref::verify::find_quantity(name);
    double worst_use = 0;  // largest used part of the allowance
    for (std::size_t i = 0; i < alpha.size(); ++i) {
      std::vector<double> point{alpha[i], eta[i]};
      point.resize(kernel.arguments.size());
      const double full = kernel.by_fast(point, {});
      const double scale = std::max(std::fabs(full), kernel.envelope(point));
      for (const double rtol : tolerances()) {
        const double use =
            std::fabs(kernel.by_fast(point, Accuracy(rtol)) - full) / (rtol * scale + 2 * ulp(scale));
        worst_use = use <= worst_use ? worst_use : use;  // a NaN must not pass
      }
    }
    CAPTURE(name);
    CHECK(worst_use <= 1);
  }
}

TEST_CASE("coarse tolerances really do less") {
  // If coarse tolerances changed nothing, the sweep above would hold trivially.
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
