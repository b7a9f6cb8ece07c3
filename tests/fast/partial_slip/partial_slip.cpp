// The contact with Coulomb's friction: closed forms, limits, another program's numbers, its own conditions.
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/partial_slip/internal/find_zones.hpp>
#include <nipref/fast/partial_slip/internal/plain_zones.hpp>
#include <nipref/fast/partial_slip/internal/solutions.hpp>
#include <nipref/fast/partial_slip/partial_slip.hpp>

#include "support/test.hpp"

using namespace nipref;
using data::GivenCreep, data::GivenTraction;
using fast::Estimate;

namespace {

/// A sheet of half-thickness 1 between rollers so large that their profiles are parabolas. N makes the unit of loads 1;
/// the unit of creep ratios is 1/100.
data::PartialSlipNip unit_nip(double poisson, double friction, const data::Drive& drive) {
  constexpr double radius = 50;
  return {{radius, 2, {4 * radius * (1 - poisson * poisson), poisson}}, friction, drive};
}

struct Random {
  std::mt19937 numbers{2026};
  double operator()(double from, double to) { return std::uniform_real_distribution(from, to)(numbers); }
};

}  // namespace

TEST_CASE("a thick incompressible sheet has Carter's creep and zones") {
  constexpr double mu = 0.3;
  for (const double part : {0.1, 0.5, 0.96}) {
    CAPTURE(part);
    const auto at = [&](double half) {
      const double load = std::numbers::pi * half * half;
      const auto nip =
          fast::partial_slip_for_load(unit_nip(0.5, mu, GivenTraction{-part * mu * load}), load, 1e-12);
      REQUIRE(nip.zone_signs().size() == 2);
      return std::array{nip.contact_length().value / half, nip.zone_boundaries()[1].value / half,
                        100 * nip.creep_ratio().value / half};
    };
    // The sheet's thickness adds terms that grow with the length.
    const auto longer = at(1e-6), shorter = at(5e-7);
    const double stick = std::sqrt(1 - part), expected[] = {2, 1 - 2 * stick, 2 * mu * (1 - stick)};
    for (std::size_t i = 0; i < 3; ++i) CHECK(std::fabs(2 * shorter[i] - longer[i] - expected[i]) < 1e-9);
  }
}

TEST_CASE("dissimilar rollers creep and slip as the program CONTACT prints of its example bentall") {
  // CONTACT has aluminium on steel, here a rigid roller is on the equivalent sheet. There it rolls to -x, x = -Y. Printed:
  // creep ratio, power over 1e9, boundaries of zones to an element's width 0.001 (eve70a/CONTACT, d431cdbd).
  struct Printed {
    double traction, creep, power;
    std::vector<double> boundaries;
  };
  const Printed all[] = {{0, 4.294e-4, 9.475e-6, {-0.1, -0.068, 0.049, 0.084, 0.092, 0.1}},
                         {0.75, 5.392e-4, 4.418e-5, {-0.1, -0.056, 0.050, 0.101}},
                         {-0.75, 2.108e-4, 1.955e-4, {-0.1, -0.087, -0.051, 0.1}}};
  constexpr double load = 16.2019, mu = 0.05;
  for (const Printed& printed : all) {
    CAPTURE(printed.traction);
    const auto nip = fast::partial_slip_for_load(
        {{25, 1e4, {42647.3716, 0.4160012775}}, mu, GivenTraction{printed.traction * mu * load}}, load, 1e-8);
    CHECK(-nip.creep_ratio().value == approx(printed.creep, 2e-3));
    CHECK(nip.dissipation().value == approx(printed.power, 0.015));
    const std::vector<fast::Estimate> boundaries = nip.zone_boundaries();
    // With the backward traction there are two more zones at the trailing end, both shorter than an element.
    REQUIRE(boundaries.size() >= printed.boundaries.size());
    for (std::size_t k = 0; k < printed.boundaries.size(); ++k)
      CHECK(std::fabs(boundaries[k].value + printed.boundaries[k]) < 0.0016);
  }
}

