// Estimates of rolling contacts that random scenes showed to be too small.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>

using namespace nipref;

TEST_CASE("thin sheet with a short memory, little asked: the quadrature is not what is left") {
  // Its many panels leave out less than the quadrature did whose tolerance went with what they may leave out.
  const data::ViscoelasticNip nip{18.923064846545458, 0.006449549600802129,
                                  data::operator_solid({{143142339.890625, 1.0},
                                                        {57438.41528701782, 0.03996054705203278},
                                                        {7495473.203125, 1.0},
                                                        {321172.29263305664, 4.267132258042693}}),
                                  0.5422828955342993};
  const double length = 0.46639424486784264;
  const auto asked = fast::converged_for_length(nip, length, 1.5e-3);
  const auto truth = fast::converged_for_length(nip, length, 1e-13);
  const auto check = [](const fast::Estimate& found, const fast::Estimate& other) {
    CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
  };
  check(asked.load(), truth.load());
  check(asked.peak_pressure(), truth.peak_pressure());
  for (const double y : {0.0, 0.13, -0.13, 0.233, -0.233}) check(asked.pressure(y), truth.pressure(y));
}

TEST_CASE(
    "outside the rolling contact the displacement is as sure as it is small, behind it like its memory") {
  const data::ViscoelasticNip nip{100, 1, data::single_relaxation_time_solid(2, 1, 0.25), 1};
  const auto asked = fast::converged_for_length(nip, 2, 1e-8);
  const auto truth = fast::converged_for_length(nip, 2, 1e-13);
  for (const double y : {-20.0, -9.0, -6.0, -3.0, 3.0, 4.5, 6.0, 9.0, 20.0}) {
    const fast::Estimate found = asked.normal_displacement(y), other = truth.normal_displacement(y);
    CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
    CHECK(found.error <= 1e-4 * std::fabs(found.value) + 1e-14 * asked.indentation().value);
  }
}

TEST_CASE(
    "beside the place that a tangential displacement is counted from it rounds like those at the ends") {
  // The same nip in two systems of units.
  const auto displacement = [](double length, double time) {
    const auto material =
        data::operator_solid({.p = {6.107641151942289e-05, time},
                              .q = {6.3351298447145155e-06 * 9, 3.7029537225607783 * 9 * time},
                              .p_dilatation = {0.0004970805209723039, time},
                              .q_dilatation = {0.002133002308937648 * 9, 153.19015558063984 * 9 * time}});
    const data::ViscoelasticNip nip{9235.406129837036 * length, 1.4095254747662693 * length, material,
                                    0.015152343060435669 * length / time};
    const fast::Estimate found =
        fast::converged_for_length(nip, 8.492915808223188 * length, 1.5959999385562398e-12)
            .tangential_displacement(-0.0028757984787262103 * length);
    return fast::Estimate{found.value / length, found.error / length};
  };
  const fast::Estimate one = displacement(1, 1), other = displacement(35, 7);
  CHECK(std::fabs(one.value - other.value) <= one.error + other.error);
}

TEST_CASE(
    "behind the leading end a memory that swings far faster than it fades is resolved until it has faded") {
  // Panels that only double hold many of its waves there: few terms leave them all out, and agree.
  const double square = 100 * 100 + 1000 * 1000, relaxed = 1.03 * square;
  const data::ViscoelasticNip nip{1000, 2,
                                  data::operator_solid({.p = {relaxed, 200, 1},
                                                        .q = {square, 200, 1},
                                                        .p_dilatation = {relaxed, 200, 1},
                                                        .q_dilatation = {4 * square, 800, 4}}),
                                  1};
  const auto asked = fast::converged_for_length(nip, 2, 1e-4);
  const auto truth = fast::converged_for_length(nip, 2, 1e-12);
  for (const double behind : {0.05, 0.1, 0.15, 0.2, 0.25, 0.3}) {
    const double place = truth.leading_length().value - behind;
    const fast::Estimate found = asked.pressure(place), other = truth.pressure(place);
    CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
  }
}

