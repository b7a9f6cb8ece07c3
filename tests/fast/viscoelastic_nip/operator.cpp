#include <doctest/doctest.h>

#include <complex>

#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/viscoelastic_nip/internal/operator.hpp>

using namespace nipref;

TEST_CASE("what trails behind a contact that swings far faster than it fades") {
  constexpr double tolerance = 1e-16;
  const fast::ViscoelasticLayout layout(1e-3, 1, 4);
  fast::Work work;
  fast::CountedKernels kernels(fast::Accuracy(), work);
  fast::ViscoelasticOperator from(layout, tolerance, kernels);
  for (const double frequency : {0.5, 3.25, 40.0, 1000.0}) {
    const std::complex<double> rate(250, 250 * frequency);
    constexpr double behind = 0.02;  // the trailing end
    const std::complex<double> found =
        from.trail({fast::Half::trailing, -behind}, rate, fast::ViscoelasticKernel::sign);
    // Up to there its kernel is 1 less than far ahead.
    const std::complex<double> truth = -(1.0 - std::exp(-rate * behind)) / rate;
    CHECK(std::abs(found - truth) <= 1e-14 / rate.real());
  }
}
