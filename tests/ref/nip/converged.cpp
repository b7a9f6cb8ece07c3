// Converged contacts in multiprecision, of every kind: against the double path, each other and themselves.

#include "support/covered.hpp"
#include "support/nip_kinds.hpp"
#include "support/softening_sheet.hpp"
#include "support/thesis_nips.hpp"

using namespace nipref;
using namespace nipref::test;
using data::ElasticNip, data::Friction, data::ViscoelasticNip;

namespace {

/// A nip with the relaxation lengths `way` and 3 `way`, whose compliances grow by the part `growth`.
ViscoelasticNip rolled_nip(double thickness, double way, double growth) {
  const data::MaterialFunction theta1{9e-6, {{9e-6 * growth / way, 1 / way}}};
  const data::MaterialFunction theta2{3e-6, {{1e-6 * growth / way, 1 / (3 * way)}}};
  return {6, thickness, data::ViscoelasticMaterial(theta1, theta2), 1};
}

/// A nip with the real rate 0.5/`way` and conjugate rates, whose imaginary part is `swing` times the real part 1/`way`.
ViscoelasticNip swinging_nip(double thickness, double way, double swing) {
  const auto function = [&](double compliance) -> data::MaterialFunction {
    const std::complex<double> amplitude{compliance * 0.1 / way, -compliance * 0.05 / way};
    const std::complex<double> rate{1 / way, swing / way};
    return {
        compliance,
        {{compliance * 0.2 / way, 0.5 / way}, {amplitude, rate}, {std::conj(amplitude), std::conj(rate)}}};
  };
  return {6, thickness, data::ViscoelasticMaterial(function(9e-6), function(3e-6)), 1};
}

Places places_of(double length) { return {-0.7 * length, 0.3 * length}; }

void check_covered(const Numbers<ref::Estimate>& truth, const Numbers<fast::Estimate>& computed) {
  for (const auto& [name, estimate] : computed) {
    CAPTURE(name, estimate.value);
    fast::Estimate rounded = estimate;
    rounded.error += 1e-16 * std::fabs(estimate.value);
    CHECK(is_covered(rounded, truth.at(name)));
  }
}

void check_meet(const Numbers<ref::Estimate>& few, const Numbers<ref::Estimate>& many) {
  for (const auto& [name, fine] : many) {
    CAPTURE(name);
    CHECK(meet(few.at(name), fine));
  }
}

}  // namespace

TEST_CASE("ref contact: the double path's estimates cover what they are off by at random nips of each kind") {
  std::mt19937_64 generator(11);
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, static_cast<double>(generator() >> 11) * 0x1p-53);
  };
  for (int i = 0; i < random_contacts(3); ++i) {
    const double poisson = i == 0 ? 0.5 : 1.4 - between(0.9001, 2.3), thickness = between(0.4, 2.7);
    const double length = thickness * between(1e-6, 2), accuracy = between(1e-11, 1e-3);
    const ElasticNip nip = nip_of(poisson, thickness, 100 * thickness);
    const double memory = 0.1 * between(0.3, 1e5);
    for (const auto& [kind, L] :
         {std::pair(gripped(nip), length),
          {frictionless(nip), length},
          {rolling(i % 2 == 0 ? rolled_nip(0.25, memory, 2) : swinging_nip(0.25, memory, 1.5)), 0.1}}) {
      if (kind.name == "rolling" && i > 1) continue;
      CAPTURE(kind.name, poisson, L);
      const auto computed = numbers_of(kind.fast_of_length(L, accuracy), places_of(L));
      check_covered(numbers_of(kind.of_length(L, 16), places_of(L)), computed);
      if (i > 1 || kind.name == "rolling") continue;
      const double load = computed.at("load").value;
      check_covered(numbers_of(kind.of_load(load, 16), places_of(L)),
                    numbers_of(kind.fast_of_load(load, accuracy), places_of(L)));
    }
  }
}

