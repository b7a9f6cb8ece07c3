// Limits of the converged contact, each derived apart from the solver, and approached at the rate of the
// first term left out. Dimensionless as in fast/nip/internal/solved_nip.hpp.
#include <boost/math/quadrature/exp_sinh.hpp>

#include <nipref/fast/elastic_nip/internal/elastic_equations.hpp>
#include <nipref/fast/nip/internal/solved_nip.hpp>
#include <nipref/fast/sheet/kernels.hpp>

#include "support/test.hpp"

using namespace nipref;
using data::Friction;

namespace {

constexpr double pi = std::numbers::pi;

struct Contact {
  fast::SolvedNip solved;

  [[nodiscard]] double half_length() const { return solved.half_length(); }
  [[nodiscard]] fast::Estimate load() const { return solved.estimate(&fast::Solution::load); }
  [[nodiscard]] double edge_displacement() const {
    return solved.last().unknown(fast::ElasticEquations::edge_displacement);
  }
  [[nodiscard]] double indentation() const { return edge_displacement() + half_length() * half_length(); }
  [[nodiscard]] double creep() const { return solved.last().unknown(fast::ElasticEquations::creep_ratio); }
  [[nodiscard]] double pressure(double e) const { return solved.last().traction(e).real(); }
  [[nodiscard]] double shear(double e) const { return solved.last().traction(e).imag(); }
};

Contact solve(double half_length, Friction friction, double poisson = 1.0 / 3) {
  return {{std::make_shared<const fast::ElasticEquations>(friction, poisson), half_length, {}, 1e-13}};
}

/// P'(A/2) by a central difference: the pressure is smooth there.
double slope_at_half(const Contact& contact) {
  const double step = 1e-3 * contact.half_length();
  const double e = contact.half_length() / 2;
  return -(contact.pressure(e + step) - contact.pressure(e - step)) / (2 * step);
}

/// Order q of an error that falls like size^q, from its values at `size` and `size`/2 (or 2 `size` upwards).
double order(double error, double error_at_half) { return std::log2(std::fabs(error / error_at_half)); }

}  // namespace

TEST_CASE("thick sheet without friction: Hertz, and the indentation's logarithm") {
  // I1(a) = -ln a - c + O(a^2), so P = 2 sqrt(A^2 - y^2), W = pi A^2, D = A^2 (ln(2/A) + 1/2 - c).
  const double a = 1e-9;
  const double c = -(fast::I1(a) + std::log(a));
  const auto hertz = [&](double half_length) {
    const Contact contact = solve(half_length, Friction::none);
    const double square = half_length * half_length;
    return std::array{contact.load().value / (pi * square) - 1,
                      contact.indentation() / square - (std::log(2 / half_length) + 0.5 - c),
                      contact.pressure(half_length) / (2 * half_length) - 1,
                      contact.pressure(half_length / 5) / (2 * half_length * 0.6) - 1};
  };
  for (const double error : hertz(1e-6)) CHECK(std::fabs(error) < 1e-11);
  const auto coarse = hertz(0.04), fine = hertz(0.02);
  for (const std::size_t i : {0U, 2U, 3U}) CHECK(order(coarse[i], fine[i]) == approx(2, 0.02));
  // A^2 ln A: the load's correction times the logarithm.
  CHECK(order(coarse[1], fine[1]) == approx(2 - std::log2(std::log(50) / std::log(25)), 0.1));
}

TEST_CASE("thick sheet without slip: the oscillating half-space solution in closed form") {
  // On a half-space the coupled equation takes P + iQ = K (1 - t)^(1/2 - i eps) (1 + t)^(1/2 + i eps) to a
  // linear function, whose solvability makes the creep X = -4 eps A.
  for (const double poisson : {-0.9, 0.0, 1.0 / 3, 0.49, 0.5}) {
    const double epsilon = std::log(3 - 4 * poisson) / (2 * pi);
    const double half_length = 1e-7;
    const Contact contact = solve(half_length, Friction::full, poisson);
    CHECK(std::fabs(contact.creep() / half_length + 4 * epsilon) < 1e-6);
    const double middle = contact.pressure(half_length);
    for (const double t : {0.1, 0.5, 0.9, 0.999, 1 - 1e-6}) {
      CAPTURE(poisson);
      CAPTURE(t);
      const double phase = -epsilon * std::log((1 - t) / (1 + t));
      const double size = middle * std::sqrt((1 - t) * (1 + t));
      CHECK(std::fabs(contact.pressure(half_length * (1 - t)) / size - std::cos(phase)) < 3e-7);
      CHECK(std::fabs(contact.shear(half_length * (1 - t)) / size - std::sin(phase)) < 3e-7);
    }
  }
}