TEST_CASE(
    "behind the trailing end a short memory of theta2 still holds the strain that its limit holds no more") {
  const double fast_rate = 1.5e10, rate = 3.5e8;
  const data::ViscoelasticNip nip{
      4, 0.057,
      data::prony_solid({1.4, {1.5e9, 2e7}, {fast_rate, rate}}, {8.7e-3, {9.3e6, 1.2e5}, {fast_rate, rate}}),
      1.7};
  const double length = 6e-4, way = nip.speed / fast_rate;
  const auto asked = fast::converged_for_length(nip, length, 2e-4);
  const auto truth = fast::converged_for_length(nip, length, 1e-13);
  for (const double behind : {0.3, 1.0, 2.0, 3.0, 10.0}) {
    const double place = -truth.trailing_length().value - behind * way;
    const fast::Estimate found = asked.surface_strain(place), other = truth.surface_strain(place);
    CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
  }
}

TEST_CASE("a largest pressure next to the leading end is known no better than that end") {
  const data::ViscoelasticNip nip{
      170.68691024184227, 2.139113665325567,
      data::operator_solid({.p = {12634.805172920227, 1},
                            .q = {10248.159998893738, 39.90082090720534},
                            .p_dilatation = {12505.649567604065, 1},
                            .q_dilatation = {742.1138881444931, 2.91923318663612}}),
      0.04327916605325299};
  const double load = 6.3866406677104415e-09;
  const fast::Estimate found = fast::converged_for_load(nip, load, 6.78e-4).peak_pressure_position(),
                       other = fast::converged_for_load(nip, load, 1e-13).peak_pressure_position();
  CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
}

TEST_CASE("a memory that swings within the contact: places of the largest pressure agree at all accuracies") {
  const data::ViscoelasticNip nip{
      0.6918036215938628, 0.11073930429847678,
      data::operator_solid({.p = {181366.22010803223, 176.96774405241013, 1},
                            .q = {3268.934533596039, 4.408652518875897, 0.03004996230993129},
                            .p_dilatation = {181366.22010803223, 176.96774405241013, 1},
                            .q_dilatation = {193843.0047607422, 261.42660319805145, 1.781918520340696}}),
      0.05409972866254975};
  const auto place = [&](double accuracy) {
    return fast::converged_for_load(nip, 1.0704373618608543e-06, accuracy).peak_pressure_position();
  };
  const fast::Estimate coarse = place(1e-8);
  for (const double accuracy : {1e-10, 1e-12}) {
    const fast::Estimate fine = place(accuracy);
    CHECK(std::fabs(fine.value - coarse.value) <= fine.error + coarse.error);
  }
}

TEST_CASE("behind the trailing end a short memory that swings fades by its real part alone") {
  const data::ViscoelasticNip nip{
      0.26208559203344134, 0.08288908159170785,
      data::operator_solid({.p = {2.6963243495653964e+24, 110579119933.7209, 1},
                            .q = {8.661786688676012e+24, 375686609987.53705, 3.5393944847217655},
                            .p_dilatation = {2.6963243495653964e+24, 110579119933.7209, 1},
                            .q_dilatation = {8.813991254984685e+25, 3822881599444.165, 36.015885818410894}}),
      34.432234780098426};
  const double length = 9.511302533807496e-4, fade = nip.speed / (110579119933.7209 / 2);
  const auto asked = fast::converged_for_length(nip, length, 1e-3);
  const auto truth = fast::converged_for_length(nip, length, 1e-13);
  for (const double behind : {0.3, 1.0, 3.0}) {
    const double place = -truth.trailing_length().value - behind * fade;
    const fast::Estimate found = asked.surface_strain(place), other = truth.surface_strain(place);
    CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
  }
}

TEST_CASE("next to the middle the tangential displacement is as unsure as the strains around let it be") {
  const data::ViscoelasticNip nip{2.291610184824094, 0.002508216956812248,
                                  data::operator_solid({.p = {0.25636365165701136, 1},
                                                        .q = {117820.5478439331, 2030654.2149658203},
                                                        .p_dilatation = {155.95582568645477, 1},
                                                        .q_dilatation = {140721809.625, 3986861.9428710938}}),
                                  2.072009459603578};
  const double load = 561798.7498168945, place = 0.02498268957606342;
  const fast::Estimate found = fast::converged_for_load(nip, load, 5.6e-3).tangential_displacement(place),
                       other = fast::converged_for_load(nip, load, 1e-13).tangential_displacement(place);
  CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
}