TEST_CASE("with more unknowns the contact converges, and so do the boundaries of its zones") {
  const fast::PartialSlipTask task{
      .beta = 0.306, .friction = 0.0661, .load = fast::load_guess(1), .traction = 0.0};
  const auto truth = fast::find_zones(task, 28);
  REQUIRE(truth);
  REQUIRE(truth->zones().size() == 5);
  for (const double nats : {17.0, 20.0, 23.0}) {
    CAPTURE(nats);
    const auto contact = fast::ZoneContact::solved(task, *truth, nats);
    REQUIRE(contact);
    CHECK(contact->length() == approx(truth->length(), std::exp(-1.2 * nats)));
    for (std::size_t k = 1; k < truth->zones().size(); ++k) {
      const double shift = fast::boundary(*contact, k) - fast::boundary(*truth, k);
      CHECK(std::fabs(shift) < std::exp(-0.8 * nats) * fast::longer_beside(*truth, k));
    }
  }
}

TEST_CASE(
    "boundaries where stick turns into slip are stated to nearly all digits, others as far as unknowns tell") {
  const auto solved = [](double accuracy) {
    return fast::partial_slip_for_load(unit_nip(0.3, 0.1, GivenTraction{-0.002}), 0.1, accuracy);
  };
  const auto nip = solved(1e-8), finer = solved(1e-12);
  const std::vector<int> signs = nip.zone_signs();
  REQUIRE(signs == std::vector<int>{1, 0, -1, 0, 1});
  const auto boundaries = nip.zone_boundaries(), truth = finer.zone_boundaries();
  const double length = nip.contact_length().value;
  for (std::size_t k = 1; k < signs.size(); ++k) {
    CAPTURE(k);
    CHECK(std::fabs(boundaries[k].value - truth[k].value) <= boundaries[k].error + truth[k].error);
    CHECK((boundaries[k].error < 1e-11 * length) == (signs[k - 1] == 0));
  }
}

TEST_CASE("as friction goes to 0 slip turns around where Bentall and Johnson have it") {
  // asin(c/a) + (c/a) sqrt(1 - (c/a)^2) = pi/4, creep beta (a/R) sqrt(1 - (c/a)^2).
  const double c = 0.40397275, poisson = 0.4, beta = (1 - 2 * poisson) / (2 * (1 - poisson));
  const double load = std::numbers::pi * 1e-12;
  const auto nip = fast::partial_slip_for_load(unit_nip(poisson, 1e-7, GivenTraction{0}), load, 1e-10);
  CHECK(nip.zone_boundaries()[1].value == approx(c * 1e-6, 1e-4));
  CHECK(100 * nip.creep_ratio().value == approx(-2e-6 * beta * std::sqrt(1 - c * c), 1e-5));
}

TEST_CASE("zones are found however little friction there is, and stick in proportion to it") {
  for (const double part : {0.0, 0.9, -0.999}) {
    CAPTURE(part);
    std::vector<double> sticking;
    for (const double mu : {1e-6, 1e-7}) {
      const auto nip =
          fast::partial_slip_for_load(unit_nip(0.1, mu, GivenTraction{part * mu * 1e-4}), 1e-4, 1e-8);
      const std::vector<Estimate> boundaries = nip.zone_boundaries();
      CHECK(nip.zone_signs().size() == 5);
      sticking.push_back(boundaries[1].value - boundaries[2].value);
    }
    CHECK(sticking[1] == approx(0.1 * sticking[0], 0.01));
  }
}

TEST_CASE("where elements tell of no zones those of less friction are followed") {
  const auto creep_with = [](double mu) {
    const auto nip = fast::partial_slip_for_load(unit_nip(0.18, mu, GivenTraction{0}), 1e-6, 1e-6);
    // There is no traction, so the rolling resistance does the work that slip dissipates.
    const Estimate lost = nip.dissipation(), resistance = nip.rolling_resistance();
    CHECK(std::fabs(lost.value - 1e-6 * resistance.value) <= lost.error + 1e-6 * resistance.error);
    return nip.creep_ratio().value;
  };
  // Elements find the zones at 1.45 and 1.65. The creep at coefficients of friction between lies between theirs.
  const double less = creep_with(1.45), more = creep_with(1.65);
  for (const double mu : {1.5, 1.6}) {
    CAPTURE(mu);
    CHECK((creep_with(mu) - less) * (creep_with(mu) - more) < 0);
  }
}

