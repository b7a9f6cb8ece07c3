// The rolling contact's solution: the residuals of its equations.
#include <nipref/ref/viscoelastic_nip/internal/rolling_sheet.hpp>

#include "support/test.hpp"

using namespace nipref::ref;

namespace {

constexpr int digits_here = 20;
constexpr double nats_here = digits_here * std::numbers::ln10;

/// A sheet with the working precision of the first call.
const RollingSheet& sheet_here() {
  static const RollingSheet sheet(RollingMaterial{1,
                                                  {{ComplexFloat(1), ComplexFloat(1)},
                                                   {ComplexFloat(3), ComplexFloat(20)},
                                                   {ComplexFloat(0.2, -0.1), ComplexFloat(1, 3)},
                                                   {ComplexFloat(0.2, 0.1), ComplexFloat(1, -3)}},
                                                  Float(1) / 4,
                                                  {{ComplexFloat(0.2), ComplexFloat(1)}}});
  return sheet;
}

std::unique_ptr<NipSolution> solution_of(const Float& half_length, SheetKernels& kernels) {
  auto panels = panels_of(half_length, sheet_here().resolution(), {1.3, 2, nats_here});
  return sheet_here().solved(half_length, std::move(panels), 1.2 * nats_here, kernels);
}

}  // namespace

TEST_CASE("ref: the rolling sheet's surface meets the roller at both ends, with its slope") {
  const WorkingDigits working(32);
  SheetKernels kernels(26);
  const Float size = Float(1) / 3, step = 1e-9;
  const auto contact = solution_of(size, kernels);
  const auto u = [&](const Float& x) { return contact->normal(x); };
  // Ahead u has memories of the coming load only; behind it has those of the whole contact, where the roller sets f.
  for (const Float& end : {Float(0), Float(2 * size)}) {
    const int outwards = end == 0 ? -1 : 1;
    CHECK(abs(u(end + outwards * Float(1e-24)) - u(end)) <= 1e-16 * size * size);
    const Float inside = (u(end) - u(end - outwards * step)) / step,
                outside = (u(end + outwards * step) - u(end)) / step;
    CHECK(abs(outside - inside) <= 1e-3 * size);  // the slope changes like a root of the distance
  }
}

TEST_CASE("ref: the rolling sheet's strain is the slope of its tangential displacement") {
  const WorkingDigits working(32);
  SheetKernels kernels(26);
  const Float size = 1;
  const auto contact = solution_of(size, kernels);
  for (const double x : {-0.01, 0.3, 1.7, 9.0}) {
    CAPTURE(x);
    const Float step = 1e-6;
    const auto v = [&](const Float& at) { return contact->tangential(at); };
    const Float slope =
        -(8 * (v(x + step) - v(x - step)) - (v(x + 2 * step) - v(x - 2 * step))) / (12 * step);
    CHECK(abs(contact->strain(x) - slope) <= 1e-13);
  }
}
