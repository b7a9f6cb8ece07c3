// The proof of the rolling contact: that its bounds hold, that it notices errors, and what it rests on.
#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/ref/memory/internal/fading.hpp>
#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/viscoelastic_nip/converged.hpp>
#include <nipref/ref/viscoelastic_nip/internal/proven_rolling.hpp>

#include "support/intervals.hpp"
#include "support/reference_values.hpp"
#include "support/test.hpp"

using namespace nipref;
using ref::Float;
using ref::Interval;

namespace {

/// The results of a contact that its proof gives.
std::vector<Interval> results_of(const ref::ProvenContact& contact) {
  return {contact.load(), contact.offset(), contact.edge_displacement(), contact.lever(),
          contact.pressure({Interval(0.75, ref::working_bits())})};
}

}  // namespace

TEST_CASE("ref rolling contact: an error of 1e-25 in a rate or a length is outside its proof, or widens it") {
  const mpq_class tiny("1/10000000000000000000000000");
  const double half_length = 0.5;
  const ref::WorkingDigits outer(60);
  const auto solved = [&](const mpq_class& factor, const mpq_class& error, double apart) {
    const ref::ProvenMemories memories{{{mpq_class(1, 2), mpq_class(1, 2) * factor}, {1, 3}}, error, 1};
    const ref::WorkingDigits working(ref::proven_rolling_working_digits(memories, half_length, 30));
    const Interval A = Interval(half_length, ref::working_bits()) +
                       Interval(apart, ref::working_bits()) * Interval(ref::Exact(tiny), ref::working_bits());
    return results_of(*ref::proven_rolling(memories, A, 30));
  };
  const auto truth = solved(1, 0, 0), other_rate = solved(1 + tiny, 0, 0), wide = solved(1, tiny, 0),
             other_length = solved(1, 0, 1);
  for (std::size_t k = 0; k < truth.size(); ++k) {
    CAPTURE(k);
    CHECK_FALSE(meet(truth[k], other_rate[k]));
    CHECK(is_inside(truth[k], wide[k]));
    CHECK(is_inside(other_rate[k], wide[k]));
    CHECK(width_of(truth[k]) < 1e-30);
    CHECK(width_of(wide[k]) < 1e-21);
    CHECK_FALSE(meet(truth[k], other_length[k]));
  }
}

TEST_CASE("ref rolling contact: a memory with an amplitude below 0 is beyond the proof") {
  const auto memories = [](double amplitude) {
    const auto material = data::prony_solid({1, {1, amplitude}, {1, 2}}, {0.5, {0.5}, {1}});
    return ref::proven_memories({100, 1, material, 1});
  };
  CHECK(memories(0.1));
  CHECK_FALSE(memories(-0.1));
}

TEST_CASE("ref rolling contact: an interval of lengths has the contacts of each") {
  const ref::ProvenMemories memories{{{mpq_class(1, 2), mpq_class(1, 2)}}, 0, 1};
  const ref::WorkingDigits working(ref::proven_rolling_working_digits(memories, 0.7, 30));
  const Float here = 0.7, there = here + ldexp(Float(1), -70);
  const auto all =
      results_of(*ref::proven_rolling(memories, hull(ref::interval_of(here), ref::interval_of(there)), 30));
  for (const Float& A : {here, Float((here + there) / 2), there}) {
    const auto one = results_of(*ref::proven_rolling(memories, ref::interval_of(A), 30));
    for (std::size_t k = 0; k < one.size(); ++k) CHECK(is_inside(one[k], all[k]));
  }
}

TEST_CASE("bounded columns: the even part of a slope has no more of the low frequencies than the odd one") {
  for (double k = 0.05; k < 2; k += 0.05) {
    double odd = 0, even = 0;
    for (int m = 1; m < 40; ++m) (m % 2 == 1 ? odd : even) += m * std::pow(std::cyl_bessel_j(m, k), 2);
    CHECK(odd <= k * k / 4);
    CHECK(even <= k * k / 4);
    CHECK(even <= k * k * k * k / 32);
  }
}

TEST_CASE("ref rolling contact: the proof's memory of the kernel is that of the reference's integral") {
  // |M| <= 4 at all distances and rates, which the bounds of the moments assume.
  for (const char* const rate : {"0", "1e-3", "1", "50"}) {
    for (const double x : {1e-9, 0.01, 0.5, 3.0}) {
      const double M =
          highest(ref::steady_memory(ref::Symbol::I1, ref::Exact(x), ref::Exact::parse(rate), 40));
      CHECK(std::fabs(M) <= 4);
    }
  }
}