TEST_CASE("levels that see the same slope by chance do not make the place of the largest pressure sure") {
  const data::ViscoelasticNip nip{9599.183506965637, 7.716756391339004,
                                  data::operator_solid({.p = {11.00524025876075, 1},
                                                        .q = {1.0876204347005114, 0.24229669729538728},
                                                        .p_dilatation = {1},
                                                        .q_dilatation = {10.052897952497005}}),
                                  23.594791866838932};
  const double length = 82.08602374792099;
  const fast::Estimate found = fast::converged_for_length(nip, length, 1.623710285002744e-3)
                                   .peak_pressure_position(),
                       other = fast::converged_for_length(nip, length, 1e-13).peak_pressure_position();
  CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
}

TEST_CASE("creep is as unsure as the load lets its halves be, which cancel") {
  const data::ViscoelasticNip nip{2189.387916443203, 1.0178127604592446,
                                  data::standard_linear_solid({.shear_1 = 145.8783256345553,
                                                               .shear_2 = 707.2095165670619,
                                                               .bulk_1 = 285.13017109060263,
                                                               .bulk_2 = 4.108329742918907,
                                                               .shear_viscosity = 0.341199535302999,
                                                               .bulk_viscosity = 3399.7498580496463}),
                                  6.481100846475254};
  const double load = 1166536.856889787;
  const fast::Estimate found = fast::converged_for_load(nip, load, 1e-3).creep_ratio(),
                       other = fast::converged_for_load(nip, load, 1e-13).creep_ratio();
  CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
}

TEST_CASE("a largest pressure as near to the leading end as a memory that is left out is long") {
  const data::ViscoelasticNip nip{
      3056.449308300982, 1.9807370367610184,
      data::operator_solid({.p = {3052.345189366326, 1},
                            .q = {31.0298951390384, 0.5892158942135465},
                            .p_dilatation = {1214186123.753757, 1},
                            .q_dilatation = {2706164003.5215282, 129.18040434186574}}),
      1.4187996870353454};
  const double load = 4.6492826835492585e-07;
  const fast::Estimate other = fast::converged_for_load(nip, load, 1e-13).peak_pressure();
  for (const double accuracy : {1e-3, 6.0711576006674536e-05}) {
    const fast::Estimate found = fast::converged_for_load(nip, load, accuracy).peak_pressure();
    CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
  }
}

TEST_CASE("levels that see the same displacements next to the middle by chance do not further away") {
  const data::ViscoelasticNip nip{4.300875562708825, 0.06267105788720073,
                                  data::standard_linear_solid({.shear_1 = 0.4489543429808691,
                                                               .shear_2 = 3.2303613699041307,
                                                               .bulk_1 = 0.9393331479514018,
                                                               .bulk_2 = 0.40541750722331926,
                                                               .shear_viscosity = 0.9343524241703562,
                                                               .bulk_viscosity = 3.287559708839427e-08}),
                                  1.3571972145000473};
  const double length = 0.42400682289735414;
  const auto asked = fast::converged_for_length(nip, length, 1.5325098974017237e-4);
  const auto truth = fast::converged_for_length(nip, length, 1e-13);
  for (const double place : {-0.0013811861473413956, -0.002, -0.0027623722946827912, -0.004}) {
    const fast::Estimate found = asked.tangential_displacement(place),
                         other = truth.tangential_displacement(place);
    CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
  }
}

TEST_CASE("some way from the trailing end the pressure lacks what its panel's slower expansion does") {
  const std::vector<double> rates{555342.0172289223, 5078.931223272354};
  const data::ViscoelasticNip nip{
      756.705507170328, 0.646036541863308,
      data::prony_solid({1.6396828373268468e-06, {0.012546314647709968, 0.0048412093978487825}, rates},
                        {3.13791161271593e-06, {0.026372518434243555, 0.008625841739456906}, rates}),
      23.05782736980685};
  const double length = 54.78194714314238;
  const auto asked = fast::converged_for_length(nip, length, 3.8e-4);
  const auto truth = fast::converged_for_length(nip, length, 1e-13);
  const auto check = [](const fast::Estimate& found, const fast::Estimate& other) {
    CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
  };
  for (const double y : {-25.0, -24.45, -24.39276353428942, -24.03}) {
    check(asked.pressure(y), truth.pressure(y));
    check(asked.surface_strain(y), truth.surface_strain(y));
    check(asked.slip(y), truth.slip(y));
  }
}

