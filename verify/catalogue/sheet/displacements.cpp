#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/ref/sheet/displacements.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/catalogue/sheet/internal/envelopes.hpp>

namespace nipref::verify {
namespace {

using data::ElasticMaterial;
using fast::Accuracy;
using std::numbers::pi;
using Arguments = std::span<const double>;
using Exacts = std::span<const ref::Exact>;

// The kernels in these sums cancel for some Poisson's ratios, and such a loss is the problem's and not the
// code's. So the scale is the sum of the magnitudes of the terms: |coefficient| times the size of its kernel.

constexpr double displacement_promise = 8;
constexpr auto sum_of_terms = "max(|value|, sum of the magnitudes of its kernel terms)";

Argument poisson_argument() {
  const double below_half = std::nextafter(0.5, 0.0);
  const double above_minus_one = std::nextafter(-1.0, 0.0);
  return {"poisson",
          ArgumentKind::poisson,
          std::nullopt,
          {above_minus_one, -0.999, -0.5, 0.0, 0.25, 0.3, 1.0 / 3, 0.4999, below_half, 0.5}};
}

Argument young_argument() { return {"young", ArgumentKind::young, "1", {1e-6, 1.0, 145000.0, 1e12}}; }

/// |I6| is at most about this: the growing part, the logarithm, and the residue terms.
double magnitude_I6(double alpha, double eta) {
  const double growing = pi / 4 * std::fabs(std::fabs(eta) - std::fabs(alpha));
  const double logarithm = std::max(0.0, -std::log(std::fabs(alpha)));
  return growing + logarithm + envelope_r(alpha) + envelope_s(eta);
}

Quantity entry_F1() {
  Quantity entry;
  entry.name = "F1";
  entry.definition = "(theta2 I4(eta) - theta1 I5(eta)) / (pi (theta1 + theta2)), odd in eta";
  entry.source = "thesis (4.24)";
  entry.scale = sum_of_terms;
  entry.arguments = {position_argument("eta"), poisson_argument()};
  entry.promise = displacement_promise;
  entry.by_ref = [](Exacts a, int digits) { return ref::F1(a[0], a[1], digits); };
  set_fast(entry, [](Arguments a, Accuracy accuracy) { return fast::F1(a[0], a[1], accuracy); });
  entry.envelope = [](Arguments a) {
    const ElasticMaterial material{1, a[1]};
    return (material.theta2() * magnitude_I4(a[0]) + material.theta1() * magnitude_I5(a[0])) /
           (pi * material.normal_compliance());
  };
  return entry;
}

Quantity entry_F2() {
  Quantity entry;
  entry.name = "F2";
  entry.definition =
      "eta's part of vs / (theta1 + theta2): |eta|/4 - s(eta)/pi + theta1 I7(eta) / (pi (theta1 + theta2))";
  entry.source = "thesis (4.24)";
  entry.scale = sum_of_terms;
  entry.arguments = {position_argument("eta"), poisson_argument()};
  entry.promise = displacement_promise;
  entry.by_ref = [](Exacts a, int digits) { return ref::F2(a[0], a[1], digits); };
  set_fast(entry, [](Arguments a, Accuracy accuracy) { return fast::F2(a[0], a[1], accuracy); });
  entry.envelope = [](Arguments a) {
    const ElasticMaterial material{1, a[1]};
    return std::fabs(a[0]) / 4 + envelope_s(a[0]) / pi +
           material.theta1() / material.normal_compliance() * envelope_I7(a[0]) / pi;
  };
  return entry;
}

/// Where a kernel underflows it has fewer than 53 bits, and a large compliance makes that loss visible: what
/// is smaller than the smallest normal number counts as that.
double normal_size(double kernel) { return std::max(kernel, std::numeric_limits<double>::min()); }

Quantity entry_un() {
  Quantity entry;
  entry.name = "un";
  entry.definition = "normal displacement by a unit normal line load: (theta1 + theta2) I1(alpha) / pi";
  entry.source = "thesis (4.25 a)";
  entry.unit = "1/unit of young";
  entry.scale = "max(|un|, slowest residue term's amplitude, 2^-1022 (theta1 + theta2)/pi)";
  entry.arguments = {nonzero_position_argument("alpha"), young_argument(), poisson_argument()};
  entry.promise = displacement_promise;
  entry.by_ref = [](Exacts a, int digits) { return ref::un(a[0], a[1], a[2], digits); };
  set_fast(entry, [](Arguments a, Accuracy accuracy) {
    return fast::un(a[0], ElasticMaterial{a[1], a[2]}, accuracy);
  });
  entry.envelope = [](Arguments a) {
    return ElasticMaterial{a[1], a[2]}.normal_compliance() * normal_size(envelope_I1(a[0])) / pi;
  };
  return entry;
}

Quantity entry_vn() {
  Quantity entry;
  entry.name = "vn";
  entry.definition =
      "tangential displacement by a unit normal line load: "
      "(-theta2 I2(alpha) + (theta1 + theta2) I3(alpha) + theta2 I4(eta) - theta1 I5(eta)) / pi";
  entry.source = "thesis (4.25 c)";
  entry.unit = "1/unit of young";
  entry.scale = sum_of_terms;
  entry.arguments = {position_argument("alpha"), position_argument("eta"), young_argument(),
                     poisson_argument()};
  entry.promise = displacement_promise;
  entry.by_ref = [](Exacts a, int digits) { return ref::vn(a[0], a[1], a[2], a[3], digits); };
  set_fast(entry, [](Arguments a, Accuracy accuracy) {
    return fast::vn(a[0], a[1], ElasticMaterial{a[2], a[3]}, accuracy);
  });
  entry.envelope = [](Arguments a) {
    const ElasticMaterial material{a[2], a[3]};
    const double step = a[0] == 0 ? 0 : material.theta2() / 2;
    return step + (material.normal_compliance() * magnitude_I3(a[0]) +
                   material.theta2() * magnitude_I4(a[1]) + material.theta1() * magnitude_I5(a[1])) /
                      pi;
  };
  return entry;
}

Quantity entry_us() {
  Quantity entry;
  entry.name = "us";
  entry.definition =
      "normal displacement by a unit shear line load: (theta2 I2(alpha) - (theta1 + theta2) I3(alpha)) / pi";
  entry.source = "thesis (4.25 b)";
  entry.unit = "1/unit of young";
  entry.scale = sum_of_terms;
  entry.arguments = {position_argument("alpha"), young_argument(), poisson_argument()};
  entry.promise = displacement_promise;
  entry.by_ref = [](Exacts a, int digits) { return ref::us(a[0], a[1], a[2], digits); };
  set_fast(entry, [](Arguments a, Accuracy accuracy) {
    return fast::us(a[0], ElasticMaterial{a[1], a[2]}, accuracy);
  });
  entry.envelope = [](Arguments a) {
    const ElasticMaterial material{a[1], a[2]};
    const double step = a[0] == 0 ? 0 : material.theta2() / 2;
    return step + material.normal_compliance() * magnitude_I3(a[0]) / pi;
  };
  return entry;
}

Quantity entry_vs() {
  Quantity entry;
  entry.name = "vs";
  entry.definition =
      "tangential displacement by a unit shear line load: ((theta1 + theta2) I6(alpha, eta) + theta1 "
      "I7(eta)) / pi";
  entry.source = "thesis (4.25 d)";
  entry.unit = "1/unit of young";
  entry.scale = std::string(sum_of_terms) + ", each kernel at least 2^-1022";
  entry.arguments = {nonzero_position_argument("alpha"), position_argument("eta"), young_argument(),
                     poisson_argument()};
  entry.promise = displacement_promise;
  entry.by_ref = [](Exacts a, int digits) { return ref::vs(a[0], a[1], a[2], a[3], digits); };
  set_fast(entry, [](Arguments a, Accuracy accuracy) {
    return fast::vs(a[0], a[1], ElasticMaterial{a[2], a[3]}, accuracy);
  });
  entry.envelope = [](Arguments a) {
    const ElasticMaterial material{a[2], a[3]};
    return (material.normal_compliance() * normal_size(magnitude_I6(a[0], a[1])) +
            material.theta1() * normal_size(envelope_I7(a[1]))) /
           pi;
  };
  return entry;
}

}  // namespace

std::vector<Quantity> displacement_entries() {
  return {entry_F1(), entry_F2(), entry_un(), entry_vn(), entry_us(), entry_vs()};
}

}  // namespace nipref::verify
