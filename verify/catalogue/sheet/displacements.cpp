#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/ref/sheet/displacements.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/catalogue/sheet/internal/envelopes.hpp>

namespace nipref::verify {
namespace {

using data::ElasticMaterial;
using fast::Accuracy;
using std::numbers::pi;

// For some Poisson's ratios the kernels in these sums cancel. This loss of digits is due to the problem's condition and
// not to the code, so that the scale is the sum of the magnitudes of the terms: |coefficient| times the kernel's size.

/// An approximate upper bound of |I6|: the growing part, the logarithm, and the residue terms.
double magnitude_I6(double alpha, double eta) {
  const double growing = pi / 4 * std::fabs(std::fabs(eta) - std::fabs(alpha));
  const double logarithm = std::max(0.0, -std::log(std::fabs(alpha)));
  return growing + logarithm + envelope_r(alpha) + envelope_s(eta);
}

double size_F1(double eta, double poisson) {
  const ElasticMaterial material{1, poisson};
  return (material.theta2() * magnitude_I4(eta) + material.theta1() * magnitude_I5(eta)) /
         (pi * material.normal_compliance());
}

double size_F2(double eta, double poisson) {
  const ElasticMaterial material{1, poisson};
  return std::fabs(eta) / 4 + envelope_s(eta) / pi +
         material.theta1() / material.normal_compliance() * envelope_I7(eta) / pi;
}

/// A kernel that underflows has fewer than 53 bits, and a large compliance makes this loss visible: a size below the
/// smallest normal number counts as that number.
double normal_size(double kernel) { return std::max(kernel, std::numeric_limits<double>::min()); }

/// The terms of I2 and I3; the magnitude of I2 is pi/2 but at the load.
double size_of_step(double alpha, const ElasticMaterial& material) {
  return alpha == 0 ? 0 : material.theta2() / 2;
}

double size_vn(double alpha, double eta, double young, double poisson) {
  const ElasticMaterial material{young, poisson};
  return size_of_step(alpha, material) +
         (material.normal_compliance() * magnitude_I3(alpha) + material.theta2() * magnitude_I4(eta) +
          material.theta1() * magnitude_I5(eta)) /
             pi;
}

double size_us(double alpha, double young, double poisson) {
  const ElasticMaterial material{young, poisson};
  return size_of_step(alpha, material) + material.normal_compliance() * magnitude_I3(alpha) / pi;
}

double size_vs(double alpha, double eta, double young, double poisson) {
  const ElasticMaterial material{young, poisson};
  return (material.normal_compliance() * normal_size(magnitude_I6(alpha, eta)) +
          material.theta1() * normal_size(envelope_I7(eta))) /
         pi;
}

using Function = double (*)(double, const ElasticMaterial&, Accuracy);
using FunctionOfTwo = double (*)(double, double, const ElasticMaterial&, Accuracy);

auto of_constants(Function function) {
  return [function](double alpha, double young, double poisson, Accuracy accuracy) {
    return function(alpha, {young, poisson}, accuracy);
  };
}
auto of_constants(FunctionOfTwo function) {
  return [function](double alpha, double eta, double young, double poisson, Accuracy accuracy) {
    return function(alpha, eta, {young, poisson}, accuracy);
  };
}

}  // namespace

std::vector<Quantity> displacement_entries() {
  return {entry_of("F1", {"eta", "poisson"}, ref::F1, fast::F1, size_F1),
          entry_of("F2", {"eta", "poisson"}, ref::F2, fast::F2, size_F2),
          entry_of("un", {"alpha", "young", "poisson"}, ref::un, of_constants(fast::un),
                   [](double alpha, double young, double poisson) {
                     const ElasticMaterial material{young, poisson};
                     return material.normal_compliance() * normal_size(envelope_I1(alpha)) / pi;
                   }),
          entry_of("us", {"alpha", "young", "poisson"}, ref::us, of_constants(fast::us), size_us),
          entry_of("vn", {"alpha", "eta", "young", "poisson"}, ref::vn, of_constants(fast::vn), size_vn),
          entry_of("vs", {"alpha", "eta", "young", "poisson"}, ref::vs, of_constants(fast::vs), size_vs)};
}

}  // namespace nipref::verify
