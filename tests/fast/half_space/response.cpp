// Half-spaces under loads that move steadily: multiprecision, the reference, limits, critical speeds.
#include <Eigen/Eigenvalues>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/response.hpp>

#include "support/refusal.hpp"
#include "support/test.hpp"

using namespace nipref;
using data::IsotropicSolid;
using data::SymmetryAxis;
using data::TransverselyIsotropicSolid;
using fast::Direction;
using fast::LineResponse;
using fast::TransverselyIsotropicHalfSpace;

namespace {

using Real = boost::multiprecision::mpfr_float_100;

constexpr double ulp = std::numeric_limits<double>::epsilon();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double degree = std::numbers::pi / 180;

/// The formulas of the isotropic surface as they are written, mu = 1.
struct IsotropicLine {
  Real X, wS, wD, R;
  IsotropicLine(double poisson, double speed, double cosine)
      : X(pow(Real(speed) * cosine, 2)),
        wS(sqrt(1 - X)),
        wD(sqrt(1 - X * (1 - 2 * Real(poisson)) / (2 - 2 * Real(poisson)))),
        R(4 * wS * wD - pow(2 - X, 2)) {}
};

double deviation(double value, const Real& exact) {
  return static_cast<double>(abs(value / exact - 1)) / ulp;
}

// Pa, where the seed has GPa
const double unit_speed = std::sqrt(1e9 * data::seed::steel.shear / data::seed::steel.density);

constexpr TransverselyIsotropicSolid graphite_epoxy{
    1e9 * data::seed::graphite_epoxy.c11, 1e9 * data::seed::graphite_epoxy.c33,
    1e9 * data::seed::graphite_epoxy.c13, 1e9 * data::seed::graphite_epoxy.c44,
    1e9 * data::seed::graphite_epoxy.c66, data::seed::graphite_epoxy.density};

/// lambda = mu: every modulus and Poisson's ratio are doubles.
constexpr TransverselyIsotropicSolid isotropic_moduli{3, 3, 1, 1, 1, 1};

TransverselyIsotropicSolid random_solid(std::mt19937_64& generator) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto factor = [&](double octaves) { return std::exp2(octaves * (unit(generator) - 0.5)); };
  TransverselyIsotropicSolid solid{};
  solid.density = factor(2);
  solid.c44 = factor(4);
  solid.c66 = factor(4);
  solid.c11 = solid.c66 * (1 + factor(4));
  solid.c33 = solid.c11 * factor(5);
  solid.c13 = (2 * unit(generator) - 1) * 0.99 * std::sqrt((solid.c11 - solid.c66) * solid.c33);
  return solid;
}

Direction random_direction(std::mt19937_64& generator) {
  return Direction::of_angle(std::uniform_real_distribution<double>(-4, 4)(generator));
}

/// With what answers to pressure, and to shear along the lines.
ref::ExactStiffness exactly(const TransverselyIsotropicSolid& solid, SymmetryAxis axis) {
  return axis == SymmetryAxis::normal ? ref::sagittal_stiffness(solid) : ref::exact_stiffness(solid, axis);
}

ref::SurfaceDirection ref_direction(double degrees) {
  return ref::SurfaceDirection::of_degrees(ref::Exact(degrees));
}

bool near(double value, double expected, double scale, double tolerance) {
  return std::fabs(value - expected) <= tolerance * std::fabs(scale);
}

/// Answers of lines of random solids, in any direction, against the reference's.
void check_against_ref(SymmetryAxis axis) {
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> degrees(-200, 200), share(0, 0.95);
  for (int sample = 0; sample < 30; ++sample) {
    CAPTURE(sample);
    const TransverselyIsotropicSolid solid = random_solid(generator);
    const double theta = degrees(generator);
    const Direction motion = Direction::of_degrees(theta);
    const double speed = std::sqrt(share(generator)) * fast::critical_speed(solid, axis, motion).speed;
    const TransverselyIsotropicHalfSpace surface(solid, axis, motion, speed);
    for (int line = 0; line < 3; ++line) {
      const double psi = degrees(generator);
      const auto truth = ref::line_response(exactly(solid, axis), ref::Exact(speed), ref_direction(theta),
                                            ref_direction(psi), 20);
      const LineResponse found = surface.along(Direction::of_degrees(psi));
      for (const double error :
           {truth.compliance.error_of(found.compliance), truth.coupling.error_of(found.coupling),
            truth.coupling_across.error_of(found.coupling_across)})
        CHECK(std::fabs(error) <= 1e-12 * found.compliance);
    }
  }
}

}  // namespace

