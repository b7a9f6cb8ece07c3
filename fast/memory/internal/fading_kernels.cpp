#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/memory/internal/fading.hpp>
#include <nipref/fast/memory/internal/fading_kernels.hpp>
#include <nipref/fast/sheet/internal/argument_checks.hpp>

namespace nipref::fast {
namespace {

using namespace internal;

void check_rate(double Lambda) {
  if (!(Lambda >= 0) || !std::isfinite(Lambda)) {
    throw data::BadInput("Lambda", Lambda, "must be a finite number, 0 or more");
  }
}

double steady(double alpha, const Fade& fading, Accuracy accuracy) {
  return steady_memory(Kernel::I1, spot({alpha, 0}, accuracy), fading, accuracy);
}

}  // namespace

double steady_I1(double alpha, double Lambda, Accuracy accuracy) {
  check_argument("alpha", alpha, Domain::finite);
  check_rate(Lambda);
  return steady(alpha, fade(Two{Lambda, 0}, {Kernel::I1}, accuracy), accuracy);
}

void steady_I1(std::span<const double> alpha, double Lambda, std::span<double> value, Accuracy accuracy) {
  check_arguments("alpha", alpha, value.size(), Domain::finite);
  check_rate(Lambda);
  const Fade fading = fade(Two{Lambda, 0}, {Kernel::I1}, accuracy);
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = steady(alpha[i], fading, accuracy);
}

}  // namespace nipref::fast
