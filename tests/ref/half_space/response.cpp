#include <nipref/data/material/seed_solids.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/internal/barnett_lothe.hpp>
#include <nipref/ref/half_space/internal/impedance.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/number/internal/bracketed_root.hpp>

#include "support/refusal.hpp"
#include "support/stroh.hpp"
#include "support/test.hpp"

using namespace nipref;
using ref::Enclosure;
using ref::Estimate;
using ref::Exact;
using ref::ExactStiffness;
using ref::LineResponse;
using ref::SurfaceDirection;
using stroh::Float;

namespace {

Float value(const Estimate& x) {
  Float result;
  mpfr_set(result.backend().data(), ref::raw(x.value), MPFR_RNDN);
  return result;
}

Float bound(const Estimate& x) {
  Float result;
  mpfr_set(result.backend().data(), ref::raw(x.error), MPFR_RNDN);
  return result;
}

std::vector<Enclosure> all(const LineResponse& x) {
  return {x.compliance, x.coupling, x.coupling_across, x.shear_compliance, x.shear_compliance_across,
          x.in_line,    x.across};
}

Float scale(const LineResponse& x) {
  return std::max(
      {Float(abs(value(x.compliance))), Float(abs(value(x.in_line))), Float(abs(value(x.across)))});
}

/// Every component within the sum of the bounds, and these as narrow as promised.
void check_agree(const LineResponse& x, const LineResponse& y, int digits, double factor = 1) {
  const auto a = all(x);
  const auto b = all(y);
  for (std::size_t k = 0; k < a.size(); ++k) {
    CAPTURE(k);
    CHECK(abs(value(a[k]) - factor * value(b[k])) <= bound(a[k]) + factor * bound(b[k]));
    CHECK(bound(a[k]) <= pow(Float(10), -digits) * scale(x));
  }
}

ExactStiffness isotropic_stiffness(const data::IsotropicSolid& solid) {
  return ref::exact_stiffness(solid, data::SymmetryAxis::normal);
}

SurfaceDirection degrees(double angle) { return SurfaceDirection::of_degrees(Exact(angle)); }
SurfaceDirection pair(double cosine, double sine) { return {Exact(cosine), Exact(sine)}; }

data::Stiffness random_solid(std::mt19937_64& generator) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::array<std::array<double, 6>, 6> root;  // the stiffness is root root^T + 0.3, positive definite
  for (auto& row : root) {
    for (double& entry : row) entry = uniform(generator);
  }
  data::Stiffness result{{}, 1 + 0.9 * uniform(generator)};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      const double product = std::inner_product(root[i].begin(), root[i].end(), root[k].begin(), 0.0);
      result.voigt[i][k] = result.voigt[k][i] = product + (i == k ? 0.3 : 0);
    }
  }
  return result;
}

/// The solid turned about x3 by the angle whose cosine and sine are given, exactly.
ExactStiffness turned(const ExactStiffness& solid, const mpq_class& cosine, const mpq_class& sine) {
  constexpr std::size_t voigt[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
  const mpq_class axes[3][3] = {{cosine, -sine, 0}, {sine, cosine, 0}, {0, 0, 1}};
  ExactStiffness result = solid;
  for (std::size_t n = 0; n < 81; ++n) {
    const std::size_t i = n / 27, j = n / 9 % 3, k = n / 3 % 3, l = n % 3;
    mpq_class sum = 0;
    for (std::size_t m = 0; m < 81; ++m) {
      const std::size_t p = m / 27, q = m / 9 % 3, r = m / 3 % 3, s = m % 3;
      sum += axes[i][p] * axes[j][q] * axes[k][r] * axes[l][s] * solid.voigt[voigt[p][q]][voigt[r][s]];
    }
    result.voigt[voigt[i][j]][voigt[k][l]] = sum;
  }
  return result;
}

/// The carbon fibre epoxy of brock2013 in units of the steel's shear modulus and density.
const data::TransverselyIsotropicSolid composite = [] {
  using namespace data::seed;
  return data::TransverselyIsotropicSolid{
      graphite_epoxy.c11 / steel.shear, graphite_epoxy.c33 / steel.shear,
      graphite_epoxy.c13 / steel.shear, graphite_epoxy.c44 / steel.shear,
      graphite_epoxy.c66 / steel.shear, graphite_epoxy.density / steel.density};
}();

}  // namespace

