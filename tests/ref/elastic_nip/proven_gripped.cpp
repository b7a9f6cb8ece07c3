// The proof of the contact with full friction: that its bounds hold, that it notices errors, and what it rests on.
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/internal/proven_elastic.hpp>
#include <nipref/ref/nip/internal/proven_contact.hpp>
#include <nipref/ref/number/interval.hpp>

#include "support/intervals.hpp"
#include "support/reference_values.hpp"
#include "support/test.hpp"

using namespace nipref;
using ref::Exact;
using ref::Interval;

namespace {

/// All results of a contact that its proof gives.
std::vector<Interval> results_of_gripped(const ref::Proof& proof) {
  const ref::WorkingDigits working(proof.working_digits);
  const ref::ProvenResults& contact = *proof.contact;
  const auto place = [](double before_end) {
    return ref::SurfacePoint{Interval(before_end, ref::working_bits()), true};
  };
  std::vector<Interval> results{contact.load(), contact.edge_displacement(), *contact.strain(place(1))};
  for (const double before_end : {0.75, 0x1p-10}) {
    results.push_back(contact.pressure(place(before_end)));
    results.push_back(contact.shear(place(before_end)));
  }
  return results;
}

std::vector<Interval> gripped(double half_length, const Exact& beta, int digits,
                              const ref::GrippedKernels& kernels = ref::GrippedKernels()) {
  return results_of_gripped(ref::proven_gripped(Exact(half_length), beta, digits, kernels));
}

}  // namespace

TEST_CASE("ref gripped contact: an error of 1e-25 in a kernel or Poisson's ratio is noticed or widens") {
  const ref::WorkingDigits working(60);
  const Interval error(1e-25, 64);
  const ref::GrippedKernels right = ref::GrippedKernels();
  for (const double half_length : {0.5, 1.5}) {
    CAPTURE(half_length);
    const auto truth = gripped(half_length, Exact(mpq_class(1, 3)), 30);
    for (ref::NormalKernel ref::GrippedKernels::*const kernel :
         {&ref::GrippedKernels::normal, &ref::GrippedKernels::coupling, &ref::GrippedKernels::stretch}) {
      const auto with = [&](const Interval& wrong) {
        ref::GrippedKernels kernels = right;
        kernels.*kernel = once_wrong(right.*kernel, 16, wrong);
        return gripped(half_length, Exact(mpq_class(1, 3)), 30, kernels);
      };
      CHECK_THROWS_AS((void)with(error), std::logic_error);
      CHECK_THROWS_AS((void)with(-error), std::logic_error);
      const auto wide = with(ref::either_side(error));
      for (std::size_t k = 0; k < truth.size(); ++k) {
        CHECK(meet(wide[k], truth[k]));
        CHECK(width_of(wide[k]) > 1e4 * width_of(truth[k]));
      }
    }
    const auto other =
        gripped(half_length, Exact(mpq_class(1, 3) + mpq_class("1/10000000000000000000000000")), 30);
    for (std::size_t k = 0; k < truth.size(); ++k) CHECK_FALSE(meet(other[k], truth[k]));
  }
}

TEST_CASE("ref gripped contact: of a few digits only, its bounds still cover, and are not vacuous") {
  for (const double half_length : {1e-3, 3.0}) {
    for (const double beta : {0.0, 0.7}) {
      CAPTURE(half_length, beta);
      const auto rough = gripped(half_length, Exact(beta), 3), truth = gripped(half_length, Exact(beta), 25);
      for (std::size_t k = 0; k < truth.size(); ++k) {
        CAPTURE(k);
        CHECK(meet(rough[k], truth[k]));
        CHECK(is_inside(truth[k], rough[k]));
        CHECK(width_of(rough[k]) <= 1e-3 * highest(ref::magnitude_of(truth[0])) / half_length);
      }
    }
  }
}

TEST_CASE("ref gripped contact: an interval of lengths has the contacts of each") {
  const Exact beta(0.25);
  const auto is_allowed = [](double) { return true; };
  const auto all =
      ref::proven_gripped_for_load(Exact(1.5), 0.6, is_allowed, beta, 20, ref::GrippedKernels(), 500);
  REQUIRE(all);
  const ref::WorkingDigits working(all->working_digits);
  const Interval& known = all->contact->half_length();
  CHECK(width_of(known) <= 1e-20);
  CHECK(width_of(known) > 0);
  CHECK(meet(all->contact->load(), Interval(1.5, ref::working_bits())));
  const auto wide = results_of_gripped(*all);
  for (const mpfr_srcptr end : {known.lower(), known.upper()}) {
    mpq_class place;
    mpfr_get_q(place.get_mpq_t(), end);
    const auto one = results_of_gripped(
        ref::proven_gripped(Exact(place), beta, all->working_digits - 12, ref::GrippedKernels()));
    for (std::size_t k = 0; k < one.size(); ++k) CHECK(is_inside(one[k], wide[k]));
  }
}

TEST_CASE("ref gripped contact: lambda is the stiffness at z/A less what longer waves hold, at the best z") {
  for (const double A : {0.05, 0.7, 4.0}) {
    for (const double beta : {0.0, 0.2, 0.7}) {
      double lambda = 0;
      for (double z = 0.125; z < 2; z += 0.125) {
        const double twice = 2 * z / A, S = std::sinh(twice) + twice, r = (std::sinh(twice) - twice) / S;
        lambda = std::fmax(
            lambda, (1 - beta) * (r + beta) * std::fmin(0.5, S / (2 * std::cosh(twice))) * (1 - z * z / 4));
      }
      const Interval found = ref::coercivity(Interval(A, 128), [&](const Interval& x) {
        return ref::gripped_stiffness(x, Interval(beta, 128));
      });
      CHECK(highest(found) == doctest::Approx(lambda).epsilon(1e-9));
    }
  }
}

TEST_CASE("ref gripped contact: the stiffness of long waves and all shorter ones is what the proof takes") {
  for (const double beta : {0.0, 0.01, 0.3, 0.749}) {
    for (double z = 0.02; z < 10; z *= 1.5) {
      const double least = highest(ref::gripped_stiffness(Interval(z, 128), Interval(beta, 128)));
      double found = 1;
      for (double x = z; x < 40; x *= 1.03) {
        // The smaller eigenvalue of [[a, i c], [-i c, d]].
        const double S = std::sinh(2 * x) + 2 * x, a = 2 * std::pow(std::sinh(x), 2) / S,
                     d = 2 * std::pow(std::cosh(x), 2) / S, c = beta - 2 * x / S;
        found = std::fmin(found, (a + d) / 2 - std::hypot((a - d) / 2, c));
      }
      CAPTURE(beta, z);
      CHECK(least <= found * (1 + 1e-9) + 1e-14);
      CHECK(least >= found / 2.5 - 1e-14);
    }
  }
}