TEST_CASE("thin sheet without friction: independent springs, with the Wiener-Hopf edge correction") {
  // G(0) = 1/2: P = 2 u away from the ends. At an end the half-line problem leaves u = 2 A kappa, kappa =
  // (1/pi) int -ln(2 G(z))/z^2 dz, so that W = 8 A^3/3 + 8 kappa A^2 + O(A).
  boost::math::quadrature::exp_sinh<double> quadrature;
  const auto integrand = [](double z) {
    if (z < 1e-2) return z * z / 45;  // -ln(2 G) = z^4/45 + O(z^6)
    // 2 G = 4 sinh^2 z/(z (sinh 2z + 2z)), numerator and denominator times e^(-2z)
    const double sinh_square = std::pow(-std::expm1(-2 * z), 2);
    const double denominator = z * (-std::expm1(-4 * z) / 2 + 2 * z * std::exp(-2 * z));
    return -std::log(sinh_square / denominator) / (z * z);
  };
  const double kappa = quadrature.integrate(integrand) / pi;
  const auto edge = [&](double half_length) {
    return solve(half_length, Friction::none).edge_displacement() / (2 * half_length) - kappa;
  };
  const auto load = [&](double half_length) {
    return solve(half_length, Friction::none).load().value / std::pow(half_length, 2) - 8 * half_length / 3 -
           8 * kappa;
  };
  CHECK(std::fabs(edge(1e4)) < 1e-4);
  CHECK(std::fabs(load(1e4)) < 1e-3);
  CHECK(order(edge(100), edge(200)) == approx(1, 0.01));
  CHECK(order(load(100), load(200)) == approx(1, 0.01));
  const Contact contact = solve(500, Friction::none);
  const double u = contact.indentation() - 250 * 250;
  // G(z) has no z^2: springs are exact for a parabola.
  CHECK(contact.pressure(250) == approx(2 * u, 1e-10));
  CHECK(slope_at_half(contact) == approx(-4 * 250, 1e-9));
}

TEST_CASE("thin compressible sheet without slip: confined springs and the shear that their slope needs") {
  // P = 2 (1 - nu)^2/(1 - 2 nu) u, Q = nu/(1 - nu) P', W = (4/3) of that modulus A^3 to first order.
  for (const double poisson : {-0.9, 0.0, 1.0 / 3}) {
    CAPTURE(poisson);
    const double modulus = 2 * std::pow(1 - poisson, 2) / (1 - 2 * poisson);
    const auto excess = [&](double half_length) {
      return solve(half_length, Friction::full, poisson).load().value /
                 (4 * modulus / 3 * std::pow(half_length, 3)) -
             1;
    };
    CHECK(std::fabs(excess(1000)) < 3e-3);
    CHECK(order(excess(100), excess(200)) == approx(1, 0.03));
    const Contact contact = solve(300, Friction::full, poisson);
    CHECK(slope_at_half(contact) == approx(-modulus * 300, 1e-8));
    const double shear = poisson / (1 - poisson) * slope_at_half(contact);
    CHECK(std::fabs(contact.shear(150) - shear) < 1e-8 * modulus * 300);
  }
}

TEST_CASE("thin incompressible sheet without slip: a squeezed film, P = (A^2 - y^2)^2/8") {
  // (2/3) P'' = X - D + y^2 from the parabolic profile across the film, P = P' = 0 at the ends.
  const auto excess = [&](double half_length) {
    const Contact contact = solve(half_length, Friction::full, 0.5);
    return std::array{contact.load().value / (2 * std::pow(half_length, 5) / 15) - 1,
                      contact.pressure(half_length) / (std::pow(half_length, 4) / 8) - 1,
                      contact.pressure(half_length / 2) / (9 * std::pow(half_length, 4) / 128) - 1,
                      (contact.indentation() - contact.creep()) / std::pow(half_length, 2) * 3 - 1};
  };
  for (const double error : excess(1000)) CHECK(std::fabs(error) < 4e-3);
  const auto thick = excess(100), thin = excess(200);
  for (const std::size_t i : {0U, 1U, 2U}) CHECK(order(thick[i], thin[i]) == approx(1, 0.1));
}

TEST_CASE("pressure with full friction is the frictionless one where the coupling vanishes") {
  // Incompressible: the coupling is smooth. What of it is linear in the distance stretches the sheet evenly,
  // which the creep takes up; the cubic rest acts from pressure to shear and back: A^6.
  const auto load = [](const Contact& contact) { return contact.load(); };
  const auto difference = [&](double half_length) {
    return load(solve(half_length, Friction::full, 0.5)).value /
               load(solve(half_length, Friction::none)).value -
           1;
  };
  const auto full = load(solve(1e-4, Friction::full, 0.5)), none = load(solve(1e-4, Friction::none));
  CHECK(std::fabs(full.value - none.value) <= full.error + none.error);
  CHECK(full.error + none.error < 1e-12 * none.value);
  CHECK(order(difference(0.16), difference(0.08)) == approx(6, 0.02));
  const auto with = solve(1e-3, Friction::full, 0.5), without = solve(1e-3, Friction::none);
  for (const double x : {0.01, 0.3, 0.9}) {
    CHECK(with.pressure(x * 1e-3) == approx(without.pressure(x * 1e-3), 1e-10));
  }
}
