#include <nipref/fast/sheet/internal/dispatch.hpp>

#include "support/kernels.hpp"

using namespace fast_tests;
using nipref::data::BadInput;

namespace {
/// Arguments from all regimes and of both signs, mixed.
std::vector<double> mixed_arguments(int count, unsigned seed) {
  std::vector<double> x = log_uniform(1e-5, 500, count, seed);
  for (std::size_t i = 0; i < x.size(); i += 3) x[i] = -x[i];
  return x;
}

/// The largest difference, in units of the last place of the kernel's scale.
double units_apart(const Kernel& kernel, const std::vector<double>& x, const std::vector<double>& found,
                   const auto& expected) {
  double worst = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double value = expected(x[i]);
    const double units = std::fabs(found[i] - value) / ulp(kernel.scale(x[i], value));
    worst = units <= worst ? worst : units;  // a NaN must not pass
  }
  return worst;
}
}  // namespace

TEST_CASE("batches agree with single values, for every size up to several blocks") {
  for (const int size : {0, 1, 7, 8, 9, 15, 511, 512, 513, 2000}) {
    const std::vector<double> x = mixed_arguments(size, 11);
    for (const Kernel& kernel : kernels()) {
      for (const double rtol : {1e-3, 1e-6, 1e-9, 1e-12, Accuracy::best_rtol}) {
        std::vector<double> value(x.size(), -1);
        kernel.batch(x, value, Accuracy(rtol));
        CAPTURE(kernel.name, size);
        CHECK(units_apart(kernel, x, value, [&](double at) { return kernel.scalar(at, Accuracy(rtol)); }) <=
              1);
      }
    }
  }
}

TEST_CASE("a batch with one bad element names it and writes nothing") {
  std::vector<double> x = mixed_arguments(700, 14);
  x[613] = std::nan("");
  std::vector<double> value(x.size(), 42);
  for (const Kernel& kernel : kernels()) CHECK_THROWS_AS(kernel.batch(x, value, {}), BadInput);
  CHECK_THROWS_WITH(nipref::fast::I1(x, value), "alpha[613] = nan: must be a finite number");
  CHECK_THROWS_AS(nipref::fast::I6(x, x, value), BadInput);
  CHECK_THROWS_AS(nipref::fast::I2(x, value), BadInput);
  x[613] = 0;
  CHECK_THROWS_WITH(nipref::fast::I1(x, value),
                    "alpha[613] = 0: must be nonzero: the kernel is infinite there");
  std::vector<double> other(x.size());
  CHECK_NOTHROW(nipref::fast::I3(x, other));
  for (const double untouched : value) CHECK(untouched == 42);
  value.pop_back();
  CHECK_THROWS_WITH(nipref::fast::I7(x, value), "value.size() = 699: must equal eta.size() = 700");
}

TEST_CASE("the code for each instruction set of this processor keeps the promise, batches as single values") {
  namespace internal = nipref::fast::internal;
  const std::vector<std::vector<double>> arguments = {
      mixed_arguments(4000, 15),     log_uniform(1e-320, 0.4, 515, 17), log_uniform(0.6, 11, 515, 18),
      log_uniform(13, 1e3, 515, 19), log_uniform(0.6, 300, 515, 20),    log_uniform(1e-5, 11, 515, 21)};
  for (int set = 0; set < internal::instruction_set_count; ++set) {
    if (!internal::has_instruction_set(set)) continue;
    const internal::SheetCode* const code = internal::sheet_codes[set];
    for (std::size_t k = 0; k < kernels().size(); ++k) {
      const Kernel& kernel = kernels()[k];
      for (int tier = 0; tier < internal::tier_count; ++tier) {
        for (const std::vector<double>& x : arguments) {
          std::vector<double> batch(x.size(), -1), single(x.size());
          code->batch[k][tier](x.data(), batch.data(), x.size());
          std::ranges::transform(x, single.begin(), code->scalar[k][tier]);
          CAPTURE(set, kernel.name, tier, x[0]);
          CHECK(units_apart(kernel, x, batch, code->scalar[k][tier]) <= 1);
          if (tier != internal::full_tier) continue;
          const auto chosen = [&](double at) { return kernel.scalar(at, {}); };
          CHECK(units_apart(kernel, x, batch, chosen) <= 2);
          CHECK(units_apart(kernel, x, single, chosen) <= 2);
        }
      }
    }
  }
}
