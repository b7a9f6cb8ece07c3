// The contact with full friction in multiprecision: against its own equations, closed limits, the double path
// and itself.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/nip/internal/end_integrals.hpp>
#include <nipref/ref/nip/internal/nip_solution.hpp>
#include <nipref/ref/sheet/kernels.hpp>

#include "support/reference_values.hpp"

using namespace nipref;
using data::ElasticNip;
using ref::Float;
using ref::NipSolution;

namespace {

ElasticNip nip_of(double poisson, double thickness = 1, double radius = 1e3) {
  ElasticNip nip = data::seed::nip(thickness);
  nip.material.poisson = poisson;
  nip.roller_radius = radius;
  return nip;
}

/// Between 0 and 1 by double exponential quadrature, to some 30 digits: integrand(distance from 0, from 1).
template <class Integrand>
Float unit_integral(const Integrand& integrand) {
  const Float step = 0.0625;
  Float sum = 0;
  for (int i = -66; i <= 66; ++i) {
    const Float x = i * step;
    const Float growth = exp(ref::pi() * sinh(x));
    const Float left = growth / (1 + growth), right = 1 / (1 + growth);
    sum += step * ref::pi() * cosh(x) * left * right * integrand(left, right);
  }
  return sum;
}

Float kernel(ref::Enclosure (*function)(const ref::Exact&, int), const Float& alpha) {
  return ref::at_working_precision(function(ref::to_exact(alpha), 30).value);
}
Float shear_kernel(const Float& alpha) {
  return ref::at_working_precision(ref::I6(ref::to_exact(alpha), ref::Exact(1.0), 30).value);
}

struct Displacement {
  Float normal, tangential;
};

/// With full friction, by panels that leave out e^-nats.
std::unique_ptr<NipSolution> gripped_solution(const ref::ElasticSheet& sheet, const Float& half_length,
                                              double nats, ref::SheetKernels& kernels) {
  return sheet.solved(half_length, ref::panels_of(half_length, sheet.resolution(), {1.3, 2, nats}), 100,
                      kernels);
}

/// What the tractions do at t inside the contact, from the kernels' own values and nothing else.
Displacement displacement_by_quadrature(const NipSolution& contact, const Float& beta, const Float& t) {
  const Float length = contact.half_length();
  Displacement sum{0, 0};
  const auto add = [&](const Float& width, bool leading) {
    const auto part = [&](bool tangential) {
      return [&, tangential](const Float& from_point, const Float& from_end) -> Float {
        const Float before_end = width * from_end;
        const bool is_beyond = before_end > 1;  // of the middle
        const auto traction = contact.tractions(length * (is_beyond ? Float(2 - before_end) : before_end));
        const Float shear = leading == is_beyond ? Float(-traction.shear) : traction.shear;
        const Float alpha = length * width * from_point;
        const Float coupling = (leading ? -1 : 1) * (kernel(ref::I3, alpha) - beta * ref::pi() / 2);
        return tangential ? coupling * traction.pressure + shear_kernel(alpha) * shear
                          : kernel(ref::I1, alpha) * traction.pressure - coupling * shear;
      };
    };
    sum.normal += width * unit_integral(part(false));
    sum.tangential += width * unit_integral(part(true));
  };
  add(1 - t, true);
  add(1 + t, false);
  return {length * sum.normal / ref::pi(), length * sum.tangential / ref::pi()};
}

}  // namespace

TEST_CASE("ref gripped contact: its tractions displace the surface as the roller and the creep want it") {
  const ref::WorkingDigits working(50);
  ref::SheetKernels kernels(40);
  for (const double poisson : {0.3, -0.8}) {
    const Float beta = (1 - 2 * Float(poisson)) / (2 * (1 - Float(poisson)));
    const ref::ElasticSheet sheet(true, beta);
    const auto solved = gripped_solution(sheet, 0.75, 90, kernels);
    const NipSolution& contact = *solved;
    for (const double t : {0.9375, 0.25, -0.5}) {
      CAPTURE(t);
      const Displacement here = displacement_by_quadrature(contact, beta, t);
      const Float square = contact.half_length() * contact.half_length();
      const Float normal = contact.edge_displacement() + square * (1 - t * t);
      const Float tangential = contact.tangential(0, kernels) * t;
      CHECK(std::fabs(static_cast<double>(here.normal - normal)) < 1e-22);
      CHECK(std::fabs(static_cast<double>(here.tangential - tangential)) < 1e-22);
    }
  }
}