TEST_CASE("a given creep is met by zones, from full slip one way to the other") {
  const double load = 1e-3;
  for (const double mu : {1e-4, 0.83}) {
    const auto free = fast::partial_slip_for_load(unit_nip(-0.2, mu, GivenTraction{0}), load, 1e-8);
    for (const double part : {-2.0, -0.5, 0.01, 0.5, 2.0}) {
      CAPTURE(part);
      const double creep = free.creep_ratio().value + part * mu * free.contact_length().value / 100;
      const auto nip = fast::partial_slip_for_load(unit_nip(-0.2, mu, GivenCreep{creep}), load, 1e-8);
      const double traction = nip.traction().value;
      // The traction falls as the creep grows.
      CHECK(-part * traction > 0);
      if (std::fabs(part) == 2 && mu == 0.83) {
        CHECK(std::fabs(traction) == approx(mu * load, 1e-8));
        CHECK(nip.zone_signs().size() == 1);
      } else {
        const auto again =
            fast::partial_slip_for_load(unit_nip(-0.2, mu, GivenTraction{traction}), load, 1e-8);
        CHECK(again.creep_ratio().value == approx(creep, 1e-7));
      }
    }
  }
}

TEST_CASE(
    "random contacts meet all conditions of stick and slip, their energy balances, and given creep gives back traction") {
  Random random;
  const int count = is_thorough() ? 1000 : 24;
  int not_found = 0;
  for (int i = 0; i < count; ++i) {
    const double length = 2e-3 * std::pow(2500, random(0, 1)), mu = 0.01 * std::pow(100, random(0, 1));
    const double poisson = random(0, 0.5), load = fast::load_guess(length / 2);
    const double traction = i % 3 == 0 ? 0 : random(-0.95, 0.95) * mu * load;
    CAPTURE(i);
    const fast::PartialSlipTask task{
        .beta = (1 - 2 * poisson) / (2 * (1 - poisson)), .friction = mu, .load = load, .traction = traction};
    const auto contact = fast::find_zones(task, 24);
    if (!contact) ++not_found;
    if (!contact) continue;
    CHECK(fast::mean_excess(*contact, mu) < 1e-12);
    double largest_slip = 0, slip_where_it_sticks = 0;
    for (const auto& sample : contact->samples())
      largest_slip = std::max(largest_slip, std::fabs(sample.slip));
    for (const auto& sample : contact->samples()) {
      // In shorter zones rounding errors are visible.
      if (contact->zones()[static_cast<std::size_t>(sample.zone)].length < 1e-8 * length) continue;
      CHECK(sample.pressure > 0);
      if (sample.sign == 0) {
        CHECK(std::fabs(sample.shear) < (1 + 1e-3) * mu * sample.pressure);
        slip_where_it_sticks += sample.weight * std::fabs(sample.slip);
      } else {
        CHECK(sample.shear == approx(sample.sign * mu * sample.pressure, 1e-12));
        CHECK(sample.slip * sample.sign < 1e-4 * largest_slip);
      }
    }
    CHECK(slip_where_it_sticks < 1e-9 * length * length);
    const double work = contact->creep() * contact->tangential_load() + 2 * contact->moment();
    CHECK(std::fabs(contact->dissipation() - work) < 1e-7 * mu * load * length);
    if (traction == 0) continue;
    const auto back = fast::ZoneContact::solved(
        {.beta = task.beta, .friction = mu, .load = load, .creep = contact->creep()}, contact->zones(), 24);
    REQUIRE(back);
    CHECK(std::fabs(back->tangential_load() - traction) < 1e-8 * mu * load);
  }
  CHECK(not_found <= count / 500);
}

TEST_CASE("with much friction the contact is that of full friction, with little that without") {
  const data::ElasticMaterial material{1.5, 0.4};
  const auto with = [&](double mu) {
    return fast::partial_slip_for_length({{50, 2, material}, mu, GivenTraction{0}}, 1.5, 1e-9);
  };
  const auto full = fast::converged_for_length({50, 2, material}, data::Friction::full, 1.5, 1e-10);
  const auto none = fast::converged_for_length({50, 2, material}, data::Friction::none, 1.5, 1e-10);
  const auto apart = [](double a, const fast::Estimate& b) { return std::fabs(a / b.value - 1); };
  const auto of_full = [&](double mu) { return apart(with(mu).creep_ratio().value, full.creep_ratio()); };
  CHECK(of_full(0.5) < 0.1);
  CHECK(of_full(2) < 1e-3 * of_full(0.2));
  // The load differs like mu^2 (A ln(1/mu) + C), see limit.little_friction.load.
  const double more = apart(with(1e-2).load().value, none.load()),
               less = apart(with(2.5e-3).load().value, none.load());
  const double power = std::log(more / less) / std::log(4);
  CHECK(power > 1.5);
  CHECK(power < 2);
}

