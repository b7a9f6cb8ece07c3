// Line loads with Coulomb's friction: their conditions, computed without their system; their limit, the contact.
#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/fast/partial_slip/line_loads.hpp>
#include <nipref/fast/partial_slip/partial_slip.hpp>

#include "support/test.hpp"

using namespace nipref;

namespace {

constexpr double friction_here = 0.1, load_here = 100;

data::PartialSlipNip slipping_seed_nip(double traction) {
  return {data::seed::nip(0.25), friction_here, data::GivenTraction{traction}};
}

/// The mean of a function over the element about `middle`, where the function may have a logarithmic singularity.
double mean_over_element(double middle, double width, const std::function<double(double)>& function) {
  constexpr int points = 200;
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    const double s = (i + 0.5) / points, aside = width / 2 * s * s;
    sum += s / points * (function(middle + aside) + function(middle - aside));
  }
  return sum;
}

}  // namespace

TEST_CASE("line loads meet the roller in the mean of each element, and Coulomb's conditions") {
  for (const double traction : {-7.0, 0.0, 5.0}) {
    CAPTURE(traction);
    const auto nip = fast::line_loads_for_load(slipping_seed_nip(traction), 12, load_here);
    const double width = nip.element_width(), depth = nip.indentation;
    CHECK(nip.load() == approx(load_here, 1e-12));
    CHECK(nip.traction() == doctest::Approx(traction).scale(1).epsilon(1e-12));
    const auto by_creep = fast::line_loads_for_load(
        {data::seed::nip(0.25), friction_here, data::GivenCreep{nip.creep_ratio()}}, 12, load_here);
    CHECK(by_creep.traction() == doctest::Approx(traction).scale(1).epsilon(1e-9));
    const auto along = [&](double middle) {
      return mean_over_element(middle, width, [&](double y) { return nip.tangential_displacement(y); });
    };
    const double size = std::fabs(nip.creep_ratio()) * width;
    std::size_t zone = 0;
    for (const fast::FaceLoad& load : nip.loads) {
      CAPTURE(load.y);
      CHECK(mean_over_element(load.y, width, [&](double y) {
              return nip.normal_displacement(y) + y * y / (2 * nip.roller_radius);
            }) == approx(depth, 1e-4));
      CHECK(load.normal > 0);
      if (load.y < nip.zone_boundaries[zone + 1]) ++zone;
      const int sign = nip.zone_signs[zone];
      const double slip = along(load.y + width) - along(load.y) - nip.creep_ratio() * width;
      if (sign == 0) {
        CHECK(std::fabs(slip) < 0.02 * size);
        CHECK(std::fabs(load.shear) <= friction_here * load.normal);
      } else {
        CHECK(load.shear == approx(sign * friction_here * load.normal, 1e-14));
        CHECK(slip * sign > -0.02 * size);
      }
    }
    CHECK(zone + 1 == nip.zone_signs.size());
    CHECK(nip.zone_boundaries.size() == nip.zone_signs.size() + 1);
    CHECK(nip.zone_boundaries.front() == approx(nip.leading_length, 1e-12));
    CHECK(nip.zone_boundaries.back() == approx(-nip.trailing_length(), 1e-12));
  }
}

TEST_CASE("line loads tend to the contact with Coulomb's friction") {
  for (const double traction : {-7.0, 0.0, 5.0}) {
    CAPTURE(traction);
    const auto truth = fast::partial_slip_for_load(slipping_seed_nip(traction), load_here, 1e-8);
    const auto creep_error = [&](const fast::LineLoadNip& nip) {
      return std::fabs(nip.creep_ratio() / truth.creep_ratio().value - 1);
    };
    const auto at = [&](int elements) {
      auto nip = fast::line_loads_for_load(slipping_seed_nip(traction), elements, load_here);
      CHECK(std::fabs(nip.contact_length() - truth.contact_length().value) < 1.5 * nip.element_width());
      CHECK(std::fabs(nip.leading_length - truth.leading_length().value) < nip.element_width());
      return nip;
    };
    for (const int elements : {20, 40, 80, 160})  // error like the square of the elements' width
      CHECK(creep_error(at(elements)) < 20.0 / (elements * elements));
    const auto fine = at(160);
    CHECK(std::fabs(fine.indentation / truth.indentation().value - 1) < 1e-4);
    CHECK(fine.zone_signs == truth.zone_signs());
    CHECK(fine.dissipation() == doctest::Approx(truth.dissipation().value).epsilon(0.03));
  }
}

TEST_CASE(
    "midway between shear loads of alternating sign the sheet is still, in the mean of elements it is not") {
  const auto nip = fast::line_loads_for_load(slipping_seed_nip(0), 20, load_here);
  const double width = nip.element_width();
  std::vector<fast::FaceLoad> loads;
  for (int k = -20; k <= 20; ++k) loads.push_back({k * width, 0, k % 2 == 0 ? 1.0 : -1.0});
  fast::Work work;
  const auto at = [&](double y) { return nip.sheet(fast::FaceDirection::tangential, loads, y, work); };
  const double midway = at(1.5 * width) - at(0.5 * width);
  const double means = mean_over_element(width, width, at) - mean_over_element(0, width, at);
  CHECK(std::fabs(midway) < 1e-2 * std::fabs(means));
}

TEST_CASE("line loads with Coulomb's friction refuse what is outside their domain") {
  const auto solve = [](int elements, double traction) {
    return [=] { return fast::line_loads_for_load(slipping_seed_nip(traction), elements, load_here).load(); };
  };
  CHECK(contains(refusal_of(solve(0, 0)), "elements_per_side = 0: must be from 1 to 1000"));
  CHECK(contains(refusal_of(solve(1001, 0)), "elements_per_side = 1001"));
  CHECK(contains(refusal_of(solve(10, 10)), "force_per_length = 10: must be less"));
}

TEST_CASE("line loads refuse a contact that friction moves beyond their elements") {
  const data::PartialSlipNip nip{{50, 2, {152, 0.49}}, 1, data::GivenTraction{4}};
  const double load = 4.45,
               half = fast::partial_slip_for_load({nip, 1e-3, data::GivenTraction{0}}, load, 1e-4)
                          .leading_length()
                          .value;
  CHECK(fast::partial_slip_for_load(nip, load, 1e-4).leading_length().value > 1.3 * half);
  CHECK(contains(refusal_of([&] { return fast::line_loads_for_load(nip, 20, load).load(); }),
                 "elements_per_side = 20"));
}