TEST_CASE("ref contact by panels: the integrals next to an end are those of a quadrature") {
  const ref::WorkingDigits working(40);
  const Float epsilon = 0.17;
  for (const double x : {-0.375, 0.25, 0.625, 1.25}) {
    const ref::EndIntegrals integrals(epsilon, Float(x), 12);
    // Between the places where the integrand is singular.
    const auto integral = [&](int k, bool real, const auto& kernel) {
      const auto from_to = [&](double from, double to) {
        return unit_integral([&](const Float& left, const Float& right) -> Float {
          const Float width = to - from, t = from + width * left;
          const Float distance =
              x <= from ? Float((from - x) + width * left) : Float((x - to) + width * right);
          const Float phase = epsilon * log(t);
          return width * sqrt(t) * (real ? cos(phase) : -sin(phase)) * cos(k * acos(2 * t - 1)) *
                 kernel(distance, x > from);
        });
      };
      return x > 0 && x < 1 ? Float(from_to(0, x) + from_to(x, 1)) : from_to(0, 1);
    };
    for (const int k : {0, 1, 2, 3, 10}) {
      CAPTURE(x);
      CAPTURE(k);
      const auto check = [&](const ref::ComplexFloat& found, const auto& kernel) {
        CHECK(std::fabs(static_cast<double>(found.re - integral(k, true, kernel))) < 1e-20);
        CHECK(std::fabs(static_cast<double>(found.im - integral(k, false, kernel))) < 1e-20);
      };
      check(integrals.plain(k), [](const Float&, bool) { return Float(1); });
      check(integrals.logarithm(k), [](const Float& distance, bool) { return Float(log(distance)); });
      check(integrals.sign(k), [](const Float&, bool before) { return Float(before ? 1 : -1); });
      if (x < 0 || x > 1) {
        check(integrals.inverse(k),
              [](const Float& distance, bool before) { return Float((before ? 1 : -1) / distance); });
      }
    }
  }
}

TEST_CASE("ref gripped contact: the load grows with the length as its ends say") {
  const ref::WorkingDigits working(50);
  ref::SheetKernels kernels(40);
  const Float beta = 0.4, step = 1e-6;
  const ref::ElasticSheet sheet(true, beta);
  const auto load = [&](const Float& length) {
    return log(gripped_solution(sheet, length, 80, kernels)->load());
  };
  const Float slope = (load(0.5 * (1 + step)) - load(0.5 * (1 - step))) / (2 * step);
  CHECK(std::fabs(static_cast<double>(slope / gripped_solution(sheet, 0.5, 80, kernels)->growth() - 1)) <
        1e-11);
}

TEST_CASE("ref gripped contact: a thick sheet is a half-space, load pi A^2 (1 + 4 e^2), creep -4 e A") {
  for (const double poisson : {0.25, -0.9, 0.45}) {
    const double length = 0x1p-20, epsilon = std::log(3 - 4 * poisson) / (2 * std::numbers::pi);
    const auto contact = ref::converged_for_length(nip_of(poisson), data::Friction::full, length, 20);
    const ElasticNip nip = nip_of(poisson);
    const double units = 0.25 / (2 * nip.roller_radius) * nip.material.young / (2 * (1 - poisson * poisson));
    const double load = std::numbers::pi * length * length * (1 + 4 * epsilon * epsilon) * units;
    CHECK(contact.load().to_double() == doctest::Approx(load).epsilon(1e-11));
    const double creep = -4 * epsilon * length * 0.5 / (2 * nip.roller_radius);
    CHECK(contact.creep_ratio().to_double() == doctest::Approx(creep).epsilon(4 * length / epsilon));
  }
}

TEST_CASE("ref gripped contact: incompressible and thick it is the proven contact without friction") {
  const auto excess = [](double length) {
    const ref::Float gripped =
        ref::converged_for_length(nip_of(0.5), data::Friction::full, length, 30).load().value;
    const ref::Float free =
        ref::converged_for_length(nip_of(0.5), data::Friction::none, length, 30).load().value;
    ref::Float result = ref::zero_of_bits(200);
    mpfr_sub(ref::raw(result), ref::raw(gripped), ref::raw(free), MPFR_RNDN);
    return mpfr_get_d(ref::raw(result), MPFR_RNDN) / mpfr_get_d(ref::raw(free), MPFR_RNDN);
  };
  // The linear part of I3 is a creep; the cubic one gives a shear of A^3 of the pressure, what that does to
  // the load is A^6 of it.
  CHECK(std::fabs(excess(1e-4)) < 1e-15);
  const double here = excess(0.02);
  CHECK(std::fabs(here) > 1e-13);
  CHECK(excess(0.01) / here == doctest::Approx(1.0 / 64).epsilon(0.02));
  const auto free = ref::converged_for_length(nip_of(0.5), data::Friction::none, 1e-5, 20);
  const auto gripped = ref::converged_for_length(nip_of(0.5), data::Friction::full, 1e-5, 20);
  CHECK(difference(gripped.pressure(2e-6), free.pressure(2e-6)) <=
        error(gripped.pressure(2e-6)) + error(free.pressure(2e-6)));
  CHECK(difference(gripped.leading_displacement(), free.leading_displacement()) <=
        error(gripped.leading_displacement()) + error(free.leading_displacement()));
}

