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
    const std::complex<double> found =
        from.trail({fast::Half::trailing, 1e-3}, rate, fast::ViscoelasticKernel::sign);
    // Ahead of the trail its kernel is 1/2.
    CHECK(std::abs(found - 0.5 / rate) <= 1e-14 * 0.5 / rate.real());
  }
}