TEST_CASE("random anisotropic solids: Stroh's eigenvectors give the same response to 30 digits") {
  std::mt19937_64 generator(6);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int sample = 0; sample < 110; ++sample) {
    CAPTURE(sample);
    const ExactStiffness solid = ref::exact_stiffness(random_solid(generator));
    const double psi[] = {2 * uniform(generator) - 1, 2 * uniform(generator) - 1};
    const double theta[] = {2 * uniform(generator) - 1, 2 * uniform(generator) - 1};
    const auto line = pair(psi[0], psi[1]);
    const auto motion = pair(theta[0], theta[1]);
    const double speed = 0.98 * uniform(generator) * ref::limiting_speed(solid, motion, line, 16).to_double();
    const auto response = ref::line_response(solid, Exact(speed), motion, line, 30);
    const Float cosine = (Float(psi[0]) * theta[0] + Float(psi[1]) * theta[1]) /
                         sqrt((Float(psi[0]) * psi[0] + Float(psi[1]) * psi[1]) *
                              (Float(theta[0]) * theta[0] + Float(theta[1]) * theta[1]));
    const auto y = stroh::admittance(solid, Float(speed) * cosine, Float(psi[0]), Float(psi[1]));
    const Float by_roots[] = {y[2][2].real(), -y[2][0].imag(), -y[2][1].imag(), y[2][0].real(),
                              y[2][1].real(), y[0][0].real(),  y[1][1].real()};
    const auto components = all(response);
    for (std::size_t k = 0; k < components.size(); ++k) {
      CAPTURE(k);
      const Float rounding = Float("1e-45") * scale(response);
      CHECK(abs(value(components[k]) - by_roots[k]) <= bound(components[k]) + rounding);
      CHECK(bound(components[k]) <= Float("1e-30") * scale(response));
    }
    // Reciprocity.
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(abs(y[i][k] - conj(y[k][i])) < Float("1e-45") * scale(response));
      }
    }
  }
}

TEST_CASE("isotropic solids: the closed form, in every direction") {
  for (const double poisson : {-0.5, 0.0, 0.25, 0.3, 0.49}) {
    for (const double speed : {1e-9, 0.1, 0.7, 0.85, 0.97, 0.999999}) {
      CAPTURE(poisson);
      CAPTURE(speed);
      const data::IsotropicSolid solid{3.7, poisson, 3.7};
      const auto response =
          ref::line_response(isotropic_stiffness(solid), Exact(speed), pair(3, 4), pair(-8, 6), 30);
      // cos(psi - theta) = 0: as at rest.
      CHECK(abs(value(response.compliance) - (1 - Float(poisson)) / Float(3.7)) <=
            bound(response.compliance));
      const auto moving =
          ref::line_response(isotropic_stiffness(solid), Exact(speed), pair(3, 4), pair(6, 8), 30);
      const Float x = Float(speed) * speed;
      const Float squared_ratio = (2 - 2 * Float(poisson)) / (1 - 2 * Float(poisson));
      const Float shear = sqrt(1 - x);
      const Float pressure = sqrt(1 - x / squared_ratio);
      const Float rayleigh = (4 * shear * pressure - (x - 2) * (x - 2)) * Float(3.7);
      const Float expected[] = {
          x * pressure / rayleigh, (2 - x - 2 * shear * pressure) / rayleigh, 0, 0, 0, x * shear / rayleigh,
          1 / (shear * Float(3.7))};
      const auto components = all(moving);
      for (std::size_t k = 0; k < components.size(); ++k) {
        CAPTURE(k);
        CHECK(abs(value(components[k]) - expected[k]) <=
              bound(components[k]) + Float("1e-40") * scale(moving));
      }
    }
  }
}

