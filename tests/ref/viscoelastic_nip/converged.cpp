// The rolling contact in multiprecision: against the energy that the sheet loses, the elastic contact's proof, the
// double path and itself.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/viscoelastic_nip/converged.hpp>

#include "support/thesis_nips.hpp"

using namespace nipref;
using data::ViscoelasticNip;

namespace {

/// Relaxation lengths `way` and three times that, the compliances grow by `growth` of themselves.
ViscoelasticNip rolled_nip(double thickness, double way, double growth) {
  const data::MaterialFunction theta1{9e-6, {{9e-6 * growth / way, 1 / way}}};
  const data::MaterialFunction theta2{3e-6, {{1e-6 * growth / way, 1 / (3 * way)}}};
  return {6, thickness, data::ViscoelasticMaterial(theta1, theta2), 1};
}

/// (1/pi) int_0^inf q b h(qb) |p^(q)|^2 (-Im N(i q speed)) dq, h(s) = 2 sinh^2 s/(s (sinh 2s + 2s)), b the half
/// thickness: what the sheet loses by the length that it is rolled. By Gauss-Chebyshev for p^, which needs
/// fewer nodes than 2 q/L, and the trapezoidal rule over the root of q.
double lost_energy(const ViscoelasticNip& nip, const ref::ConvergedViscoelasticNip& contact) {
  constexpr int nodes = 200;
  constexpr double last = 12, step = 0.01;  // of the root of q L/2
  const double size = contact.contact_length().to_double() / 2;
  const double middle = (contact.leading_length().to_double() - contact.trailing_length().to_double()) / 2;
  std::vector<double> at, weighted;
  for (int j = 1; j < nodes; ++j) {
    const double angle = std::numbers::pi * j / nodes;
    at.push_back(std::cos(angle));
    weighted.push_back(contact.pressure(middle + size * at.back()).to_double() * size * std::numbers::pi /
                       nodes * std::sin(angle));
  }
  const data::MaterialFunction compliance = nip.material.normal_compliance();
  double sum = 0;
  for (double root = step; root < last; root += step) {
    const double t = root * root, q = t / size, s = q * nip.half_thickness(), fade = std::exp(-2 * s);
    std::complex<double> transform = 0;
    for (std::size_t j = 0; j < at.size(); ++j) transform += weighted[j] * std::polar(1.0, -t * at[j]);
    sum += (1 - fade) * (1 - fade) / (1 - fade * fade + 4 * s * fade) * std::norm(transform) *
           -compliance.transform({0, q * nip.speed}).imag() * 2 * root * step / size;
  }
  return sum / std::numbers::pi;
}

/// A number of each contact.
struct RollingResult {
  const char* name;
  std::function<ref::Estimated(const ref::ConvergedViscoelasticNip&)> reference;
  std::function<fast::Estimate(const fast::ConvergedViscoelasticNip&)> computed;
};

/// Numbers, and profiles at these places.
std::vector<RollingResult> rolling_results(const std::vector<double>& places) {
  using Ref = ref::ConvergedViscoelasticNip;
  using Fast = fast::ConvergedViscoelasticNip;
  std::vector<RollingResult> results{
      {"contact_length", &Ref::contact_length, &Fast::contact_length},
      {"leading_length", &Ref::leading_length, &Fast::leading_length},
      {"trailing_length", &Ref::trailing_length, &Fast::trailing_length},
      {"load", &Ref::load, &Fast::load},
      {"indentation", &Ref::indentation, &Fast::indentation},
      {"leading_displacement", &Ref::leading_displacement, &Fast::leading_displacement},
      {"trailing_displacement", &Ref::trailing_displacement, &Fast::trailing_displacement},
      {"rolling_resistance", &Ref::rolling_resistance, &Fast::rolling_resistance},
      {"peak_pressure", &Ref::peak_pressure, &Fast::peak_pressure},
  };
  for (const double y : places) {
    results.push_back({"pressure", [y](const Ref& c) { return c.pressure(y); },
                       [y](const Fast& c) { return c.pressure(y); }});
    results.push_back({"normal_displacement", [y](const Ref& c) { return c.normal_displacement(y); },
                       [y](const Fast& c) { return c.normal_displacement(y); }});
  }
  return results;
}

void check_covered(const ref::ConvergedViscoelasticNip& truth, const fast::ConvergedViscoelasticNip& computed,
                   double length) {
  for (const auto& [name, reference, in_double] :
       rolling_results({-0.7 * length, -0.2 * length, 0.3 * length})) {
    CAPTURE(name);
    const ref::Estimated exact = reference(truth);
    const fast::Estimate estimate = in_double(computed);
    CAPTURE(exact.value_text());
    CAPTURE(estimate.value);
    CHECK(std::fabs(exact.error_of(estimate.value)) <= estimate.error);
  }
}

void check_rolling_refused(const std::function<void()>& solve, const std::string& start) {
  CAPTURE(start);
  try {
    solve();
    FAIL("accepted");
  } catch (const data::BadInput& error) {
    CAPTURE(error.what());
    CHECK(std::string(error.what()).starts_with(start));
  }
}

}  // namespace