TEST_CASE(
    "few elements tell the zones, and with little friction slip alone does, with how long it sticks between") {
  struct Contact {
    double beta, friction, load, part;  ///< traction as a part of full sliding
    std::optional<fast::Zones> (*guess)(const fast::PartialSlipTask& task, int elements);
  };
  // The second contact has slip zones at its ends that are shorter than equal elements. The last has mu beta > 1.
  const Contact contacts[] = {{0.3, 1e-5, 0.1, 0, fast::slipping_zones},
                              {0.44, 1e-6, 1e-4, 0.999, fast::slipping_zones},
                              {0.7, 1e-4, 0.1, 0.4, fast::slipping_zones},
                              {0.7, 0.25, 1e-6, 0, fast::plain_zones},
                              {0.65, 1.9, 1e-4, 0.23, fast::plain_zones}};
  for (const Contact& one : contacts) {
    CAPTURE(one.friction);
    fast::PartialSlipTask task{.beta = one.beta,
                               .friction = one.friction,
                               .load = one.load,
                               .traction = one.part * one.friction * one.load};
    const auto contact = fast::find_zones(task, 20).value();
    const bool has_little_friction = one.guess == fast::slipping_zones;
    const auto check = [&](const fast::PartialSlipTask& given) {
      const fast::Zones zones = contact.zones(), guess = one.guess(given, 120).value();
      REQUIRE(fast::in_same_order(zones, guess));
      double end = 0, guess_end = 0;
      for (std::size_t k = 0; k < zones.size(); ++k) {
        end += zones[k].length / contact.length();
        guess_end += guess[k].length / fast::length_of(guess);
        CHECK(std::fabs(guess_end - end) < (has_little_friction ? 0.003 : 0.05));
        if (zones[k].sign == 0 && has_little_friction) CHECK(guess[k].length == approx(zones[k].length, 0.1));
      }
    };
    check(task);
    task.creep = contact.creep();
    task.traction.reset();
    check(task);
  }
  CHECK(!fast::slipping_zones({.beta = 0.3, .friction = 0.3, .load = 0.1, .traction = 0.0}, 60));
}

TEST_CASE("few elements tell the zones of a long contact, whose creep is many times its length") {
  const double load = fast::load_guess(9.8);
  const fast::PartialSlipTask task{.beta = 0.7, .friction = 1, .load = load, .traction = 0.5 * load};
  const fast::ZoneContact contact = fast::find_zones(task, 20).value();
  const fast::Zones guess = fast::plain_zones(task, 120).value();
  CHECK(contact.creep() > 16 * contact.length());
  CHECK(guess.back().length / fast::length_of(guess) ==
        approx(contact.zones().back().length / contact.length(), 0.02));
}

TEST_CASE(
    "profiles meet the roller, stick and slip, and stated errors cover a contact solved to more digits") {
  const data::PartialSlipNip nip = unit_nip(0.3, 0.2, GivenTraction{-0.1});
  const auto rough = fast::partial_slip_for_load(nip, 1, 1e-5),
             fine = fast::partial_slip_for_load(nip, 1, 1e-11);
  const double depth = fine.indentation().value, creep = fine.creep_ratio().value;
  const auto covered = [](const fast::Estimate& a, const fast::Estimate& b) {
    CAPTURE(a.value);
    CHECK(std::fabs(a.value - b.value) <= a.error + b.error);
  };
  for (const double y : {-2.0, -0.5, -0.31, -0.1, 0.0, 0.2, 0.45, 3.0}) {
    CAPTURE(y);
    const bool inside = y > -fine.trailing_length().value && y < fine.leading_length().value;
    if (inside) CHECK(fine.normal_displacement(y).value == approx(depth - y * y / 100, 1e-10));
    covered(rough.pressure(y), fine.pressure(y));
    covered(rough.shear(y), fine.shear(y));
    covered(rough.slip(y), fine.slip(y));
    covered(rough.normal_displacement(y), fine.normal_displacement(y));
    covered(rough.tangential_displacement(y), fine.tangential_displacement(y));
    const double step = 1e-5, strain = (fine.tangential_displacement(y + step).value -
                                        fine.tangential_displacement(y - step).value) /
                                       (2 * step);
    CHECK(std::fabs(fine.surface_strain(y).value - strain) < 1e-6);
    CHECK(fine.slip(y).value == doctest::Approx(fine.surface_strain(y).value - creep).scale(1).epsilon(1e-9));
  }
  covered(rough.creep_ratio(), fine.creep_ratio());
  covered(rough.contact_length(), fine.contact_length());
  covered(rough.peak_shear(), fine.peak_shear());
  covered(rough.peak_pressure(), fine.peak_pressure());
  covered(rough.peak_pressure_position(), fine.peak_pressure_position());
  covered(rough.peak_shear_position(), fine.peak_shear_position());
  CHECK(fine.peak_pressure_position().error < 1e-7);
  CHECK(fine.peak_shear_position().error < 1e-7);
  covered(rough.dissipation(), fine.dissipation());
  for (std::size_t k = 0; k < fine.zone_boundaries().size(); ++k)
    covered(rough.zone_boundaries()[k], fine.zone_boundaries()[k]);
  CHECK(fine.dissipation().value ==
        approx(-fine.traction().value * creep + fine.load().value * fine.rolling_resistance().value, 1e-8));
}

