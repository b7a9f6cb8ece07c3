// The proof of the stresses inside contacts without friction.
#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/internal/proven_elastic.hpp>
#include <nipref/ref/nip/internal/proven_stresses.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/viscoelastic_nip/converged.hpp>

#include "support/intervals.hpp"
#include "support/reference_values.hpp"
#include "support/test.hpp"

using namespace nipref;
using ref::Interval;

namespace {

/// Places in the middle, beside an end, beyond it and far away; on the faces, next to them and in the middle plane.
std::vector<ref::InnerPoint> places_inside(double length) {
  std::vector<ref::InnerPoint> places;
  for (const auto& [share, depth] :
       {std::pair(0.0, 0.97), {0.3, -1.0}, {-0.4999, 0.0}, {0.5, 0.9}, {0.55, 1 - 1e-7}, {-1.7, -0.6}})
    places.push_back({share * length, depth});
  return places;
}

/// Checks that stresses of 16 digits are proven and meet those of 20 digits and estimates; that errors in double cover.
void check_stresses(const ref::ConvergedNip& few, const ref::ConvergedNip& many,
                    const ref::ConvergedNip* panels, const fast::ConvergedNip& computed, double length) {
  const auto places = places_inside(length);
  std::vector<fast::InnerPoint> same;
  for (const ref::InnerPoint& place : places) same.push_back({place.y, place.depth});
  const auto rough = few.inner_stresses(places), fine = many.inner_stresses(places),
             estimated = panels != nullptr ? panels->inner_stresses(places) : rough;
  const auto in_double = computed.inner_stresses(same);
  const double scale = few.load().to_double() / length;
  for (std::size_t i = 0; i < places.size(); ++i) {
    CAPTURE(places[i].y, places[i].depth);
    const auto check = [&](const auto& stress) {
      const ref::Estimate one = stress(rough[i]), truth = stress(fine[i]), other = stress(estimated[i]);
      CHECK(one.proven);
      CHECK(truth.proven);
      CHECK(meet(one, truth));
      CHECK(meet(other, truth));
      CHECK(error(one) <= 1e-16 * scale);
      CHECK(error(truth) <= 1e-20 * scale);
      const fast::Estimate found = stress(in_double[i]);
      CHECK(std::fabs(truth.error_of(found.value)) <= found.error + error(truth));
    };
    check([](const auto& of) { return of.across; });
    check([](const auto& of) { return of.along; });
    check([](const auto& of) { return of.shear; });
    check([](const auto& of) { return of.maximum_shear(); });
  }
}

}  // namespace

TEST_CASE("proven stresses inside meet those with more digits and the estimated, and those in double") {
  std::mt19937_64 random(random_seed(11));
  for (int i = 0; i < random_contacts(1); ++i) {
    const double length = between(1e-3, 4, random);
    CAPTURE(length);
    const data::ElasticNip elastic{100, 1, {1, 0.3}};
    const auto contact = [&](int digits, int most_terms) {
      return ref::converged_for_length(elastic, data::Friction::none, length, digits, most_terms);
    };
    const auto panels = contact(20, 0);
    check_stresses(contact(16, 500), contact(20, 500), &panels,
                   fast::converged_for_length(elastic, data::Friction::none, length, 1e-10), length);
    const double memory = length * between(0.3, 10, random);
    const data::ViscoelasticNip rolling{100, 1, data::single_relaxation_time_solid(1, 0.375, memory), 1};
    check_stresses(ref::converged_for_length(rolling, length, 16),
                   ref::converged_for_length(rolling, length, 20), nullptr,
                   fast::converged_for_length(rolling, length, 1e-10), length);
  }
}

TEST_CASE("proven stresses inside: a coefficient that is off by 1e-25 is outside, or its radius covers it") {
  const auto proof = ref::proven_elastic(ref::Exact(0.7), ref::Exact(0.0), 30, ref::I1_interval, 500);
  const ref::WorkingDigits working(proof->working_digits);
  const Interval off(1e-25, ref::working_bits());
  for (const double depth : {0.0, 0.9, 1.0}) {
    CAPTURE(depth);
    const auto across = [&](const ref::ProvenExpansion& pressure) {
      const ref::SurfacePoint place{Interval(0.8, ref::working_bits())};
      return ref::proven_stresses(pressure, place, ref::Exact(depth), 36)->across;
    };
    ref::ProvenExpansion other = *proof->contact->expansion();
    const Interval truth = across(other);
    other.coefficients[3] = other.coefficients[3] + off;
    CHECK_FALSE(meet(across(other), truth));
    other.radius = 3 * off;
    CHECK(is_inside(truth, across(other)));
  }
}

TEST_CASE("what bounds the sheet's field less that of both half-planes holds on a mesh, and its slope") {
  for (const double s : {0.0, 0.5, 0.9, 1.0}) {
    double bound = 0, slope = 0;
    const double step = 1e-3;
    for (double k = step / 2; k < 25; k += step) {
      const double S = std::sinh(2 * k) + 2 * k, rest = (1 + 2 * k - std::exp(-2 * k)) / S;
      const double a = 2 * std::sinh(k) / S, b = 2 * std::cosh(k) / S, C = std::cosh(s * k),
                   D = std::sinh(s * k);
      // Flamant's fields in waves: e^{-k d} (1 + k d), (1 - k d) and k d, from both faces.
      const double near = k * (1 - s), far = k * (1 + s), e = std::exp(-near), f = std::exp(-far);
      const double across = e * (1 + near) + f * (1 + far) - (a * C + k * b * C - s * k * a * D);
      const double along = e * (1 - near) + f * (1 - far) - (a * C - k * b * C + s * k * a * D);
      const double shear = k * b * D - s * k * a * C - (e * near - f * far);
      const double most = (3 + 4 * k) * rest + 1e-13 * (1 + k);
      for (const double symbol : {across, along, shear}) CHECK_UNARY(std::fabs(symbol) <= most);
      bound += step * (3 + 4 * k) * 2 * (1 + 2 * k) * std::exp(-2 * k) / std::numbers::pi;
      slope += step * k * (3 + 4 * k) * 2 * (1 + 2 * k) * std::exp(-2 * k) / std::numbers::pi;
    }
    const Interval taken = ref::sheet_rest(Interval(64));
    CHECK(mpfr_get_d(taken.lower(), MPFR_RNDN) == doctest::Approx(bound).epsilon(1e-5));
    CHECK(slope <= ref::sheet_rest_slope);
  }
}