TEST_CASE("ref gripped contact: in the middle of a long one the sheet is compressed and stretched evenly") {
  const double poisson = 0.3;
  const auto excess = [&](double length) {
    const ElasticNip nip = nip_of(poisson);
    const auto contact = ref::converged_for_length(nip, data::Friction::full, length, 16);
    const double modulus = nip.material.young / ((1 + poisson) * (1 - 2 * poisson));
    const double strain = contact.indentation().to_double() / (nip.sheet_thickness / 2);
    const double pressure = modulus * ((1 - poisson) * strain - poisson * contact.creep_ratio().to_double());
    return contact.pressure(0).to_double() / pressure - 1;
  };
  // Curvature changes it by the square of the thickness over the length.
  const double here = excess(6);
  CHECK(std::fabs(here) < 0.03);
  CHECK(here / excess(3) == doctest::Approx(0.25).epsilon(0.1));
}

namespace {

struct GrippedResult {
  const char* name;
  std::function<ref::Estimate(const ref::ConvergedNip&)> reference;
  std::function<fast::Estimate(const fast::ConvergedNip&)> computed;
};

template <class Contact>
auto at(auto(Contact::*result)(double) const, double y) {
  return [=](const Contact& contact) { return (contact.*result)(y); };
}

std::vector<GrippedResult> gripped_results(double inside, double outside) {
  using Ref = ref::ConvergedNip;
  using Fast = fast::ConvergedNip;
  return {{"length", &Ref::contact_length, &Fast::contact_length},
          {"load", &Ref::load, &Fast::load},
          {"indentation", &Ref::indentation, &Fast::indentation},
          {"edge displacement", &Ref::leading_displacement, &Fast::leading_displacement},
          {"creep", &Ref::creep_ratio, &Fast::creep_ratio},
          {"peak pressure", &Ref::peak_pressure, &Fast::peak_pressure},
          {"peak shear", &Ref::peak_shear, &Fast::peak_shear},
          {"pressure", at(&Ref::pressure, inside), at(&Fast::pressure, inside)},
          {"shear", at(&Ref::shear, -inside), at(&Fast::shear, -inside)},
          {"u inside", at(&Ref::normal_displacement, inside), at(&Fast::normal_displacement, inside)},
          {"v inside", at(&Ref::tangential_displacement, inside), at(&Fast::tangential_displacement, inside)},
          {"u outside", at(&Ref::normal_displacement, outside), at(&Fast::normal_displacement, outside)},
          {"v outside", at(&Ref::tangential_displacement, -outside),
           at(&Fast::tangential_displacement, -outside)}};
}

}  // namespace

TEST_CASE("ref gripped contact: next to its end the strain outside is the creep, and as sure as far away") {
  constexpr double per_root =
      10;  // tractions that end like a root of the distance strain what is next to them likewise
  for (const double length : {0.01, 3.0}) {
    const ElasticNip nip = nip_of(0.3);
    const auto contact = ref::converged_for_length(nip, data::Friction::full, length, 16);
    const auto panels = fast::converged_for_length(nip, data::Friction::full, length, 1e-12);
    const double size = length / nip.roller_radius;
    for (const double beyond : {0x1p-45, 1e-10, 1e-5, 0.1, 4.0}) {
      CAPTURE(length);
      CAPTURE(beyond);
      const double y = length / 2 * (1 + beyond);
      const ref::Estimate strain = contact.surface_strain(y);
      const double error = mpfr_get_d(ref::raw(strain.error), MPFR_RNDU);
      CHECK(error <= 1e-16 * size);
      CHECK(std::fabs(strain.to_double() - contact.creep_ratio().to_double()) <=
            per_root * std::sqrt(beyond) * size);
      const fast::Estimate found = panels.surface_strain(y);
      CHECK(std::fabs(strain.error_of(found.value)) <= found.error + error);
    }
  }
}