TEST_CASE("isotropic half-space: two units in the last place from rest to the Rayleigh speed") {
  double worst = 0;
  for (const double poisson : {-0.9, -0.3, 0.0, 0.25, 0.29529, 1.0 / 3, 0.45, 0.4999}) {
    const double limit = fast::isotropic_rayleigh_speed(poisson);
    for (const double part : {1e-8, 1e-4, 0.01, 0.3, 0.7, 0.9, 0.999, 1 - 1e-6, 1 - 1e-10}) {
      for (const double cosine : {1.0, -0.8, 0.1, 1e-5}) {
        const IsotropicSolid solid{1, poisson, 1};
        const Direction psi{cosine, std::sqrt(1 - cosine * cosine)};
        const double speed = part * limit;
        const IsotropicLine line(poisson, speed, cosine);
        const LineResponse normal = fast::isotropic_response(solid, speed, psi);
        const fast::ShearResponse shear = fast::isotropic_shear_response(solid, speed, psi);
        for (const double error :
             {deviation(normal.compliance, line.X * line.wD / line.R),
              deviation(normal.coupling, (2 - line.X - 2 * line.wS * line.wD) / line.R),
              deviation(shear.in_line, line.X * line.wS / line.R), deviation(shear.across, 1 / line.wS)}) {
          worst = std::max(worst, error);
        }
      }
    }
  }
  CHECK(worst <= 2);
}

TEST_CASE("isotropic half-space: at rest, across the motion, and in the unit of the modulus") {
  for (const Direction psi : {Direction{1, 0}, Direction{0, 1}}) {
    const double speed = psi.cosine == 0 ? 0.5 : 0;
    const LineResponse normal = fast::isotropic_response({8, 0.25, 3}, speed, psi);
    CHECK(normal.compliance == 0.75 / 8);
    CHECK(normal.coupling == 0.25 / 8);
    const fast::ShearResponse shear = fast::isotropic_shear_response({8, 0.25, 3}, speed, psi);
    CHECK(shear.in_line == 0.75 / 8);
    CHECK(shear.across == 1.0 / 8);
  }
}

TEST_CASE("isotropic half-space: speeds near the critical one keep their digits in any unit") {
  // v/sqrt(mu/rho), rounded, would cost 1e-7 at 1 - 1e-9 of the Rayleigh speed.
  const IsotropicSolid solid{77.2e9, 0.3, 7860};
  const Real shear_speed = sqrt(Real(solid.shear) / solid.density);
  for (const double gap : {1e-3, 1e-6, 1e-9}) {
    const double speed =
        (1 - gap) * fast::isotropic_rayleigh_speed(solid.poisson) * static_cast<double>(shear_speed);
    const Real X = pow(speed / shear_speed, 2), nu = solid.poisson;
    const Real wS = sqrt(1 - X), wD = sqrt(1 - X * (1 - 2 * nu) / (2 - 2 * nu));
    const Real compliance = X * wD / (4 * wS * wD - pow(2 - X, 2)) / solid.shear;
    CHECK(deviation(fast::isotropic_response(solid, speed, {1, 0}).compliance, compliance) <= 2);
  }
}

TEST_CASE("directions in degrees have two words, and none near 90 loses digits") {
  for (const double degrees : {0.0, 1e-9, -30.0, 44.9, 45.1, 60.0, 89.999999999, 90.0, -135.5, 270.0, 1e6}) {
    CAPTURE(degrees);
    const Direction psi = Direction::of_degrees(degrees);
    const Real angle = Real(degrees) * boost::math::constants::pi<Real>() / 180;
    const auto close = [](double high, double low, const Real& truth) {
      CHECK(abs(Real(high) + low - truth) <= 1e-30 * abs(truth) + 1e-95);
    };
    close(psi.cosine, psi.cosine_low, cos(angle));
    close(psi.sine, psi.sine_low, sin(angle));
    const Direction back = Direction::of_degrees(-degrees).turned(psi);
    CHECK(std::fabs(back.sine + back.sine_low) < 1e-31);
    CHECK(std::fabs(back.cosine - 1 + back.cosine_low) < 1e-31);
  }
  CHECK_THROWS_AS(Direction::of_degrees(not_a_number), data::BadInput);
}