TEST_CASE("slip falls like a power of the distance from the boundary behind which it begins") {
  const auto nip = fast::partial_slip_for_load(unit_nip(0.3, 0.2, GivenTraction{-0.1}), 1, 1e-11);
  REQUIRE(nip.zone_signs()[2] != 0);
  const auto slip_at = [&](double distance) {
    return nip.slip(nip.zone_boundaries()[2].value - distance * nip.contact_length().value);
  };
  const fast::Estimate near = slip_at(1e-9), farther = slip_at(1e-8), far = slip_at(1e-7);
  const double expected = farther.value * farther.value / far.value;
  CHECK(std::fabs(near.value - expected) <= near.error + farther.error);
}

TEST_CASE("no traction is larger than the peak, and the two humps of a shear are told apart") {
  // The higher hump has the smaller values at the samples.
  const double load = fast::load_guess(0.486);
  const auto nip =
      fast::partial_slip_for_load(unit_nip(0.1742793, 0.76, GivenTraction{-1e-4 * load}), load, 1e-4);
  const double leading = nip.leading_length().value, length = nip.contact_length().value;
  double largest = 0;
  for (int i = 1; i < 4000; ++i)
    largest = std::max(largest, std::fabs(nip.shear(leading - i * length / 4000).value));
  CHECK(nip.peak_shear().value >= largest * (1 - 1e-6));
  const fast::Estimate there = nip.shear(nip.peak_shear_position().value);
  CHECK(std::fabs(there.value) == approx(nip.peak_shear().value, 1e-6));
}

TEST_CASE("a peak that is nearer to a boundary than all samples is seen") {
  // The shear still rises over the first 1e-9 of the slip zone.
  constexpr double length = 2.8751e-4, mu = 0.5013;
  const auto peak = [&](double accuracy) {
    const double traction = 0.167 * mu * fast::load_guess(length / 2);
    return fast::partial_slip_for_length(unit_nip(0.4999, mu, GivenTraction{traction}), length, accuracy)
        .peak_shear();
  };
  const fast::Estimate rough = peak(1e-5), fine = peak(1e-12);
  CHECK(std::fabs(rough.value - fine.value) <= rough.error + fine.error);
  CHECK(rough.error < 1e-6 * rough.value);
}

TEST_CASE("a peak at a boundary is the limit of the tractions from both sides") {
  // The shear falls like the distance to the power 0.14: at a distance of e^-72 panels it is already 4e-5 smaller.
  constexpr double mu = 3, load = std::numbers::pi * 0.05 * 0.05;
  const auto nip =
      fast::partial_slip_for_load(unit_nip(-0.8, mu, GivenTraction{-0.1 * mu * load}), load, 1e-10);
  const double boundary = nip.zone_boundaries()[2].value, length = nip.contact_length().value;
  double limits = 0;
  for (const int side : {1, -1}) {
    const auto beside = [&](double part) {
      return std::fabs(nip.shear(boundary + side * part * length).value);
    };
    // Aitken's limit of a geometric sequence.
    const double first = beside(1e-4), second = beside(1e-6), third = beside(1e-8);
    limits += third - std::pow(third - second, 2) / (third - 2 * second + first);
  }
  CHECK(nip.peak_shear().value == approx(limits / 2, 5e-6));
}

TEST_CASE("where elements slip by turns the zones are found from a contact that sticks, with few unknowns") {
  constexpr double mu = 1.76, load = 0.1;
  const auto nip =
      fast::partial_slip_for_load(unit_nip(-0.64, mu, GivenTraction{-0.022 * mu * load}), load, 1e-4);
  CHECK(nip.zone_signs() == std::vector<int>{1, 0, -1, 0, 1});
  CHECK(nip.work().unknowns < 600);
}