TEST_CASE("ref contact: random ones are proven, digits and panels meet, double is within its errors") {
  std::mt19937_64 random(random_seed(7));
  int softened = 0, proven = 0;
  for (int i = 0; i < random_contacts(3); ++i) {
    const double length = between(1e-3, 4, random), memory = length * between(0.1, 1e2, random);
    const ElasticNip nip{100, 1, {1, i == 0 ? 0.5 : 1.4 - between(0.9, 2.3, random)}};
    const auto softening =
        i % 3 == 0 ? data::standard_linear_solid({1, between(0.5, 2, random), 2, 3, memory, 2 * memory})
                   : data::single_relaxation_time_solid(1, 0.375, memory, i % 3);
    const Places places{-0.4 * length, 0.4999 * length};
    for (const Kind& kind : {gripped(nip), rolling(ViscoelasticNip{100, 1, softening, 1})}) {
      CAPTURE(i, kind.name, length);
      const bool is_rolling = kind.name == "rolling";
      if (!is_rolling && i == 1) continue;
      const auto few = numbers_of(kind.of_length(length, 16), places),
                 many = numbers_of(kind.of_length(length, 20), places);
      check_meet(few, many);
      check_covered(many, numbers_of(kind.fast_of_length(length, 1e-10), places));
      if (is_rolling) {
        ++softened;
        proven += few.at("load").proven ? 1 : 0;
      } else {
        const auto panels = ref::converged_for_length(nip, Friction::full, length, 20, 0);
        CHECK_FALSE(panels.load().proven);
        check_meet(numbers_of(panels, places), many);
      }
      for (const auto& [name, number] : few) {
        CAPTURE(name);
        if (is_rolling && (contains(name, "creep") || contains(name, "tangential"))) continue;
        CHECK(number.proven == many.at("load").proven);
        CHECK(many.at(name).proven == many.at("load").proven);
        const bool may_be_small =
            contains(name, "displacement") || contains(name, "shear") || contains(name, "creep");
        if (!is_rolling && !may_be_small) CHECK(error(number) <= 1e-16 * std::fabs(number.to_double()));
      }
    }
  }
  MESSAGE(proven, " of ", softened, " rolling ones are proven");
  CHECK(3 * proven >= 2 * softened);
}

TEST_CASE("ref contact: more digits stay within the error, of a length and of a load") {
  struct Row {
    Kind kind;
    double length, load;
    int few, many;
  };
  const std::vector<Row> rows{{gripped(nip_of(0.1)), 0.75, 20, 16, 24},
                              {frictionless(nip_of(0.1)), 0.75, 20, 18, 30},
                              {rolling(rolled_nip(0.25, 0.1, 2)), 0.1, 60, 16, 24}};
  for (const auto& [kind, length, load, few, many] : rows) {
    CAPTURE(kind.name);
    const Places places{0.39 * length};
    const auto check = [&](const ref::ConvergedNip& coarse, const ref::ConvergedNip& fine) {
      const auto rough = numbers_of(coarse, places), good = numbers_of(fine, places);
      check_meet(rough, good);
      for (const auto& [name, number] : good) CHECK(error(number) <= 1e-7 * error(rough.at(name)) + 1e-300);
      CHECK(fine.unknowns() > coarse.unknowns());
      CHECK(fine.kernel_values().normal > coarse.kernel_values().normal);
      CHECK(fine.kernel_values().coupling > coarse.kernel_values().coupling);
      CHECK(fine.kernel_values().stretch >= coarse.kernel_values().stretch);
    };
    check(kind.of_length(length, few), kind.of_length(length, many));
    if (kind.name == "frictionless") check(kind.of_load(load, few), kind.of_load(load, many));
  }
  CHECK(rows[1].kind.of_length(0.75, 18).kernel_values().coupling == 0);
  CHECK(rows[0].kind.of_length(0.75, 16).kernel_values().stretch > 0);
}