TEST_CASE("isotropic Rayleigh speed: the function changes its sign within a double of it") {
  for (const double poisson : {-0.99, -0.5, 0.0, 0.25, 0.4, 0.499999}) {
    const double speed = fast::isotropic_rayleigh_speed(poisson);
    CHECK(IsotropicLine(poisson, speed, 1).R > 0);
    CHECK(IsotropicLine(poisson, std::nextafter(speed, 1), 1).R <= 0);
  }
}

TEST_CASE("transversely isotropic half-space: isotropic moduli answer isotropically, on every line") {
  for (const SymmetryAxis axis : {SymmetryAxis::normal, SymmetryAxis::in_plane}) {
    for (const double speed : {0.0, 1e-6, 0.3, 0.6, 0.9}) {
      const Direction motion{1, 0};
      const TransverselyIsotropicHalfSpace surface(isotropic_moduli, axis, motion, speed);
      for (const Direction psi : {Direction{1, 0}, Direction{0.8, 0.6}, Direction{-0.28, 0.96},
                                  Direction{0, 1}, Direction::of_angle(0.1), Direction::of_angle(2)}) {
        const LineResponse expected = fast::isotropic_response({1, 0.25, 1}, speed, psi);
        const LineResponse found = surface.along(psi);
        CHECK(near(found.compliance, expected.compliance, expected.compliance, 10 * ulp));
        CHECK(near(found.coupling, expected.coupling, expected.compliance, 10 * ulp));
        CHECK(near(surface.along(psi).coupling_across, 0, expected.compliance, 10 * ulp));
      }
    }
  }
}

TEST_CASE("transversely isotropic half-space: lines of random solids by the reference") {
  check_against_ref(SymmetryAxis::normal);
  check_against_ref(SymmetryAxis::in_plane);
}

TEST_CASE("transversely isotropic half-space: smooth where A6 = 0 and M with it") {
  // A6 = c44 sin^2 - density speed^2 cos^2 is zero, but for roundings
  const TransverselyIsotropicSolid solid{32, 350, 14, 16, 8, 1};
  const Direction psi{12.0 / 13, 5.0 / 13}, motion{1, 0};
  const double speed = 4 * psi.sine / psi.cosine;
  const auto response = [&](double at) {
    return TransverselyIsotropicHalfSpace(solid, SymmetryAxis::in_plane, motion, at).along(psi);
  };
  const LineResponse here = response(speed);
  for (const double step : {1e-15, 1e-12, 1e-9, 1e-6}) {
    const LineResponse below = response(speed * (1 - step)), above = response(speed * (1 + step));
    CHECK(near((below.compliance + above.compliance) / 2, here.compliance, here.compliance,
               2 * ulp + 10 * step * step));
    CHECK(near((below.coupling + above.coupling) / 2, here.coupling, here.compliance,
               2 * ulp + 10 * step * step));
    CHECK(near(below.compliance, above.compliance, here.compliance, 4 * ulp + 10 * step));
  }
}

TEST_CASE("critical speed: graphite epoxy against steel's unit of speed") {
  struct Row {
    double theta, speed, psi;
  };
  for (const auto& [theta, speed, psi] :
       {Row{0, 0.428350, 0}, Row{30, 0.4588, 15.28}, Row{45, 0.4989960517, 24.559}, Row{60, 0.5545, 37.38},
        Row{90, 0.64540, 90}}) {
    const fast::CriticalSpeed critical =
        fast::critical_speed(graphite_epoxy, SymmetryAxis::in_plane, Direction::of_angle(theta * degree));
    CHECK(critical.speed / unit_speed == doctest::Approx(speed).epsilon(2e-4));
    CHECK(critical.psi / degree == doctest::Approx(psi).epsilon(1e-3));
  }
  CHECK(fast::critical_speed(graphite_epoxy, SymmetryAxis::normal, {0, 1}).speed / unit_speed ==
        doctest::Approx(0.63882964015).epsilon(1e-10));
  CHECK(fast::critical_speed(graphite_epoxy, SymmetryAxis::in_plane, Direction::of_angle(45 * degree)).speed /
            unit_speed ==
        doctest::Approx(0.4989960517).epsilon(1e-9));
}