TEST_CASE("ref gripped contact: the double path's estimates cover its distance at random nips") {
  std::mt19937_64 generator(11);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(generator() >> 11) * 0x1p-53;
  };
  for (int i = 0; i < 24; ++i) {
    const double poisson = i % 6 == 0 ? 0.5 : between(-0.9, 0.4999), thickness = std::exp(between(-1, 1));
    const double length = thickness * std::exp(between(std::log(1e-6), std::log(2)));
    const ElasticNip nip = nip_of(poisson, thickness, 100 * thickness);
    const double accuracy = std::pow(10, -between(3, 11));
    CAPTURE(poisson);
    CAPTURE(length / thickness);
    const auto computed = fast::converged_for_length(nip, data::Friction::full, length, accuracy);
    const auto check = [&](const ref::ConvergedNip& truth, const fast::ConvergedNip& here) {
      for (const GrippedResult& result : gripped_results(0.3 * length, 0.7 * length)) {
        CAPTURE(result.name);
        const fast::Estimate estimate = result.computed(here);
        CHECK(std::fabs(result.reference(truth).error_of(estimate.value)) <=
              estimate.error + 1e-16 * std::fabs(estimate.value));
      }
    };
    check(ref::converged_for_length(nip, data::Friction::full, length, 20), computed);
    if (i % 4 != 0) continue;
    const double load = computed.load().value;
    check(ref::converged_for_load(nip, data::Friction::full, load, 20),
          fast::converged_for_load(nip, data::Friction::full, load, accuracy));
  }
}

TEST_CASE("ref gripped contact: more digits stay within the error, of a length and of a load") {
  const ElasticNip nip = nip_of(0.1);
  const auto check = [&](const ref::ConvergedNip& coarse, const ref::ConvergedNip& fine) {
    for (const GrippedResult& result : gripped_results(0.29, 0.8)) {
      CAPTURE(result.name);
      const ref::Estimate rough = result.reference(coarse), good = result.reference(fine);
      CHECK(difference(rough, good) <= error(rough));
      CHECK(error(good) < 1e-10 * error(rough) + 1e-300);
    }
    CHECK(fine.unknowns() > coarse.unknowns());
    CHECK(fine.normal_values() > coarse.normal_values());
    CHECK(fine.coupling_values() > coarse.coupling_values());
    CHECK(fine.stretch_values() > coarse.stretch_values());
  };
  check(ref::converged_for_length(nip, data::Friction::full, 0.75, 16),
        ref::converged_for_length(nip, data::Friction::full, 0.75, 30));
  check(ref::converged_for_load(nip, data::Friction::full, 20, 16),
        ref::converged_for_load(nip, data::Friction::full, 20, 30));
}

TEST_CASE("ref gripped contact: from a length to its load and back") {
  const ElasticNip nip = nip_of(0.3);
  for (const double length : {0x1p-10, 1.5}) {
    const double load = ref::converged_for_length(nip, data::Friction::full, length, 20).load().to_double();
    const auto back = ref::converged_for_load(nip, data::Friction::full, load, 20);
    CHECK(std::fabs(back.contact_length().error_of(length)) < 2e-16 * length);
    CHECK(std::fabs(back.load().error_of(load)) <= error(back.load()));
  }
}

TEST_CASE("ref gripped contact: lengths and moduli scale") {
  ElasticNip larger = nip_of(0.2, 3, 3e3);
  larger.material.young *= 7;
  const auto one = ref::converged_for_length(nip_of(0.2), data::Friction::full, 0.5, 20),
             three = ref::converged_for_length(larger, data::Friction::full, 1.5, 20);
  const auto ratio = [](const ref::Estimate& x, const ref::Estimate& y) {
    return y.to_double() / x.to_double();
  };
  CHECK(ratio(one.load(), three.load()) == doctest::Approx(21).epsilon(1e-15));
  CHECK(ratio(one.shear(0.125), three.shear(0.375)) == doctest::Approx(7).epsilon(1e-15));
  CHECK(ratio(one.creep_ratio(), three.creep_ratio()) == doctest::Approx(1).epsilon(1e-15));
  CHECK(ratio(one.normal_displacement(0.375), three.normal_displacement(1.125)) ==
        doctest::Approx(3).epsilon(1e-15));
}

