// Where the tractions of a nip are largest and the shear changes its sign, by both paths and all methods.

#include "support/solved_scene.hpp"

using namespace nipref;

namespace {

data::Scene gripped_sheet(double poisson, double length) {
  const data::ElasticNipProblem problem{
      .nip = {1e3, 1, {1, poisson}}, .given = data::GivenLength{length}, .friction = data::Friction::full};
  return scene_wanting(problem, {data::ResultId::peak_shear_position, data::ResultId::shear_zeros}, 1e-10);
}

void check_within(const fast::Estimate& number, double truth, double slack) {
  CAPTURE(number.value);
  CHECK(std::fabs(number.value - truth) <= number.error + slack);
}

}  // namespace

TEST_CASE("a half-plane's shear has its maximum and zero where the closed form has them") {
  using enum data::ResultId;
  // p + iq goes like sqrt(1 - t^2) ((1 + t)/(1 - t))^(i epsilon), so that with x = 2 atanh t the shear is sech(x/2)
  // sin(epsilon x): zero at epsilon x = pi, largest where tanh(x/2) tan(epsilon x) = 2 epsilon. (Muskhelishvili)
  const double poisson = -0.9, beta = (1 - 2 * poisson) / (2 * (1 - poisson)), pi = std::acos(-1.0);
  const double epsilon = std::atanh(beta) / pi;
  const double length = 1e-4, half = length / 2;
  double low = 0.1, high = pi / (2 * epsilon);
  for (int i = 0; i < 100; ++i) {
    const double x = (low + high) / 2;
    (std::tanh(x / 2) * std::tan(epsilon * x) < 2 * epsilon ? low : high) = x;
  }
  const auto solution = verify::solve(gripped_sheet(poisson, length));
  // The sheet differs from a half-plane by the square of the contact length.
  const double slack = 10 * length * length * half;
  check_within(solution[peak_shear_position], half * std::tanh(low / 2), slack);
  const auto& zeros = solution.profile(shear_zeros);
  REQUIRE(zeros.size() == 2);
  CHECK(zeros[0].value == 0);
  check_within(zeros[1], half * std::tanh(pi / (2 * epsilon)), slack);
  CHECK(zeros[1].error < 1e-9 * half);
}

TEST_CASE("a rolling contact's largest pressure is ahead, where the reference has it") {
  using enum data::ResultId;
  data::Scene scene = loaded_example("viscoelastic-comparable-memory");
  scene.wanted = {peak_pressure_position, peak_pressure, pressure};
  const fast::Estimate place = verify::solve(scene)[peak_pressure_position];
  CHECK(place.value > 0);
  CHECK(place.error < 1e-9);
  auto& problem = std::get<data::ViscoelasticNipProblem>(scene.system);
  problem.profile = data::Positions{{place.value - 1e-3, place.value, place.value + 1e-3}};
  const auto beside = verify::solve(scene);
  const auto& pressures = beside.profile(pressure);
  CHECK(pressures[1].value == approx(beside[peak_pressure].value, 1e-14));
  CHECK(pressures[0].value < pressures[1].value);
  CHECK(pressures[2].value < pressures[1].value);
}

TEST_CASE("the heat of slip adds up over the contact to what is dissipated, and is none where it sticks") {
  using enum data::ResultId;
  data::Scene scene = loaded_example("intermediate-coulomb");
  scene.wanted = {leading_length, trailing_length, dissipation, heat, slip};
  auto& problem = std::get<data::PartialSlipProblem>(scene.system);
  const double most = 0.2, step = 2e-4;  // inches, beyond both ends
  data::Positions places;
  for (double y = -most; y < most; y += step) places.y.push_back(y);
  problem.profile = places;
  const auto solution = verify::solve(scene);
  REQUIRE(solution[leading_length].value < most);
  REQUIRE(solution[trailing_length].value < most);
  double sum = 0;
  for (std::size_t i = 0; i < places.y.size(); ++i) {
    const double here = solution.profile(heat)[i].value;
    CHECK(here >= 0);
    CHECK_FALSE(std::signbit(here));
    if (solution.profile(slip)[i].value == 0) CHECK(here == 0);
    sum += step * here;
  }
  // Near an end the heat varies like the root of the distance.
  CHECK(sum == approx(solution[dissipation].value, 3e-3));
}