TEST_CASE("critical speed: there the first line is critical, and none before") {
  std::mt19937_64 generator(11);
  for (const SymmetryAxis axis : {SymmetryAxis::normal, SymmetryAxis::in_plane}) {
    for (int sample = 0; sample < 20; ++sample) {
      const TransverselyIsotropicSolid solid = random_solid(generator);
      const double theta = std::uniform_real_distribution<double>(-200, 200)(generator);
      const Direction motion = Direction::of_degrees(theta);
      const auto [speed, psi] = fast::critical_speed(solid, axis, motion);
      const auto check_line = [&](double share) {
        ref::check_subcritical(exactly(solid, axis), ref::Exact(share * speed), ref_direction(theta),
                               ref_direction(psi / degree));
      };
      CHECK_NOTHROW(check_line(1 - 1e-6));
      CHECK_THROWS_AS(check_line(1 + 1e-6), data::BadInput);

      const TransverselyIsotropicHalfSpace surface(solid, axis, motion, (1 - 1e-9) * speed);
      for (int line = 0; line < 20; ++line) {
        const Direction other = random_direction(generator);
        CHECK(fast::rayleigh_speed(solid, axis, motion, other) >= speed * (1 - 4 * ulp));
        const LineResponse response = surface.along(other);
        CHECK(response.compliance > 0);
        CHECK(std::isfinite(response.compliance));
        CHECK(std::isfinite(response.coupling));
      }
    }
  }
}

TEST_CASE("critical speed: valleys of two bottoms, and such as are narrower than a degree") {
  const auto check = [](const TransverselyIsotropicSolid& solid, double theta, double shallow_psi) {
    const Direction motion = Direction::of_degrees(theta);
    const double speed = fast::critical_speed(solid, SymmetryAxis::in_plane, motion).speed;
    const auto truth =
        ref::critical_speed(ref::exact_stiffness(solid, SymmetryAxis::in_plane), ref_direction(theta), 20);
    CHECK(std::fabs(truth.speed.error_of(speed)) <= 4 * ulp * speed);
    // Where a coarser search ends, it is higher.
    CHECK(fast::rayleigh_speed(solid, SymmetryAxis::in_plane, motion, Direction::of_degrees(shallow_psi)) >
          (1 + 1e-10) * speed);
  };
  // Bottoms 0.03 degrees from the axis, on both sides of a crest.
  check({8732.615966221072, 5.206161640027693, -186.282880027052, 1.252853292229777, 96.63621997752217,
         1218.5079266280632},
        90, 90);
  // The motion a little to one side: the bottom there is the deeper one.
  check({220132.35025845337, 7092.6140465015633, -22778.492806939132, 6.5980425342776119, 24.175487831893292,
         1.7000442657209416},
        90.00029295089729, 89.86824728);
  // 0.3 degrees wide, 6 degrees off, where a surface wave passes from one bulk wave to another.
  check({639.57693616129563, 0.2194159096995234, 6.9861913661117745, 43.742275887327871, 2.7515726557945337,
         2.1816122195484344},
        90, 90);
  // 2e-3 degrees off the isotropic plane, where lines a degree from it and from each other do not show it.
  check({39.245, 11.428, 17, 1633.193, 0.013, 1}, 75.8, 17.889);
}