TEST_CASE("at rest an isotropic surface answers with (1 - nu)/mu, whatever its units") {
  const data::IsotropicSolid steel{77.2e9, 0.25, 7860};
  const auto response =
      ref::line_response(isotropic_stiffness(steel), Exact(0.0), degrees(10), degrees(70), 50);
  const Float truth = Float(0.75) / Float(77.2e9);
  CHECK(abs(value(response.compliance) - truth) <= bound(response.compliance));
  CHECK(bound(response.compliance) <= Float("1e-50") * truth);
}

TEST_CASE("an isotropic solid is the same transversely isotropic solid with either axis") {
  const data::TransverselyIsotropicSolid as_transverse{3, 3, 1, 1, 1, 1};
  const auto isotropic = isotropic_stiffness({1, 0.25, 1});
  const auto reference = ref::line_response(isotropic, Exact(0.8), degrees(20), degrees(50), 30);
  for (const auto axis : {data::SymmetryAxis::normal, data::SymmetryAxis::in_plane}) {
    check_agree(ref::line_response(ref::exact_stiffness(as_transverse, axis), Exact(0.8), degrees(20),
                                   degrees(50), 30),
                reference, 30);
  }
}

TEST_CASE("solid, motion and line turned together change nothing, and directions need no norm") {
  std::mt19937_64 generator(7);
  const mpq_class cosine(5, 13);
  const mpq_class sine(12, 13);
  for (int sample = 0; sample < 5; ++sample) {
    const ExactStiffness solid = ref::exact_stiffness(random_solid(generator));
    const auto reference = ref::line_response(solid, Exact(0.2), pair(1, 0), pair(2, 1), 30);
    const SurfaceDirection turned_motion(Exact{mpq_class(cosine)}, Exact{mpq_class(sine)});
    const SurfaceDirection turned_line(Exact(mpq_class(2 * cosine - sine)),
                                       Exact(mpq_class(2 * sine + cosine)));
    check_agree(ref::line_response(turned(solid, cosine, sine), Exact(0.2), turned_motion, turned_line, 30),
                reference, 30);
    check_agree(ref::line_response(solid, Exact(-0.2), pair(1e-300, 0), pair(3e200, 1.5e200), 30), reference,
                30);
  }
  const auto solid = ref::exact_stiffness(random_solid(generator));
  check_agree(ref::line_response(solid, Exact(0.1), degrees(0), degrees(45), 30),
              ref::line_response(solid, Exact(0.1), pair(1, 0), pair(1, 1), 30), 30);
}

TEST_CASE("a line read backwards keeps its compliance and turns the sign of its coupling") {
  std::mt19937_64 generator(8);
  const ExactStiffness solid = ref::exact_stiffness(random_solid(generator));
  const auto there = ref::line_response(solid, Exact(0.2), pair(1, 0), pair(2, 1), 30);
  const auto back = ref::line_response(solid, Exact(0.2), pair(1, 0), pair(-2, -1), 30);
  CHECK(abs(value(there.compliance) - value(back.compliance)) <= 2 * bound(there.compliance));
  // tau turns its sign with n, and so does du3/dx: the coupling is left; the Hilbert transform turns, too.
  CHECK(abs(value(there.coupling) - value(back.coupling)) <= 2 * bound(there.compliance) * 100);
  CHECK(abs(value(there.shear_compliance) + value(back.shear_compliance)) <=
        2 * bound(there.compliance) * 100);
}

TEST_CASE("half the stiffness answers with twice the compliance") {
  std::mt19937_64 generator(9);
  const data::Stiffness stiff = random_solid(generator);
  data::Stiffness soft = stiff;
  soft.density /= 1048576;
  for (auto& row : soft.voigt) {
    for (double& modulus : row) modulus /= 1048576;
  }
  check_agree(ref::line_response(ref::exact_stiffness(soft), Exact(0.2), pair(1, 2), pair(2, 1), 30),
              ref::line_response(ref::exact_stiffness(stiff), Exact(0.2), pair(1, 2), pair(2, 1), 30), 30,
              1048576);
}