TEST_CASE("ref contact: bounds of 20, 30 and 40 digits meet, keep the digits and lie within fast's") {
  const Kind kind = frictionless({1000, 2, {3, 0.2}});
  for (const double A : {1e-8, 1e-6, 1e-3, 0.1, 0.5, 1.0, 3.0}) {
    CAPTURE(A);
    const Places places{0.25 * A, 0.5 * A, 0.875 * A, A, 1.125 * A, 2.5 * A};
    const auto at = [&](int digits) { return numbers_of(kind.of_length(2 * A, digits), places); };
    const auto thirty = at(30), forty = at(40);
    check_meet(at(20), thirty);
    check_meet(thirty, forty);
    const double largest_displacement = thirty.at("indentation").to_double() * std::fmax(A, 1);
    for (const auto& [name, truth] : thirty) {
      CAPTURE(name);
      const double size = name.find("displacement") != std::string::npos ? largest_displacement
                                                                         : std::fabs(truth.to_double());
      CHECK(truth.proven);
      CHECK(error(truth) <= 1e-30 * size);
      CHECK(error(forty.at(name)) <= 1e-40 * size);
    }
    check_covered(thirty, numbers_of(kind.fast_of_length(2 * A, 1e-10), places));
  }
}

TEST_CASE("ref contact: without friction and memory it is one, by the proof, by panels and rolled") {
  struct Row {
    ElasticNip nip;
    double length;
  };
  for (const auto& [nip, length] : {Row{nip_of(0.3), 0x1p-10}, Row{quarter_inch_nip, 0.15},
                                    Row{nip_of(0.3), 1.5}, Row{nip_of(0.3), 26.0}}) {
    CAPTURE(length);
    Places places{length / 8, length / 2};
    if (length < 2) places.push_back(-1.3 * length);
    const auto proven = ref::converged_for_length(nip, Friction::none, length, length < 2 ? 30 : 20);
    const auto panels = ref::converged_for_length(nip, Friction::none, length, 18, 0);
    const auto truth = numbers_of(proven, places), by_panels = numbers_of(panels, places);
    check_meet(by_panels, truth);
    CHECK(truth.at("load").proven);
    for (const char* const name : {"load", "indentation", "creep_ratio", "peak_pressure"})
      CHECK(error(by_panels.at(name)) <= 1e-17 * std::fabs(truth.at(name).to_double()));
    CHECK(difference(panels.surface_strain(length / 8), proven.surface_strain(length / 8)) <=
          error(panels.surface_strain(length / 8)));
    CHECK_REFUSED(panels.peak_shear_position(), "must be full");
    if (length > 1) continue;  // would take long
    const ViscoelasticNip rolled{nip.roller_radius, nip.sheet_thickness, data::elastic_solid(nip.material),
                                 1};
    const auto by_rolling = numbers_of(ref::converged_for_length(rolled, length, 20), places);
    check_meet(by_rolling, truth);
    CHECK(std::fabs(by_rolling.at("rolling_resistance").to_double()) <= 1e-20);
  }
}

TEST_CASE("ref contact: a memory that fades slowly is none, and conjugate rates tend to two real ones") {
  const double length = 0.1, way = 1e6;
  const auto slow = ref::converged_for_length(test::nip(way), length, 16),
             proven = ref::converged_for_length(test::elastic(1), Friction::none, length, 16);
  // The difference is of first order in the contact length over the relaxation length.
  const double near = 5 * length / way;
  CHECK(difference(slow.load(), proven.load()) <= near * proven.load().to_double());
  CHECK(difference(slow.creep_ratio(), proven.creep_ratio()) <= near * length / test::radius);
  const auto still = [](double compliance) -> data::MaterialFunction {
    return {compliance, {{compliance * 0.2 / 0.2, 0.5 / 0.2}, {compliance * 0.2 / 0.2, 1 / 0.2}}};
  };
  const ViscoelasticNip real{6, 0.25, data::ViscoelasticMaterial(still(9e-6), still(3e-6)), 1};
  const auto swung = ref::converged_for_length(swinging_nip(0.25, 0.2, 1e-9), length, 16),
             merged = ref::converged_for_length(real, length, 16);
  CHECK(difference(swung.load(), merged.load()) <= 1e-8 * merged.load().to_double());
  CHECK(difference(swung.creep_ratio(), merged.creep_ratio()) <=
        1e-8 * std::fabs(merged.creep_ratio().to_double()));
}