TEST_CASE("critical speed: refused where moduli are too far apart for the lines, or for the search of them") {
  const auto refusal = [](const TransverselyIsotropicSolid& solid) {
    return refusal_of(
        [&] { return fast::critical_speed(solid, SymmetryAxis::in_plane, Direction::of_degrees(50)); });
  };
  CHECK(contains(refusal({1, 1, 0, 1e7, 1e-3, 1}), "to search its lines"));
  CHECK(contains(refusal({1, 1, 0, 1e13, 0.5, 1}), "no eigenvalue of its matrix more than 1e+12"));
  CHECK(refusal({1, 1, 0, 1e3, 1e-1, 1}) == "accepted");
  CHECK_THROWS_AS((void)fast::rayleigh_speed({1, 1, 0, 1e13, 0.5, 1}, SymmetryAxis::normal, {1, 0}, {1, 0}),
                  data::BadInput);
}

TEST_CASE("branch speeds: bulk waves along the surface, brock2013 Table 2, and beyond the critical speed") {
  for (const double theta : {0.0, 30.0, 45.0, 70.0, 90.0, 135.0}) {
    const Direction motion = Direction::of_angle(theta * degree);
    // The squares of the speeds of bulk waves along n are the eigenvalues of its acoustic matrix.
    const auto voigt = data::Stiffness::of(graphite_epoxy, SymmetryAxis::in_plane).voigt;
    constexpr std::size_t index[3][2] = {{0, 5}, {5, 1}, {4, 3}};
    const double n[] = {motion.cosine, motion.sine};
    Eigen::Matrix3d acoustic = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < 36; ++i) {
      const std::size_t row = i / 12, column = i / 4 % 3, j = i / 2 % 2, l = i % 2;
      acoustic(static_cast<int>(row), static_cast<int>(column)) +=
          n[j] * n[l] * voigt[index[row][j]][index[column][l]];
    }
    const Eigen::Vector3d stiffnesses =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(acoustic).eigenvalues();
    std::vector<double> speeds;
    for (const auto wave : {fast::BranchWave::transverse, fast::BranchWave::quasi_transverse,
                            fast::BranchWave::quasi_longitudinal}) {
      speeds.push_back(fast::branch_speed(wave, graphite_epoxy, motion));
      CHECK(speeds.back() >= fast::critical_speed(graphite_epoxy, SymmetryAxis::in_plane, motion).speed);
    }
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(speeds[i] == doctest::Approx(std::sqrt(stiffnesses[static_cast<int>(i)] / graphite_epoxy.density))
                             .epsilon(1e-12));
  }
  CHECK(fast::branch_speed(fast::BranchWave::transverse, graphite_epoxy, Direction::of_angle(45 * degree)) /
            unit_speed ==
        doctest::Approx(0.56459743).epsilon(1e-7));
}

TEST_CASE("transversely isotropic half-space at rest: the classical plane and indentation moduli") {
  // A half-plane along a principal direction, stiffnesses a along it, n normal to it, m between, g in shear:
  // K = sqrt(a/(a n - m^2) (1/g + 2/(sqrt(a n) + m))). With the axis normal that is 2/M of Elliott's and
  // Willis's M.
  const auto plane = [](double a, double n, double m, double g) {
    return std::sqrt(a / (a * n - m * m) * (1 / g + 2 / (std::sqrt(a * n) + m)));
  };
  std::mt19937_64 generator(11);
  for (int i = 0; i < 50; ++i) {
    const TransverselyIsotropicSolid solid = random_solid(generator);
    const double c12 = solid.c11 - 2 * solid.c66;
    const TransverselyIsotropicHalfSpace normal(solid, SymmetryAxis::normal, {1, 0}, 0);
    const TransverselyIsotropicHalfSpace in_plane(solid, SymmetryAxis::in_plane, {1, 0}, 0);
    const auto close = [](double found, double truth) {
      CHECK(found == doctest::Approx(truth).epsilon(1e-12));
    };
    close(normal.along({0.6, 0.8}).compliance, plane(solid.c11, solid.c33, solid.c13, solid.c44));
    close(in_plane.along({0, 1}).compliance, plane(solid.c33, solid.c11, solid.c13, solid.c44));
    close(in_plane.along({1, 0}).compliance, plane(solid.c11, solid.c11, c12, solid.c66));
  }
}