TEST_CASE("doubling steps are the trapezoidal rule of Barnett and Lothe's integrals") {
  std::mt19937_64 generator(10);
  const auto solid = random_solid(generator);
  const auto& c = solid.voigt;
  using Square = ref::DenseMatrix<double>;
  const auto matrix = [&](const int(&rows)[3], const int(&columns)[3]) {
    Square result(3, 3);
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k)
        result(i, k) = c[static_cast<std::size_t>(rows[i])][static_cast<std::size_t>(columns[k])];
    }
    return result;
  };
  const Square q = matrix({0, 5, 4}, {0, 5, 4}) - 0.02 * Square::Identity(3, 3);  // psi = 0
  const Square r = matrix({0, 5, 4}, {4, 3, 2});
  const Square t = matrix({4, 3, 2}, {4, 3, 2});
  Square s(3, 3), h(3, 3);
  constexpr int points = 512;
  for (int k = 0; k < points; ++k) {
    const double a = std::cos(std::numbers::pi * k / points);
    const double b = std::sin(std::numbers::pi * k / points);
    const Square rotated_t = b * b * q - a * b * (r + r.transpose()) + a * a * t;
    const Square rotated_r = -a * b * q + a * a * r - b * b * r.transpose() + a * b * t;
    h = h + rotated_t.inverse() / points;
    s = s - rotated_t.inverse() * rotated_r.transpose() / points;
  }
  const auto impedance = ref::barnett_lothe_impedance(q, r, t, 1e-8, 30);
  REQUIRE(impedance.has_value());
  const Square inverse = h.inverse();
  CHECK((impedance->re - inverse).squaredNorm() < 1e-22 * inverse.squaredNorm());
  CHECK((impedance->im - inverse * s).squaredNorm() < 1e-22 * inverse.squaredNorm());
}

TEST_CASE("a proven impedance contains the one that is known better, and is not wide") {
  std::mt19937_64 generator(11);
  for (int sample = 0; sample < 5; ++sample) {
    const ExactStiffness solid = ref::exact_stiffness(random_solid(generator));
    const auto at = [&](mpfr_prec_t precision) {
      return ref::surface_impedance(ref::acoustic_matrices(solid, pair(1, 3), ref::Interval(0.05, precision)))
          .value();
    };
    const auto rough = at(100);
    const auto fine = at(300);
    for (std::size_t k = 0; k < 9; ++k) {
      CHECK(mpfi_is_inside(fine(k / 3, k % 3).real.get(), rough(k / 3, k % 3).real.get()) > 0);
      CHECK(mpfi_is_inside(fine(k / 3, k % 3).imag.get(), rough(k / 3, k % 3).imag.get()) > 0);
      CHECK(mpfr_get_d(rough(k / 3, k % 3).real.upper(), MPFR_RNDU) -
                mpfr_get_d(rough(k / 3, k % 3).real.lower(), MPFR_RNDD) <
            1e-14);
    }
  }
}

TEST_CASE("isotropic: the limiting speed is that of shear, the surface wave is Rayleigh's") {
  for (const double poisson : {-0.3, 0.25, 0.45}) {
    CAPTURE(poisson);
    const auto solid = isotropic_stiffness({4, poisson, 1});
    const auto limit = ref::limiting_speed(solid, degrees(0), degrees(0), 30);
    CHECK(abs(value(limit) - 2) <= bound(limit));
    const auto wave = ref::surface_wave_speed(solid, pair(1, 0), pair(3, 4), 30);
    REQUIRE(wave.has_value());
    const auto cubic = [&](const Float& speed) {
      const Float x = pow(speed * Float(3) / 10, 2);  // cos(psi - theta) = 3/5
      const Float inverse = (1 - 2 * Float(poisson)) / (2 - 2 * Float(poisson));
      return ((x - 8) * x + (24 - 16 * inverse)) * x - 16 * (1 - inverse);
    };
    CHECK(cubic(value(*wave) - bound(*wave)) < 0);
    CHECK(cubic(value(*wave) + bound(*wave)) > 0);
    CHECK(bound(*wave) < Float("1e-30"));
  }
}