TEST_CASE("ref contact: the length of a load is that whose load it is") {
  struct Row {
    Kind kind;
    double length;
    int digits;
  };
  const ElasticNip nip{1000, 2, {3, 0.2}};
  for (const auto& [kind, length, digits] :
       {Row{frictionless(nip), 0.002, 30}, Row{frictionless(nip), 0.5, 30}, Row{frictionless(nip), 6, 30},
        Row{gripped(nip_of(0.3)), 0x1p-10, 20}, Row{gripped(nip_of(0.3)), 0.5, 16},
        Row{rolling(rolled_nip(0.25, 0.1, 2)), 0.1, 16}}) {
    CAPTURE(kind.name, length);
    const auto there = kind.of_length(length, digits);
    const double load = there.load().to_double(), least = std::pow(10, -digits);
    const auto back = kind.of_load(load, digits);
    CHECK(std::fabs(back.load().error_of(load)) <= error(back.load()));
    CHECK(error(back.contact_length()) <= 4 * least * length);
    CHECK(back.contact_length().proven);
    // ln W grows 2 to 3 times as fast as ln L, but less fast for a sheet that softens as it rolls.
    const double of_load = -there.load().error_of(load) / load;
    const double of_length = -back.contact_length().error_of(length) / length;
    CHECK(std::fabs(of_length) <= std::fabs(of_load) / (kind.name == "rolling" ? 1 : 2) + 10 * least);
    CHECK(std::fabs(of_length) >= std::fabs(of_load) / 3 - 10 * least);
    if (digits == 30) CHECK(of_load * of_length < 0);
  }
}

TEST_CASE("ref contact: tractions end with it, and displacements go on as they were") {
  for (const auto& of : {frictionless, gripped}) {
    const auto contact = of(nip_of(0.3)).of_length(0.5, 16);
    const double end = 0.25, creep = contact.creep_ratio().to_double();
    CHECK(error(contact.pressure(end)) == 0);
    CHECK(contact.pressure(end).to_double() == 0);
    // With friction the pressure oscillates at the end.
    if (error(contact.peak_shear()) == 0) CHECK(contact.pressure(end * (1 - 0x1p-52)).to_double() > 0);
    CHECK(contact.pressure(1e300).to_double() == 0);
    CHECK(contact.shear(-0.3).to_double() == 0);
    CHECK(contact.shear(0).to_double() == 0);
    CHECK(contact.shear(-0.1).to_double() == -contact.shear(0.1).to_double());
    CHECK(contact.tangential_displacement(-0.4).to_double() ==
          -contact.tangential_displacement(0.4).to_double());
    CHECK(difference(contact.pressure(0.05), contact.pressure(-0.05)) <= error(contact.pressure(0.05)));
    // Displacements beyond the end are by quadrature, displacements before it in closed form.
    const double step = 0x1p-40;
    const double edge = contact.leading_displacement().to_double();
    CHECK(difference(contact.normal_displacement(end), contact.leading_displacement()) <=
          2 * error(contact.normal_displacement(end)));
    CHECK(contact.normal_displacement(end + step).to_double() == doctest::Approx(edge).epsilon(1e-11));
    CHECK(contact.tangential_displacement(end + step).to_double() ==
          doctest::Approx(creep * end).epsilon(1e-6));
    // At the end u' = -2y/(2R). Beyond it u' changes like the root of the distance, so that u'' is infinite.
    const double slope =
        difference(contact.normal_displacement(end + step), contact.leading_displacement()) / step;
    CHECK(slope == doctest::Approx(end / 1e3).epsilon(1e-4));
  }
}

TEST_CASE("ref contact: the strain is as sure next to the ends as elsewhere, and goes on from the creep") {
  struct Row {
    Kind kind;
    double length, radius;
    double per_root;  // at a distance from the ends strain - creep is at most this times its root
  };
  const Kind grip = gripped(nip_of(0.3)), swinging = rolling(swinging_nip(0.25, 0.2, 1.5));
  for (const auto& [kind, length, radius, per_root] :
       {Row{grip, 0.01, 1e3, 10}, Row{grip, 3, 1e3, 10}, Row{swinging, 0.1, 6, INFINITY}}) {
    const auto truth = kind.of_length(length, 16);
    const auto computed = kind.fast_of_length(length, 1e-12);
    const double leading = truth.leading_length().to_double(), trailing = truth.trailing_length().to_double(),
                 size = length / radius;
    for (const double beyond : {0x1p-46, 1e-10, 1e-5, 0.05, 2.0}) {
      for (const double y : {leading + beyond * length, -trailing - beyond * length}) {
        CAPTURE(length, y);
        const ref::Estimate strain = truth.surface_strain(y);
        CHECK(error(strain) <= 1e-16 * size);
        CHECK(is_covered(computed.surface_strain(y), strain));
        CHECK(std::fabs(strain.to_double() - truth.creep_ratio().to_double()) <=
              per_root * std::sqrt(2 * beyond) * size);
      }
    }
  }
}

