#include <nipref/data/material/seed_solids.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/internal/impedance.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/number/internal/bracketed_root.hpp>

#include "support/intervals.hpp"
#include "support/test.hpp"

using namespace nipref;
using ref::Estimate;
using ref::Exact;
using ref::ExactStiffness;
using ref::Float;
using ref::SurfaceDirection;

namespace {

Float value(const Estimate& x) { return ref::at_working_precision(x.value); }
Float bound(const Estimate& x) { return ref::at_working_precision(x.error); }

ExactStiffness isotropic_stiffness(const data::IsotropicSolid& solid) {
  return ref::exact_stiffness(solid, data::SymmetryAxis::normal);
}

SurfaceDirection degrees(double angle) { return SurfaceDirection::of_degrees(Exact(angle)); }

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

/// The carbon fibre epoxy of brock2013 in units of the steel's shear modulus and density.
const data::TransverselyIsotropicSolid composite = [] {
  using namespace data::seed;
  return data::TransverselyIsotropicSolid{
      graphite_epoxy.c11 / steel.shear, graphite_epoxy.c33 / steel.shear,
      graphite_epoxy.c13 / steel.shear, graphite_epoxy.c44 / steel.shear,
      graphite_epoxy.c66 / steel.shear, graphite_epoxy.density / steel.density};
}();

}  // namespace

TEST_CASE("a proven impedance contains the one that is known better, and is not wide") {
  std::mt19937_64 generator(11);
  for (int sample = 0; sample < 5; ++sample) {
    const ExactStiffness solid = ref::exact_stiffness(random_solid(generator));
    const auto at = [&](mpfr_prec_t precision) {
      return ref::surface_impedance(
                 ref::acoustic_matrices(solid, degrees(71.5), ref::Interval(0.05, precision)))
          .value();
    };
    const auto rough = at(100);
    const auto fine = at(300);
    for (std::size_t k = 0; k < 9; ++k) {
      CHECK(is_inside(fine(k / 3, k % 3).re, rough(k / 3, k % 3).re));
      CHECK(is_inside(fine(k / 3, k % 3).im, rough(k / 3, k % 3).im));
      CHECK(width_of(rough(k / 3, k % 3).re) < 1e-14);
    }
  }
}

TEST_CASE("isotropic: the limiting speed is that of shear, the surface wave is Rayleigh's") {
  const ref::WorkingDigits working(60);
  for (const double poisson : {-0.3, 0.25, 0.45}) {
    CAPTURE(poisson);
    const auto solid = isotropic_stiffness({4, poisson, 1});
    const auto limit = ref::limiting_speed(solid, degrees(0), degrees(0), 30);
    CHECK(abs(value(limit) - 2) <= bound(limit));
    const auto wave = ref::surface_wave_speed(solid, degrees(0), degrees(53), 30);
    REQUIRE(wave.has_value());
    const auto cubic = [&](const Float& speed) {
      const Float x = pow(speed * cos(53 * ref::pi() / 180) / 2, 2);
      const Float inverse = (1 - 2 * Float(poisson)) / (2 - 2 * Float(poisson));
      return ((x - 8) * x + (24 - 16 * inverse)) * x - 16 * (1 - inverse);
    };
    CHECK(cubic(value(*wave) - bound(*wave)) < 0);
    CHECK(cubic(value(*wave) + bound(*wave)) > 0);
    CHECK(bound(*wave) < Float("1e-30"));
  }
}

TEST_CASE("bad stiffnesses, directions, digits and speeds are refused by name") {
  const auto good = data::Stiffness::of(composite, data::SymmetryAxis::normal);
  auto bad = good;
  bad.voigt[0][1] += 1e-9;
  CHECK_REFUSED(bad.check(), "stiffness = ");
  bad.voigt[0][1] = bad.voigt[1][0] = 2 * good.voigt[0][0];
  CHECK_REFUSED(bad.check(), "stiffness = ");
  bad = good;
  bad.voigt[3][3] = NAN;
  CHECK_REFUSED(ref::exact_stiffness(bad), "stiffness = nan");
  bad = good;
  bad.density = 0;
  CHECK_REFUSED(bad.check(), "density = 0");
  const auto solid = ref::exact_stiffness(good);
  const auto respond = [&](double speed, int digits) {
    return ref::line_response(solid, Exact(speed), degrees(0), degrees(0), digits);
  };
  CHECK_NOTHROW((void)respond(0.1, 20));
  CHECK_REFUSED(respond(5, 20), "speed = 5");
  CHECK_REFUSED(respond(0.1, 15), "digits = 15");
  CHECK_REFUSED(Exact(NAN, "speed"), "speed = nan");
  CHECK_REFUSED(ref::limiting_speed(solid, degrees(0), degrees(90), 20), "psi = ");
  CHECK_REFUSED(ref::surface_wave_speed(solid, degrees(0), degrees(90), 20), "psi = ");
  CHECK_REFUSED(ref::critical_speed(solid, degrees(0), 509), "digits = 509");
}