TEST_CASE("transversely isotropic half-space: the condition is the slope of K over the speed") {
  std::mt19937_64 generator(12);
  for (const SymmetryAxis axis : {SymmetryAxis::normal, SymmetryAxis::in_plane}) {
    const TransverselyIsotropicSolid solid = random_solid(generator);
    const Direction motion = random_direction(generator), psi = Direction::of_angle(0.4);
    const double limit = fast::critical_speed(solid, axis, motion).speed;
    const auto surface = [&](double speed) {
      return TransverselyIsotropicHalfSpace(solid, axis, motion, speed);
    };
    for (const double part : {0.0, 0.3, 0.9}) {
      const double speed = part * limit, step = 1e-4 * speed;
      const double slope = part == 0 ? 0
                                     : std::log(surface(speed + step).along(psi).compliance /
                                                surface(speed - step).along(psi).compliance) /
                                           (2e-4);
      CHECK(surface(speed).condition(psi) == doctest::Approx(slope).epsilon(1e-5));
    }
    CHECK(surface(0.5 * limit).condition({-motion.sine, motion.cosine}) < 1e-12);
    // At the last double below the critical speed it is a large number or a refusal, never nan.
    const TransverselyIsotropicHalfSpace last = surface(std::nextafter(limit, 0));
    const Direction critical = Direction::of_angle(fast::critical_speed(solid, axis, motion).psi);
    double found = 0;
    const bool refused = refusal_of([&] { return found = last.condition(critical); }).starts_with("speed = ");
    CHECK(refused != (found > 1e3));
  }
}

TEST_CASE("half-spaces refuse what they cannot answer, in one line") {
  const auto isotropic_at = [](double poisson, double speed, double cosine) {
    const Direction psi{cosine, std::sqrt(1 - cosine * cosine)};
    return refusal_of([=] { return fast::isotropic_response({1, poisson, 1}, speed, psi); });
  };
  CHECK(isotropic_at(0.5, 0.1, 1).starts_with("poisson = "));
  CHECK(isotropic_at(0.3, not_a_number, 1).starts_with("speed = nan"));
  CHECK(isotropic_at(0.3, -0.1, 1).starts_with("speed = "));
  CHECK(isotropic_at(0.3, 0.95, 1).starts_with("speed = "));
  CHECK(isotropic_at(0.3, 1.5, 1).starts_with("speed = "));
  CHECK(isotropic_at(0.3, 0.95, 0.5) == "accepted");
  CHECK(isotropic_at(0.3, 0.1, not_a_number).starts_with("psi = nan"));
  CHECK_THROWS_AS(fast::isotropic_rayleigh_speed(not_a_number), data::BadInput);

  const Direction motion = Direction::of_angle(45 * degree);
  const auto surface = [&](const TransverselyIsotropicSolid& solid, Direction along, double speed) {
    return refusal_of([&] {
      return TransverselyIsotropicHalfSpace(solid, SymmetryAxis::in_plane, along, speed * unit_speed);
    });
  };
  CHECK(surface(graphite_epoxy, motion, 0.498) == "accepted");
  const std::string critical = surface(graphite_epoxy, motion, 0.5);
  CHECK(critical.starts_with("speed = "));
  CHECK(contains(critical, "1563.8478"));
  CHECK(contains(critical, "psi = 24.5589 degrees"));
  CHECK(critical.find('\n') == std::string::npos);
  CHECK(surface(graphite_epoxy, motion, not_a_number).starts_with("speed = nan"));
  CHECK(surface(graphite_epoxy, motion, -1).starts_with("speed = "));
  CHECK(surface(graphite_epoxy, {1, 1}, 0.1).starts_with("motion = (1, 1)"));
  CHECK(surface(graphite_epoxy, {not_a_number, 1}, 0.1).starts_with("motion = "));
  TransverselyIsotropicSolid soft = graphite_epoxy;
  soft.c13 = 1e12;
  CHECK(surface(soft, motion, 0.1).starts_with("c13 = "));
  const TransverselyIsotropicHalfSpace good(graphite_epoxy, SymmetryAxis::normal, motion, 0.1 * unit_speed);
  CHECK(refusal_of([&] { return good.along({not_a_number, 0}); }).starts_with("psi = "));
}