TEST_CASE("the compliance has its pole at the surface wave, and there is no response beyond the limit") {
  std::mt19937_64 generator(12);
  const ExactStiffness solid = ref::exact_stiffness(random_solid(generator));
  const auto wave = ref::surface_wave_speed(solid, pair(1, 0), pair(2, 1), 20);
  REQUIRE(wave.has_value());
  const auto compliance = [&](double speed) {
    return ref::line_response(solid, Exact(speed), pair(1, 0), pair(2, 1), 20).compliance.to_double();
  };
  CHECK(compliance(wave->to_double() * (1 - 1e-9)) > 1e6);
  CHECK(compliance(wave->to_double() * (1 + 1e-9)) < -1e6);
  const double limit = ref::limiting_speed(solid, pair(1, 0), pair(2, 1), 20).to_double();
  CHECK_NOTHROW(compliance(limit * (1 - 1e-14)));
  CHECK_THROWS_AS(compliance(limit * (1 + 1e-14)), data::BadInput);
}

TEST_CASE("the composite of brock2013: surface wave with the axis upright, critical speeds with it lying") {
  // The horizontally polarised waves of the upright solid are slower than its surface wave.
  const auto upright = ref::exact_stiffness(composite, data::SymmetryAxis::normal);
  CHECK(!ref::surface_wave_speed(upright, degrees(0), degrees(0), 20).has_value());
  CHECK(ref::limiting_speed(upright, degrees(0), degrees(0), 20).to_double() ==
        doctest::Approx(std::sqrt(composite.c66 / composite.density)).epsilon(1e-14));
  const auto sagittal = ref::sagittal_stiffness(composite);
  const auto wave = ref::surface_wave_speed(sagittal, degrees(0), degrees(60), 20);
  REQUIRE(wave.has_value());
  CHECK(wave->to_double() == doctest::Approx(2 * 0.63882964015).epsilon(1e-10));
  auto whole = ref::line_response(upright, Exact(0.4), degrees(0), degrees(30), 30);
  whole.across = ref::exact_zero(30);
  auto part = ref::line_response(sagittal, Exact(0.4), degrees(0), degrees(30), 30);
  part.across = ref::exact_zero(30);
  check_agree(whole, part, 30);
  const auto lying = ref::exact_stiffness(composite, data::SymmetryAxis::in_plane);
  CHECK(ref::limiting_speed(lying, degrees(45), degrees(45), 20).to_double() ==
        doctest::Approx(0.56459743).epsilon(2e-8));
  const auto along = ref::critical_speed(lying, degrees(0), 20);
  CHECK(along.speed.to_double() == doctest::Approx(0.428350).epsilon(1e-6));
  CHECK(std::fabs(along.psi_degrees) < 1e-6);
  const auto oblique = ref::critical_speed(lying, degrees(45), 20);
  CHECK(oblique.speed.to_double() == doctest::Approx(0.4989960517).epsilon(2e-10));
  CHECK(oblique.psi_degrees == doctest::Approx(45 - 20.441).epsilon(2e-5));
  for (const double aside : {-0.01, 0.01}) {
    const auto there = ref::surface_wave_speed(lying, degrees(45), degrees(oblique.psi_degrees + aside), 20);
    REQUIRE(there.has_value());
    CHECK(value(*there) > value(oblique.speed));
  }
}