TEST_CASE("speeds are refused from the critical one on, on one line and on all") {
  const auto isotropic = ref::sagittal_stiffness(data::IsotropicSolid{1, 0.25, 1});
  const double rayleigh = ref::surface_wave_speed(isotropic, degrees(0), degrees(0), 20)->to_double();
  const auto check_line = [&](double speed, double psi) {
    ref::check_subcritical(isotropic, Exact(speed), degrees(0), degrees(psi));
  };
  CHECK_NOTHROW(check_line(std::nextafter(rayleigh, 0), 0));
  CHECK_REFUSED(check_line(std::nextafter(rayleigh, 1), 0), "must be below 0.919401686761966");
  CHECK_REFUSED(check_line(0.95, 0), "speed = 0.95: ");
  CHECK_NOTHROW(check_line(0.95, 60));
  CHECK_REFUSED(check_line(1.9, 60), "lines 60 degrees");
  CHECK_NOTHROW(check_line(1e6, 90));

  const auto lying = ref::exact_stiffness(composite, data::SymmetryAxis::in_plane);
  const auto check_all = [&](double share) {
    ref::check_subcritical(lying, Exact(share * 0.4989960517311832865), degrees(45));
  };
  CHECK_NOTHROW(check_all(1 - 1e-11));
  CHECK_REFUSED(check_all(1 + 1e-11), "psi = 24.55");
  CHECK_THROWS_AS(check_all(3), data::BadInput);
}

TEST_CASE("a search for a root of what is no number finds nothing") {
  const auto f = [](double x) { return x < 0.5 ? 1.0 : x > 0.7 ? -1.0 : std::nan(""); };
  CHECK(!ref::bracketed_root(f, 0.0, 1.0, 1e-12).has_value());
  CHECK(ref::bracketed_root([](double x) { return 0.3 - x * x; }, 0.0, 1.0, 1e-15).value() ==
        doctest::Approx(std::sqrt(0.3)).epsilon(1e-15));
}

TEST_CASE("surface waves next to the limiting speed and moduli powers of ten apart are proven") {
  const ref::WorkingDigits working(60);
  // For a solid that is stiff along the surface 1 - v/v_limit tends to C44^2/(2 C11 C33).
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
  // The moduli are so far apart that a double loses the smaller ones.
  const auto solid = ref::exact_stiffness(data::TransverselyIsotropicSolid{2e-60, 1e60, 0, 1e-60, 1e-60, 1},
                                          data::SymmetryAxis::in_plane);
  CHECK_REFUSED(ref::critical_speed(solid, degrees(30), 20), "solid = (as given): must be");
  // Here the rounding error of the largest modulus makes minima everywhere, so that the search would not end.
  const auto stiff = ref::exact_stiffness(
      data::TransverselyIsotropicSolid{1e16, 160.7, 6.44, 7.07, 3.5, 1688}, data::SymmetryAxis::in_plane);
  CHECK_REFUSED(ref::check_subcritical(stiff, Exact(0.01), degrees(0)),
                "solid = (as given): must have moduli nearer");
}

TEST_CASE("however near a direction whose limiting wave leaves the surface free a surface wave is found") {
  // In the isotropic plane of this solid the slowest wave is polarised across the plane. At an angle psi off the plane
  // the surface wave is slower than the limiting speed by a part of the order of psi^4.
  const data::TransverselyIsotropicSolid solid{452.1195822851164, 106.19561867964458, 16.527558334339567,
                                               75.78427765697768, 341.9812791367929,  0.9470167972555632};
  const ref::ExactStiffness stiffness =
      exact_stiffness(ref::ExactTransverse(solid), data::SymmetryAxis::in_plane);
  const ref::WorkingDigits working(60);
  const auto motion = ref::SurfaceDirection::of_degrees(ref::Exact(0.0));
  const auto slower_by = [&](double psi) {
    const auto line = ref::SurfaceDirection::of_degrees(ref::Exact(psi));
    const auto wave = ref::surface_wave_speed(stiffness, motion, line, 30);
    REQUIRE(wave.has_value());
    return static_cast<double>(1 - value(*wave) / value(ref::limiting_speed(stiffness, motion, line, 30)));
  };
  const double near = slower_by(0.01), nearer = slower_by(0.005);
  CHECK(near > 0);
  CHECK(near < 1e-14);
  CHECK(near / nearer == doctest::Approx(16).epsilon(1e-3));
}