TEST_CASE("where rounding hides zones at the best accuracy they are found with fewer unknowns") {
  const auto at = [&](double accuracy) {
    const auto nip = unit_nip(0.49967764114262536, 0.005956993763902574, GivenTraction{0});
    return fast::partial_slip_for_length(nip, 0.06724732002217584, accuracy);
  };
  const auto best = at(1e-13), usual = at(1e-8);
  CHECK(best.zone_signs() == usual.zone_signs());
  CHECK(std::fabs(best.load().value - usual.load().value) <= best.load().error + usual.load().error);
}

TEST_CASE(
    "the shear has the sign of the slip up to the trailing end, where slip turns around within 2e-5 of the contact") {
  const auto nip = fast::partial_slip_for_load(
      {{281, 0.322, {75372, 0.43954}}, 0.011975, GivenTraction{-1.23208e-6}}, 1.03754e-4, 1e-7);
  const double end = -nip.trailing_length().value;
  for (const double share : {0.01, 1e-4, 1e-6, 1e-8}) {
    CAPTURE(share);
    const double y = end + share * nip.contact_length().value;
    const Estimate slip = nip.slip(y);
    CHECK((std::fabs(slip.value) <= slip.error || slip.value * nip.shear(y).value > 0));
  }
}

TEST_CASE("next to full slip the creep's error covers what a rounding of the traction changes") {
  constexpr double mu = 0.77, load = 3.24e-5;
  for (const double left : {2.6e-7, 2.8e-7, 3e-7, 3.2e-7, 3.4e-7}) {
    const auto creep_at = [&](int units) {
      const GivenTraction drive{-(1 - left) * mu * load * (1 + units * 0x1p-52)};
      return fast::partial_slip_for_load({{20, 0.016, {1.05, -0.07}}, mu, drive}, load, 7e-13).creep_ratio();
    };
    const Estimate creep = creep_at(0);
    for (const int units : {-2, -1, 1, 2}) {
      const Estimate other = creep_at(units);
      CHECK(std::fabs(other.value - creep.value) <= creep.error + other.error);
    }
  }
}

TEST_CASE("zones that a solution leaves out change it by no more than it says") {
  // Slip changes its direction in the last 7e-4 of the contact, and with it the exponent of the pressure there.
  const fast::PartialSlipTask task{
      .beta = 0.721047, .friction = 1.60433, .length = 0.175086, .traction = 0.00349224};
  const fast::ZoneContact right = fast::find_zones(task, 26).value();
  fast::Zones without_turn = right.zones();
  REQUIRE(without_turn.size() == 5);
  without_turn.resize(3);
  const auto rough =
      fast::with_differences(task, fast::ZoneContact::solved(task, without_turn, 20).value(), 17, {}).value();
  CHECK(rough.lack_zones());
  CHECK(rough.relative < 5e-3);
  CHECK(std::fabs(rough.second.creep() - right.creep()) <= rough.relative * right.length());
  CHECK(std::fabs(rough.second.load() - right.load()) <= rough.relative * right.load());
  for (std::size_t i = 0; i < rough.second.samples().size(); ++i) {
    const auto& sample = rough.second.samples()[i];
    if (sample.e < 0.9 * right.length() || rough.second.length() - sample.e < 1e-3 * right.length()) continue;
    CHECK(std::fabs(sample.pressure - right.traction(sample.e).pressure) <=
          rough.wrong_tractions[i].pressure + rough.relative * right.load() / right.length());
  }
}

TEST_CASE("what friction cannot pass on, and other nonsense, is refused") {
  const auto solve = [](double friction, const data::Drive& drive, double load) {
    return
        [=] { return fast::partial_slip_for_load(unit_nip(0.3, friction, drive), load, 1e-6).load().value; };
  };
  CHECK(contains(refusal_of(solve(0.1, GivenTraction{0.1}, 1)),
                 "less in size than the friction coefficient times the load"));
  CHECK(contains(refusal_of(solve(0, GivenTraction{0}, 1)), "friction_coefficient = 0"));
  CHECK(contains(refusal_of(solve(0.1, GivenCreep{NAN}, 1)), "creep_ratio = nan"));
  CHECK(contains(refusal_of(solve(0.1, GivenTraction{0}, 1e4)), "10 sheet thicknesses"));
}
