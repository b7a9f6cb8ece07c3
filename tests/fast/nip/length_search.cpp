// The search for the length that carries a load, on loads whose lengths are known.
#include <initializer_list>

#include <nipref/fast/nip/internal/length_search.hpp>

#include "support/test.hpp"

using nipref::fast::LengthSearch;
using nipref::fast::LengthSearchRule;

namespace {

struct Solution {
  double length;
  double found;
  [[nodiscard]] double load() const { return found; }
};

/// The search for load_of(length), the lengths it took, and where it ended.
template <class Load>
Solution ended(LengthSearch& search, Load load_of, int* solves = nullptr) {
  return nipref::fast::solution_at_end(search, [&](double length) {
    if (solves != nullptr) ++*solves;
    return Solution{length, load_of(length)};
  });
}

}  // namespace

TEST_CASE("length search: pure powers in three steps, whatever the exponent") {
  for (const double exponent : {1.0, 2.0, 3.0, 5.0, 6.0}) {
    CAPTURE(exponent);
    LengthSearch search(7, 0.3, {.tolerance = 1e-13});
    int solves = 0;
    const Solution found = ended(
        search, [&](double length) { return std::pow(length, exponent); }, &solves);
    CHECK(search.met());
    CHECK(solves <= 4);  // the exponent shows in the second
    CHECK(found.length == approx(std::pow(7, 1 / exponent), 1e-13));
    CHECK(search.exponent() == doctest::Approx(exponent).epsilon(1e-6));
  }
}

TEST_CASE("length search: between two powers, from six decades away") {
  const auto load_of = [](double length) { return length * length + std::pow(length, 5); };
  for (const double near : {1e-3, 1.0, 1e3}) {
    LengthSearch search(load_of(0.7), near, {.tolerance = 1e-13});
    int solves = 0;
    CHECK(ended(search, load_of, &solves).length == approx(0.7, 1e-12));
    CHECK(solves <= 14);
  }
}

TEST_CASE("length search: what is known of the exponent saves a step") {
  const auto load_of = [](double length) { return length * length; };
  LengthSearch blind(2, 1, {.tolerance = 1e-13}), told(2, 1, {.tolerance = 1e-13}, 2);
  int blind_solves = 0, told_solves = 0;
  ended(blind, load_of, &blind_solves);
  ended(told, load_of, &told_solves);
  CHECK(told_solves < blind_solves);
}

TEST_CASE("length search: a wrong exponent that is kept gets there as slowly as it must") {
  // (2.13) on a half-space: each step leaves 1 - 2/3 of the logarithm.
  LengthSearch search(std::exp(1.0), 1, {.tolerance = 1e-12, .fixed_exponent = true});
  int solves = 0;
  const Solution found = ended(
      search, [](double length) { return length * length; }, &solves);
  CHECK(search.met());
  CHECK(found.load() == approx(std::exp(1.0), 1e-12));
  CHECK(solves == 1 + std::ceil(12 * std::log(10.0) / std::log(3.0)));
  CHECK(search.exponent() == LengthSearch::usual_exponent);
}

TEST_CASE("length search: rounding ends it, and counts as met") {
  const auto noisy = [](double length) { return std::round(length * length * 1e9) / 1e9; };
  LengthSearch search(0.3123456789012, 1, {.tolerance = 1e-14});
  int solves = 0;
  const Solution found = ended(search, noisy, &solves);
  CHECK(search.met());
  CHECK(search.residual() > 1e-14);
  CHECK(search.residual() < 1e-8);
  CHECK(found.length == doctest::Approx(std::sqrt(0.3123456789012)).epsilon(1e-8));
  CHECK(solves < 12);
}

TEST_CASE("length search: slow steps of an exponent that is not the secant's own are no rounding") {
  // None is taken below 1: each step leaves 0.6 of the excess.
  LengthSearch search(3, 1, {.tolerance = 1e-13});
  ended(search, [](double length) { return std::pow(length, 0.4); });
  CHECK(search.residual() < 1e-6);
  CHECK(!search.met());
}

TEST_CASE("length search: up to a pole, behind which there is no load or too much of it") {
  for (const double beyond : {-1.0, 1e9}) {
    for (const double load : {0.5, 30.0, 1e4}) {
      CAPTURE(beyond);
      CAPTURE(load);
      const auto load_of = [&](double length) {
        return length < 1 ? length * length / (1 - length) : beyond * length;
      };
      LengthSearch search(load, 1e-2, {.tolerance = 1e-10});
      const double length = ended(search, load_of).length;
      CHECK(search.met());
      CHECK(length < 1);
      CHECK(load_of(length) == approx(load, 1e-10));
    }
  }
}

TEST_CASE("length search: back from lengths where there is no load") {
  for (const double lost : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    LengthSearch search(1, 100, {.tolerance = 1e-12});
    const Solution found = ended(search, [&](double length) { return length > 5 ? lost : length * length; });
    CHECK(search.met());
    CHECK(found.length == doctest::Approx(1).epsilon(1e-12));
  }
  LengthSearch never(1, 1, {.tolerance = 1e-12});
  ended(never, [](double) { return 0.0; });
  CHECK(!never.met());
  CHECK(std::isinf(never.residual()));
}

TEST_CASE("length search: not beyond the longest, and over as soon as that carries too little") {
  LengthSearch search(100, 1, {.tolerance = 1e-12, .longest = 2});
  int solves = 0;
  const Solution found = ended(
      search, [](double length) { return length * length; }, &solves);
  CHECK(!search.met());
  CHECK(found.length == doctest::Approx(2).epsilon(1e-15));
  CHECK(solves == 2);
  // Only a way point.
  LengthSearch there(3.9, 1, {.tolerance = 1e-12, .longest = 2}, 1);
  CHECK(ended(there, [](double length) { return length * length; }).length ==
        doctest::Approx(std::sqrt(3.9)).epsilon(1e-12));
  CHECK(there.met());
}