TEST_CASE("ref contact: no place inside has more shear than the greatest, where one is nearly as high") {
  const auto contact = gripped({1000, 1, {1, -0.503285}}).of_length(2, 16);
  // The first place has 3.4e-8 more shear than the second, from which a search does not find it.
  const std::array<ref::InnerPoint, 2> places{{{0, 0.8813416}, {0, 1}}};
  const auto stresses = contact.inner_stresses(places);
  const ref::GreatestShear greatest = contact.greatest_shear();
  for (const ref::InnerStresses& there : stresses) {
    const ref::Estimate shear = there.maximum_shear();
    CHECK(greatest.value.value + greatest.value.error >= shear.value - shear.error);
  }
}

TEST_CASE("ref contact: what it cannot give is refused by name") {
  const Kind free = frictionless(quarter_inch_nip), grip = gripped(nip_of(0.3)),
             rolled = rolling(rolled_nip(0.25, 0.1, 2));
  const data::ViscoelasticMaterial ringing = data::operator_solid({{200, 1, 1}, {100, 1, 1}, {1}, {10}});
  const auto contact = free.of_length(0.2, 16);
  CHECK_REFUSED(free.of_length(7, 30), "contact_length = 7: ");
  CHECK_REFUSED(free.of_load(-1, 30), "load = -1: ");
  CHECK_REFUSED(free.of_load(1, 101), "digits = 101: ");
  CHECK_REFUSED(contact.normal_displacement(113), "y = 113: ");
  CHECK_REFUSED(contact.tangential_displacement(NAN), "y = nan: ");
  CHECK_REFUSED(contact.pressure(NAN), "y = nan: ");
  // These loads are too small or too large for a double once they are dimensionless.
  CHECK_REFUSED(free.of_load(5e-324, 30), "load = ");
  CHECK_REFUSED(frictionless({6, 0.25, {1e-60, 0.3}}).of_load(1e308, 30), "load = ");
  CHECK_REFUSED(grip.of_length(0.5, 15), "digits = 15: ");
  CHECK_REFUSED(grip.of_length(0.5, 101), "digits = 101: ");
  CHECK_REFUSED(grip.of_length(1e-9, 16), "contact_length = ");
  CHECK_REFUSED(grip.of_length(1001, 16), "contact_length = 1001: ");
  CHECK_REFUSED(grip.of_load(0, 16), "load = 0: ");
  CHECK_REFUSED(grip.of_load(NAN, 16), "load = nan: ");
  CHECK_REFUSED(rolled.of_length(0.1, 15), "digits = 15: ");
  CHECK_REFUSED(rolled.of_length(7, 16), "contact_length = 7: ");
  CHECK_REFUSED(rolled.of_load(-1, 16), "load = -1: ");
  CHECK_REFUSED(rolled.of_load(1e9, 16), "load = 1000000000: gives");
  CHECK_REFUSED(rolling(rolled_nip(0.25, 1e-11, 1)).of_length(0.1, 16), "nip.material = ");
  CHECK_REFUSED(rolling({6, 0.25, ringing, 1}).of_length(0.1, 16), "nip.material = 19.97");
  CHECK_REFUSED(frictionless(nip_of(0.3, 0.0002)).of_length(0.0162, 16).greatest_shear(),
                "contact_length = 0.0162");
  // No number of the proof's terms suffices here.
  CHECK(ref::proven_terms({1000, 2, {1, 0.3}}, Friction::none, 150, 60) == 0);
}