TEST_CASE("data::Stiffness rounds what the exact stiffness holds") {
  const data::IsotropicSolid isotropic{2, 0.3, 5};
  const auto check_same = [](const data::Stiffness& rounded, const ExactStiffness& exact) {
    CHECK_NOTHROW(rounded.check());
    CHECK(rounded.density == exact.density.get_d());
    for (std::size_t k = 0; k < 36; ++k) {
      CHECK(rounded.voigt[k / 6][k % 6] ==
            doctest::Approx(exact.voigt[k / 6][k % 6].get_d()).epsilon(1e-14).scale(1e-14));
    }
  };
  check_same(data::Stiffness::of(isotropic), isotropic_stiffness(isotropic));
  for (const auto axis : {data::SymmetryAxis::normal, data::SymmetryAxis::in_plane}) {
    check_same(data::Stiffness::of(composite, axis), ref::exact_stiffness(composite, axis));
  }
  // The axis along x2: Young's direction is stiff there, and 13 is the isotropic plane.
  const auto lying = data::Stiffness::of(composite, data::SymmetryAxis::in_plane);
  CHECK(lying.voigt[1][1] == composite.c33);
  CHECK(lying.voigt[4][4] == composite.c66);
  CHECK(lying.voigt[0][2] == composite.c11 - 2 * composite.c66);
  CHECK(lying.voigt[0][1] == composite.c13);
}

TEST_CASE("bad stiffnesses, directions, digits and speeds are refused by one clear line") {
  const auto starts = [](const std::string& text, const std::string& with) {
    CAPTURE(text);
    CHECK(text.rfind(with, 0) == 0);
    CHECK(text.find('\n') == std::string::npos);
  };
  const auto good = data::Stiffness::of(composite, data::SymmetryAxis::normal);
  auto bad = good;
  bad.voigt[0][1] += 1e-9;
  starts(refusal_of([&] { bad.check(); }), "stiffness = ");
  bad = good;
  bad.voigt[0][1] = bad.voigt[1][0] = 2 * good.voigt[0][0];
  starts(refusal_of([&] { bad.check(); }), "stiffness = ");
  bad = good;
  bad.voigt[3][3] = NAN;
  starts(refusal_of([&] { ref::exact_stiffness(bad); }), "stiffness = nan");
  bad = good;
  bad.density = 0;
  starts(refusal_of([&] { bad.check(); }), "density = 0");
  starts(refusal_of([&] { pair(0, 0); }), "direction = ");
  const auto solid = ref::exact_stiffness(good);
  const auto respond = [&](double speed, int digits) {
    return refusal_of([&] { ref::line_response(solid, Exact(speed), degrees(0), degrees(0), digits); });
  };
  CHECK(respond(0.1, 20) == "accepted");
  starts(respond(5, 20), "speed = 5");
  starts(respond(0.1, 15), "digits = 15");
  starts(refusal_of([&] { Exact(NAN, "speed"); }), "speed = nan");
  starts(refusal_of([&] { ref::limiting_speed(solid, pair(1, 0), pair(0, 1), 20); }), "psi = ");
  starts(refusal_of([&] { ref::surface_wave_speed(solid, degrees(0), degrees(90), 20); }), "psi = ");
  starts(refusal_of([&] { ref::critical_speed(solid, degrees(0), 509); }), "digits = 509");
}

TEST_CASE("speeds are refused from the critical one on, on one line and on all") {
  const auto isotropic = ref::sagittal_stiffness(data::IsotropicSolid{1, 0.25, 1});
  const double rayleigh = ref::surface_wave_speed(isotropic, degrees(0), degrees(0), 20)->to_double();
  const auto check_line = [&](double speed, double psi) {
    ref::check_subcritical(isotropic, Exact(speed), degrees(0), degrees(psi));
  };
  CHECK_NOTHROW(check_line(std::nextafter(rayleigh, 0), 0));
  CHECK_THROWS_WITH_AS(check_line(std::nextafter(rayleigh, 1), 0),
                       doctest::Contains("must be below 0.919402"), data::BadInput);
  CHECK_THROWS_WITH_AS(check_line(0.95, 0), doctest::Contains("speed = 0.95: "), data::BadInput);
  CHECK_NOTHROW(check_line(0.95, 60));
  CHECK_THROWS_WITH_AS(check_line(1.9, 60), doctest::Contains("lines 60 degrees"), data::BadInput);
  CHECK_NOTHROW(check_line(1e6, 90));

  const auto lying = ref::exact_stiffness(composite, data::SymmetryAxis::in_plane);
  const auto check_all = [&](double share) {
    ref::check_subcritical(lying, Exact(share * 0.4989960517311832865), degrees(45));
  };
  CHECK_NOTHROW(check_all(1 - 1e-11));
  CHECK_THROWS_WITH_AS(check_all(1 + 1e-11), doctest::Contains("psi = 24.55"), data::BadInput);
  CHECK_THROWS_AS(check_all(3), data::BadInput);
}