TEST_CASE("ref rolling contact: the resistance is the energy that the sheet loses at all frequencies") {
  for (const double way : {0.02, 1.0}) {
    const ViscoelasticNip nip = rolled_nip(0.25, way, 0.8);
    const auto contact = ref::converged_for_length(nip, 0.1, 16);
    const double work = contact.load().to_double() * contact.rolling_resistance().to_double();
    CHECK(work > 0);
    CHECK(lost_energy(nip, contact) == doctest::Approx(work).epsilon(1e-6).scale(0));
  }
}

TEST_CASE("ref rolling contact: without memory it is the proven elastic contact") {
  const data::ElasticNip elastic = test::quarter_inch_nip;
  const double theta1 = (1 + elastic.material.poisson) / elastic.material.young;
  const double theta2 =
      (1 + elastic.material.poisson) * (1 - 2 * elastic.material.poisson) / elastic.material.young;
  const ViscoelasticNip nip{elastic.roller_radius, elastic.sheet_thickness,
                            data::ViscoelasticMaterial({theta1, {}}, {theta2, {}}), 1};
  const auto rolled = ref::converged_for_length(nip, 0.15, 20);
  const auto proven = ref::converged_for_length(elastic, 0.15, 30);
  const auto same = [](const ref::Estimated& mine, const ref::Enclosure& theirs) {
    ref::Real difference(200);
    mpfr_sub(difference.get(), mine.value.get(), theirs.value.get(), MPFR_RNDN);
    CHECK(mpfr_cmpabs(difference.get(), mine.error.get()) <= 0);
  };
  same(rolled.indentation(), proven.indentation());
  same(rolled.leading_displacement(), proven.edge_displacement());
  same(rolled.normal_displacement(0.2), proven.normal_displacement(0.2));
  CHECK(std::fabs(rolled.rolling_resistance().to_double()) <= 1e-20);
  // These go with the moduli, which are rounded.
  CHECK(std::fabs(proven.load().error_of(rolled.load().to_double())) <= 1e-15 * proven.load().to_double());
  CHECK(std::fabs(proven.peak_pressure().error_of(rolled.peak_pressure().to_double())) <=
        1e-15 * proven.peak_pressure().to_double());
}

TEST_CASE("ref rolling contact: the double path's estimates cover what they are off by at random nips") {
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<>()(random));
  };
  for (int i = 0; i < 6; ++i) {
    const double length = between(1e-3, 0.2);
    const ViscoelasticNip nip = rolled_nip(0.25, length * between(0.3, 1e5), between(0.1, 10));
    CAPTURE(length);
    const auto truth = ref::converged_for_length(nip, length, 16);
    check_covered(truth, fast::converged_for_length(nip, length, 1e-10), length);
  }
}

TEST_CASE("ref rolling contact: the length that a load needs gives it back, and more digits are covered") {
  const ViscoelasticNip nip = rolled_nip(0.25, 0.1, 2);
  const auto coarse = ref::converged_for_load(nip, 60, 16);
  CHECK(std::fabs(coarse.load().error_of(60)) <= 60e-16);
  const double length = coarse.contact_length().to_double();
  check_covered(coarse, fast::converged_for_load(nip, 60, 1e-10), length);
  const auto near = ref::converged_for_length(nip, 0.1, 16), fine = ref::converged_for_length(nip, 0.1, 25);
  for (const auto& result : rolling_results({-0.07, -0.02, 0.03})) {
    CAPTURE(result.name);
    const ref::Estimated first = result.reference(near), second = result.reference(fine);
    ref::Real difference(200);
    mpfr_sub(difference.get(), first.value.get(), second.value.get(), MPFR_RNDN);
    CHECK(mpfr_cmpabs(difference.get(), first.error.get()) <= 0);
    CHECK(mpfr_cmpabs(second.error.get(), first.error.get()) <= 0);
  }
  CHECK(fine.unknowns() > near.unknowns());
  CHECK(fine.kernel_values() > 0);
}

TEST_CASE("ref rolling contact: what it cannot give is refused by name") {
  const ViscoelasticNip nip = rolled_nip(0.25, 0.1, 2);
  check_rolling_refused([&] { (void)ref::converged_for_length(nip, 0.1, 15); }, "digits = 15: ");
  check_rolling_refused([&] { (void)ref::converged_for_length(nip, 3, 16); }, "contact_length = 3: ");
  check_rolling_refused([&] { (void)ref::converged_for_load(nip, -1, 16); }, "load = -1: ");
  check_rolling_refused([&] { (void)ref::converged_for_load(nip, 1e9, 16); }, "load = 1000000000: gives");
  check_rolling_refused([] { (void)ref::converged_for_length(rolled_nip(0.25, 1e-5, 1), 0.1, 16); },
                        "nip.material = ");
  const auto swinging = [](double compliance) {
    return data::MaterialFunction{compliance, {{compliance / 9, {1, 0.1}}, {compliance / 9, {1, -0.1}}}};
  };
  const ViscoelasticNip complex{6, 0.25, data::ViscoelasticMaterial(swinging(9e-6), swinging(3e-6)), 1};
  check_rolling_refused([&] { (void)ref::converged_for_length(complex, 0.1, 16); }, "nip.material = 0.1: ");
}