TEST_CASE("ref gripped contact: tractions end with the contact, and what is out of its domain is refused") {
  const ElasticNip nip = nip_of(0.3);
  const auto contact = ref::converged_for_length(nip, data::Friction::full, 0.5, 16);
  CHECK(error(contact.pressure(0.25)) == 0);
  CHECK(contact.shear(-0.3).to_double() == 0);
  CHECK(contact.shear(-0.1).to_double() == -contact.shear(0.1).to_double());
  CHECK(contact.shear(0).to_double() == 0);
  CHECK(contact.tangential_displacement(-0.4).to_double() ==
        -contact.tangential_displacement(0.4).to_double());
  // The displacements go on steadily beyond the end, by quadrature there and in closed form before it.
  const double end = 0.25 + 0x1p-40;
  const double creep = contact.creep_ratio().to_double();
  CHECK(contact.normal_displacement(end).to_double() ==
        doctest::Approx(contact.leading_displacement().to_double()).epsilon(1e-11));
  CHECK(contact.tangential_displacement(end).to_double() == doctest::Approx(creep * 0.25).epsilon(1e-6));
  CHECK_THROWS_AS((void)contact.pressure(NAN), data::BadInput);
  CHECK_THROWS_AS((void)contact.normal_displacement(451), data::BadInput);
  CHECK_THROWS_AS((void)ref::converged_for_length(nip, data::Friction::full, 0.5, 15), data::BadInput);
  CHECK_THROWS_AS((void)ref::converged_for_length(nip, data::Friction::full, 0.5, 101), data::BadInput);
  CHECK_THROWS_AS((void)ref::converged_for_length(nip, data::Friction::full, 1e-9, 16), data::BadInput);
  CHECK_THROWS_AS((void)ref::converged_for_length(nip, data::Friction::full, 1001, 16), data::BadInput);
  CHECK_THROWS_AS((void)ref::converged_for_load(nip, data::Friction::full, 0, 16), data::BadInput);
  CHECK_THROWS_AS((void)ref::converged_for_load(nip, data::Friction::full, 1e300, 16), data::BadInput);
  CHECK_THROWS_AS((void)ref::converged_for_load(nip, data::Friction::full, NAN, 16), data::BadInput);
}

TEST_CASE("ref contact by panels: without friction it is the proven one, thick and thin") {
  for (const double length : {0x1p-10, 1.5, 26.0}) {
    CAPTURE(length);
    const ElasticNip nip = nip_of(0.3);
    const auto proven = ref::converged_for_length(nip, data::Friction::none, length, 20);
    const auto panels = ref::converged_for_length(nip, data::Friction::none, length, 18, 0);
    const auto check = [](const ref::Estimate& found, const ref::Estimate& truth) {
      CHECK(difference(found, truth) <= error(found) + error(truth));
      CHECK(error(found) <= 1e-17 * std::fabs(truth.to_double()));
    };
    check(panels.load(), proven.load());
    check(panels.indentation(), proven.indentation());
    check(panels.creep_ratio(), proven.creep_ratio());
    check(panels.peak_pressure(), proven.peak_pressure());
    check(panels.pressure(length / 4), proven.pressure(length / 4));
    const double outside = 0.75 * length;
    if (length < 2) check(panels.normal_displacement(outside), proven.normal_displacement(outside));
    check(panels.tangential_displacement(outside), proven.tangential_displacement(outside));
    check(panels.surface_strain(length / 8), proven.surface_strain(length / 8));
    CHECK(panels.shear(length / 4).to_double() == 0);
    CHECK_THROWS_WITH_AS((void)panels.peak_shear_position(), doctest::Contains("must be full"),
                         data::BadInput);
  }
}

TEST_CASE("ref contact by panels: as long as the double path's, to a thousand sheet thicknesses") {
  const ElasticNip nip{2500, 2, {3, 0.4}};
  for (const double length : {120.0, 2000.0}) {
    CAPTURE(length);
    const auto truth = ref::converged_for_length(nip, data::Friction::full, length, 16);
    const auto found = fast::converged_for_length(nip, data::Friction::full, length, 1e-12);
    const auto check = [](const ref::Estimate& one, const fast::Estimate& other) {
      CHECK(std::fabs(one.error_of(other.value)) <= other.error + error(one));
      CHECK(error(one) <= 1e-15 * std::fabs(other.value));
    };
    check(truth.load(), found.load());
    check(truth.indentation(), found.indentation());
    check(truth.creep_ratio(), found.creep_ratio());
    check(truth.peak_pressure(), found.pressure(0));
    check(truth.peak_shear(), found.peak_shear());
    check(truth.peak_shear_position(), found.peak_shear_position());
  }
}
