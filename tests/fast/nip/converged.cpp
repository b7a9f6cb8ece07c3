// Properties of the converged contact of every kind of nip.
#include "support/covered.hpp"
#include "support/nip_kinds.hpp"
#include "support/softening_sheet.hpp"

using namespace nipref;
using namespace nipref::test;
using data::Friction;

namespace {

std::vector<Kind> kinds() {
  const auto nip = [](double thickness, double poisson) -> data::ElasticNip {
    return {radius, thickness, {bulk, poisson}};
  };
  return {frictionless(nip(0.25, 0.3)), frictionless(nip(0.002, 0.5)), gripped(nip(1, -0.8)),
          gripped(nip(0.02, 0.45)),     gripped(nip(0.25, 0.5)),       rolling(test::nip(3)),
          rolling(test::nip(0.1)),      rolling(test::nip(0.004))};
}

}  // namespace

TEST_CASE("error estimates cover the error and are not idle, of every kind of nip and a length or a load") {
  for (const Kind& kind : kinds()) {
    const auto best = kind.fast_of_load(load, 1e-13);
    const double length = best.contact_length().value;
    const Places places{-0.9 * length, -0.2 * length, 0.3 * length};
    const auto truth = numbers_of(best, places);
    for (const double accuracy : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
      const auto check = [&](const fast::ConvergedNip& contact) {
        for (const auto& [name, found] : numbers_of(contact, places)) {
          CAPTURE(kind.name, name, accuracy);
          check_covered(found, truth.at(name));
          const bool may_be_small =
              contains(name, "shear") || contains(name, "creep") || contains(name, "displacement");
          if (!may_be_small)
            CHECK(found.error <= 100 * accuracy * std::max(std::fabs(truth.at(name).value), 1e-2 * load));
        }
        CHECK(contact.contact_length().value == approx(length, accuracy));
      };
      check(kind.fast_of_load(load, accuracy));
      check(kind.fast_of_length(length, accuracy));
    }
  }
}

TEST_CASE("asking for less costs less, and no more is evaluated than is asked for, of every kind of nip") {
  for (const Kind& kind : kinds()) {
    CAPTURE(kind.name);
    const auto coarse = kind.fast_of_load(100, 1e-4), fine = kind.fast_of_load(100, 1e-11);
    CHECK(coarse.work().terms <= fine.work().terms);
    CHECK(coarse.work().unknowns <= fine.work().unknowns);
    if (kind.name == "gripped") continue;  // one discretisation may serve both
    CHECK((coarse.work().terms < fine.work().terms || coarse.work().unknowns < fine.work().unknowns));
    if (kind.name == "rolling") continue;
    static_cast<void>(
        fine.peak_pressure());  // also solves a longer contact, to see how numbers change with the length
    const auto before = fine.work();
    static_cast<void>(fine.indentation());
    CHECK(fine.work().terms == before.terms);
    for (const std::size_t tangential : {1U, 2U, 3U, 4U, 5U, 6U})
      CHECK(before.kernel_evaluations[tangential] == 0);
    static_cast<void>(fine.creep_ratio());
    CHECK(fine.work().kernel_evaluations[2] > 0);
    CHECK(fine.work().kernel_evaluations[5] == 0);
  }
}

TEST_CASE("displacements go on where the sheet leaves the roller and tractions end, of every kind of nip") {
  for (const Kind& kind : kinds()) {
    CAPTURE(kind.name);
    const auto contact = kind.fast_of_load(load, 1e-10);
    const double size = contact.indentation().value, inside = 0.3 * contact.contact_length().value;
    if (kind.name != "rolling") {
      CHECK(contact.pressure(-inside).value == contact.pressure(inside).value);
      CHECK(contact.shear(-inside).value == -contact.shear(inside).value);
      CHECK(contact.tangential_displacement(-3 * inside).value ==
            -contact.tangential_displacement(3 * inside).value);
    }
    for (const double end : {contact.leading_length().value, -contact.trailing_length().value}) {
      const double beyond = end * (1 + 1e-9), before = end * (1 - 1e-9);
      CHECK(std::fabs(contact.normal_displacement(beyond).value - contact.normal_displacement(before).value) <
            1e-6 * size);
      CHECK(std::fabs(contact.tangential_displacement(beyond).value -
                      contact.tangential_displacement(before).value) < 1e-6 * size);
      CHECK(contact.pressure(1.1 * end).value == 0);
      CHECK(contact.shear(1.1 * end).value == 0);
    }
  }
}

TEST_CASE("bad input to converged contacts is refused by name, of every kind of nip") {
  for (const Kind& kind : kinds()) {
    CAPTURE(kind.name);
    for (const double bad : {-1.0, 0.0, not_a_number, HUGE_VAL, 1e12})
      CHECK_REFUSED(kind.fast_of_load(bad, 1e-6), "load");
    for (const double bad : {-1.0, 0.0, not_a_number, 1.01 * radius, 1e-12})
      CHECK_REFUSED(kind.fast_of_length(bad, 1e-6), "contact_length");
    for (const double bad : {0.0, 1e-14, 0.5, not_a_number})
      CHECK_REFUSED(kind.fast_of_load(1, bad), "accuracy");
    CHECK_REFUSED(kind.fast_of_length(0.1, 1e-6).pressure(not_a_number), "y");
  }
  CHECK_THROWS_AS(fast::converged_for_load({6, 0, {1, 0.3}}, Friction::none, 1, 1e-6), data::BadInput);
  CHECK_THROWS_AS(fast::converged_for_load({6, 1, {1, 0.51}}, Friction::none, 1, 1e-6), data::BadInput);
  auto standing = test::nip(0.1);
  standing.speed = 0;
  CHECK_THROWS_AS(fast::converged_for_length(standing, 0.1, 1e-6), data::BadInput);
}