TEST_CASE("a search for a root of what is no number finds nothing") {
  const auto f = [](double x) { return x < 0.5 ? 1.0 : x > 0.7 ? -1.0 : std::nan(""); };
  CHECK(!ref::bracketed_root(f, 0.0, 1.0, 1e-12).has_value());
  CHECK(ref::bracketed_root([](double x) { return 0.3 - x * x; }, 0.0, 1.0, 1e-15).value() ==
        doctest::Approx(std::sqrt(0.3)).epsilon(1e-15));
}

TEST_CASE("surface waves next to the limiting speed and moduli powers of ten apart are proven") {
  // Stiff along the surface: 1 - v/v_limit = C44^2/(2 C11 C33) in the limit.
  for (const double stiff : {1e7, 1e9}) {
    const auto solid =
        ref::sagittal_stiffness(data::TransverselyIsotropicSolid{stiff, 160.7, 6.44, 7.07, 3.5, 1});
    const auto wave = ref::surface_wave_speed(solid, degrees(0), degrees(0), 30);
    REQUIRE(wave.has_value());
    const Float limit = sqrt(Float(7.07));
    CHECK(static_cast<double>(1 - value(*wave) / limit) == approx(7.07 * 7.07 / (2 * stiff * 160.7), 1e-3));
  }
}

TEST_CASE("where no proof is found, that is said of the solid") {
  // Moduli so far apart that a double sees nothing of the smaller ones.
  const auto solid = ref::exact_stiffness(data::TransverselyIsotropicSolid{2e-60, 1e60, 0, 1e-60, 1e-60, 1},
                                          data::SymmetryAxis::in_plane);
  CHECK_THROWS_WITH_AS(ref::critical_speed(solid, degrees(30), 20),
                       doctest::Contains("solid = (as given): must be"), data::BadInput);
  // Here rounding of the largest makes valleys everywhere, of which there is no end.
  const auto stiff = ref::exact_stiffness(
      data::TransverselyIsotropicSolid{1e16, 160.7, 6.44, 7.07, 3.5, 1688}, data::SymmetryAxis::in_plane);
  CHECK_THROWS_WITH_AS(ref::check_subcritical(stiff, Exact(0.01), degrees(0)),
                       doctest::Contains("solid = (as given): must have moduli nearer"), data::BadInput);
}

TEST_CASE(
    "next to a direction whose limiting wave leaves the surface free the surface wave is found, however near") {
  // In the isotropic plane of this solid its slowest wave is polarised across it. Off that plane by psi the surface wave
  // is slower by a part of the order of psi^4.
  const data::TransverselyIsotropicSolid solid{452.1195822851164, 106.19561867964458, 16.527558334339567,
                                               75.78427765697768, 341.9812791367929,  0.9470167972555632};
  const ref::ExactStiffness stiffness =
      exact_stiffness(ref::ExactTransverse(solid), data::SymmetryAxis::in_plane);
  const auto motion = ref::SurfaceDirection::of_degrees(ref::Exact(0.0));
  const auto slower_by = [&](double psi) {
    const auto line = ref::SurfaceDirection::of_degrees(ref::Exact(psi));
    const auto wave = ref::surface_wave_speed(stiffness, motion, line, 30);
    REQUIRE(wave.has_value());
    return static_cast<double>(1 - Float(wave->value_text()) /
                                       Float(ref::limiting_speed(stiffness, motion, line, 30).value_text()));
  };
  const double near = slower_by(0.01), nearer = slower_by(0.005);
  CHECK(near > 0);
  CHECK(near < 1e-14);
  CHECK(near / nearer == doctest::Approx(16).epsilon(1e-3));
}