TEST_CASE("resistance: two levels that are near each other by chance do not make the next one as near") {
  const data::ViscoelasticNip nip{41.51859581281904, 1.3145573926394332,
                                  data::operator_solid({{14738.592906668251, 1.0},
                                                        {23831145343.024704, 4172086.0867622006},
                                                        {0.0005410061624170299, 1.0},
                                                        {77999.17887442798, 372007921.51058155}}),
                                  12.494314089911471};
  const double length = 35.82601027439481;
  const fast::Estimate found = fast::converged_for_length(nip, length, 6.8e-5).rolling_resistance();
  const fast::Estimate other = fast::converged_for_length(nip, length, 1e-13).rolling_resistance();
  CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
}

TEST_CASE("next to the leading end the strain rounds as the pressure does that makes it at once") {
  const data::ViscoelasticNip nip{15660.851572036743, 1.854786531534046,
                                  data::operator_solid({{34480.27462387085, 1.0},
                                                        {243385.40824890137, 329.2721646130085},
                                                        {0.00040817430831907586, 1.0},
                                                        {0.00536199903308443, 612.7908380031586}}),
                                  0.012102478431188501};
  const auto contact = fast::converged_for_length(nip, 0.008795065559752402, 2.7259528381578472e-11);
  const double y = 0.004396866668230359;
  const fast::Estimate strain = contact.surface_strain(y), pressure = contact.pressure(y);
  // Nearly all of the strain is theta2 times the pressure there.
  CHECK(strain.error / std::fabs(strain.value) > 0.3 * pressure.error / pressure.value);
}

TEST_CASE("far behind a contact, what oscillates counts against what it has left, not what it began with") {
  const auto material = data::operator_solid({.p = {342.5, 1.59, 1.0},
                                              .q = {1.3514e9, 6.371e6, 4.433e6},
                                              .p_dilatation = {342.5, 1.59, 1.0},
                                              .q_dilatation = {1.2437e9, 5.864e6, 4.079e6}});
  const data::ViscoelasticNip nip{12568, 0.0844, material, 0.1753};
  const auto asked = fast::converged_for_length(nip, 4.974, 1e-6);
  const auto truth = fast::converged_for_length(nip, 4.974, 1e-13);
  for (const double place : {-9.0, -11.0, -14.0, -20.0, -107.0}) {
    const fast::Estimate found = asked.normal_displacement(place), other = truth.normal_displacement(place);
    CAPTURE(place);
    CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
  }
}

TEST_CASE(
    "the trailing half has no layer: what a memory that swings has left there is resolved by its terms") {
  const std::vector<double> p{782680932679680.0, 6695738.775390625, 1.0};
  const data::ViscoelasticNip nip{
      1.1973452918464318, 0.002579223587645174,
      data::operator_solid({p,
                            {9382128161652736.0, 82623957.2109375, 12.387626795098186},
                            p,
                            {2262666262872064.0, 19926229.666015625, 2.9874954535625875}}),
      25.752156415954232};
  const double length = 0.0001025917463906012;
  const fast::Estimate truth = fast::converged_for_length(nip, length, 1e-13).rolling_resistance();
  for (const double accuracy : {1e-5, 2.4e-6, 1e-6, 1e-7, 1e-8, 1e-9}) {
    const fast::Estimate found = fast::converged_for_length(nip, length, accuracy).rolling_resistance();
    CAPTURE(accuracy);
    CHECK(std::fabs(found.value - truth.value) <= found.error + truth.error);
    // Where it was not resolved, the terms of the end panels fell no more and more accuracy cost ever more terms.
    CHECK(found.error <= accuracy * length / (2 * nip.roller_radius));
  }
}
