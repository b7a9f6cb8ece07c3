// The contact with full friction in multiprecision: against its own equations and closed limits.
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/nip/internal/nip_solution.hpp>
#include <nipref/ref/nip/internal/singular_integrals.hpp>
#include <nipref/ref/sheet/kernels.hpp>

#include "support/reference_values.hpp"
#include "support/test.hpp"
#include "support/thesis_nips.hpp"

using namespace nipref;
using ref::Float;
using ref::NipSolution;
using test::nip_of;

namespace {

/// Integral from 0 to 1 by double-exponential quadrature, to about 30 digits, of integrand(distance from 0, from 1).
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

/// The contact with full friction, by panels with a truncation error of e^-nats.
std::unique_ptr<NipSolution> gripped_solution(const ref::ElasticSheet& sheet, const Float& half_length,
                                              double nats, ref::SheetKernels& kernels) {
  return sheet.solved(half_length, ref::panels_of(half_length, sheet.resolution(), {1.3, 2, nats}), 100,
                      kernels);
}

/// The displacement at t inside the contact, by quadrature of the kernels' values times the tractions.
Displacement displacement_by_quadrature(const NipSolution& contact, const Float& beta, const Float& t) {
  const Float length = contact.half_length();
  Displacement sum{0, 0};
  const auto add = [&](const Float& width, bool leading) {
    const auto part = [&](bool tangential) {
      return [&, tangential](const Float& from_point, const Float& from_end) -> Float {
        const Float before_end = width * from_end;
        const bool is_beyond = before_end > 1;  // beyond the middle
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
      const Float tangential = contact.tangential(0) * t;
      CHECK(std::fabs(static_cast<double>(here.normal - normal)) < 1e-22);
      CHECK(std::fabs(static_cast<double>(here.tangential - tangential)) < 1e-22);
    }
  }
}

TEST_CASE("ref contact by panels: the singular integrals are those of a quadrature") {
  const ref::WorkingDigits working(40);
  const ref::ComplexFloat none, root(0.5), gripped(0.5, -0.17);
  for (const auto& [exponent, x] : {std::pair(none, 0.0),
                                    {none, -0.375},
                                    {none, 0.25},
                                    {none, 1.0},
                                    {none, 1.25},
                                    {root, 0.25},
                                    {root, 1.25},
                                    {gripped, -0.375},
                                    {gripped, 0.25},
                                    {gripped, 0.625},
                                    {gripped, 1.25}}) {
    const ref::SingularIntegrals integrals = ref::singular_integrals(exponent, Float(x), 12);
    // The integral between the singularities of the integrand.
    const auto integral = [&, &m = exponent, &x = x](int k, bool real, const auto& kernel) {
      const auto from_to = [&](double from, double to) {
        return unit_integral([&](const Float& left, const Float& right) -> Float {
          const Float width = to - from, t = from + width * left;
          const Float distance =
              x <= from ? Float((from - x) + width * left) : Float((x - to) + width * right);
          const Float phase = m.im * log(t);
          return width * exp(m.re * log(t)) * (real ? cos(phase) : sin(phase)) * cos(k * acos(2 * t - 1)) *
                 kernel(distance, x > from);
        });
      };
      return x > 0 && x < 1 ? Float(from_to(0, x) + from_to(x, 1)) : from_to(0, 1);
    };
    for (const int k : {0, 1, 2, 3, 10}) {
      CAPTURE(x, k);
      const auto check = [&](const ref::Matrix& found, const auto& kernel) {
        CHECK(std::fabs(static_cast<double>(found(k, 0) - integral(k, true, kernel))) < 1e-20);
        CHECK(std::fabs(static_cast<double>(found(k, 1) - integral(k, false, kernel))) < 1e-20);
      };
      check(integrals.plain, [](const Float&, bool) { return Float(1); });
      check(integrals.logarithm, [](const Float& distance, bool) { return Float(log(distance)); });
      check(integrals.sign, [](const Float&, bool before) { return Float(before ? 1 : -1); });
      if (x < 0 || x > 1) {
        check(integrals.inverse,
              [](const Float& distance, bool before) { return Float((before ? 1 : -1) / distance); });
      }
    }
  }
}

TEST_CASE("ref gripped contact: incompressible and thick it is the proven contact without friction") {
  const auto excess = [](double length) {
    const auto load = [&](data::Friction friction) {
      return ref::converged_for_length(nip_of(0.5), friction, length, 30).load();
    };
    const ref::Estimate free = load(data::Friction::none);
    return difference(load(data::Friction::full), free) / free.to_double();
  };
  // The linear part of I3 is a creep. The cubic part gives a shear of A^3 times the pressure, which changes the load by
  // a part A^6.
  CHECK(excess(1e-4) < 1e-15);
  const double here = excess(0.02);
  CHECK(here > 1e-13);
  CHECK(excess(0.01) / here == doctest::Approx(1.0 / 64).epsilon(0.02));
  const auto free = ref::converged_for_length(nip_of(0.5), data::Friction::none, 1e-5, 20);
  const auto gripped = ref::converged_for_length(nip_of(0.5), data::Friction::full, 1e-5, 20);
  CHECK(meet(gripped.pressure(2e-6), free.pressure(2e-6)));
  // The moment of the shear under the linear part of I3 displaces the whole surface by a part A^4.
  const double moved = 1e-20 * free.leading_displacement().to_double();
  CHECK(difference(gripped.leading_displacement(), free.leading_displacement()) <=
        moved + error(gripped.leading_displacement()) + error(free.leading_displacement()));
}
