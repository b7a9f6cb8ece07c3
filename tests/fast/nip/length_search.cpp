// The search for the length that carries a load, on loads whose lengths are known.
#include <nipref/fast/nip/internal/length_search.hpp>

#include "support/test.hpp"

using nipref::fast::LengthSearch;

namespace {

struct Tried {
  double length, carried;
  [[nodiscard]] double load() const { return carried; }
};

/// A search with the loads load_of(length): the length at which it ends, and the number of lengths that it tries.
struct Search : LengthSearch {
  template <class Load>
  Search(const LengthSearch& search, Load load_of) : LengthSearch(search) {
    found = nipref::fast::solution_at_end(*this, [&](double tried) {
              ++solves;
              return Tried{tried, load_of(tried)};
            }).length;
  }

  double found;
  int solves = 0;
};

double squared(double length) { return length * length; }

}  // namespace

TEST_CASE("length search: a pure power takes three steps, whatever the exponent") {
  for (const double exponent : {1.0, 2.0, 3.0, 5.0, 6.0}) {
    CAPTURE(exponent);
    const Search search({7, 0.3, {.tolerance = 1e-13}},
                        [&](double length) { return std::pow(length, exponent); });
    CHECK(search.met());
    CHECK(search.solves <= 4);  // the second trial shows the exponent
    CHECK(search.found == approx(std::pow(7, 1 / exponent), 1e-13));
    CHECK(search.exponent() == doctest::Approx(exponent).epsilon(1e-6));
  }
}

TEST_CASE("length search: a length between two powers is found from six decades away") {
  const auto load_of = [](double length) { return length * length + std::pow(length, 5); };
  for (const double near : {1e-3, 1.0, 1e3}) {
    const Search search({load_of(0.7), near, {.tolerance = 1e-13}}, load_of);
    CHECK(search.found == approx(0.7, 1e-12));
    CHECK(search.solves <= 14);
  }
}

TEST_CASE("length search: what is known of the exponent saves a step") {
  const Search blind({2, 1, {.tolerance = 1e-13}}, squared), told({2, 1, {.tolerance = 1e-13}, 2}, squared);
  CHECK(told.solves < blind.solves);
}

TEST_CASE("length search: a wrong exponent that is kept gets there as slowly as it must") {
  // (2.13) on a half-space: each step multiplies the logarithm of load found/load by 1 - 2/3.
  const Search search({std::exp(1.0), 1, {.tolerance = 1e-12, .fixed_exponent = true}}, squared);
  CHECK(search.met());
  CHECK(squared(search.found) == approx(std::exp(1.0), 1e-12));
  CHECK(search.solves == 1 + std::ceil(12 * std::log(10.0) / std::log(3.0)));
  CHECK(search.exponent() == LengthSearch::usual_exponent);
}

TEST_CASE("length search: rounding ends it, and counts as met") {
  const Search search({0.3123456789012, 1, {.tolerance = 1e-14}},
                      [](double length) { return std::round(length * length * 1e9) / 1e9; });
  CHECK(search.met());
  CHECK(search.residual() > 1e-14);
  CHECK(search.residual() < 1e-8);
  CHECK(search.found == doctest::Approx(std::sqrt(0.3123456789012)).epsilon(1e-8));
  CHECK(search.solves < 12);
}

TEST_CASE("length search: slow steps of an exponent that is not the secant's own are no rounding") {
  // The search takes no exponent below 1, so that each step leaves 0.6 of the excess.
  const Search search({3, 1, {.tolerance = 1e-13}}, [](double length) { return std::pow(length, 0.4); });
  CHECK(search.residual() < 1e-6);
  CHECK(!search.met());
}

TEST_CASE("length search: it approaches a pole, behind which there is no load or too much of it") {
  for (const double beyond : {-1.0, 1e9}) {
    for (const double load : {0.5, 30.0, 1e4}) {
      CAPTURE(beyond, load);
      const auto load_of = [&](double length) {
        return length < 1 ? length * length / (1 - length) : beyond * length;
      };
      const Search search({load, 1e-2, {.tolerance = 1e-10}}, load_of);
      CHECK(search.met());
      CHECK(search.found < 1);
      CHECK(load_of(search.found) == approx(load, 1e-10));
    }
  }
}

TEST_CASE("length search: it comes back from lengths where there is no load") {
  for (const double lost : {0.0, -1.0, not_a_number}) {
    const Search search({1, 100, {.tolerance = 1e-12}},
                        [&](double length) { return length > 5 ? lost : length * length; });
    CHECK(search.met());
    CHECK(search.found == doctest::Approx(1).epsilon(1e-12));
  }
  const Search never({1, 1, {.tolerance = 1e-12}}, [](double) { return 0.0; });
  CHECK(!never.met());
  CHECK(std::isinf(never.residual()));
}

TEST_CASE("length search: it goes to the longest length at most, and ends if that carries too little") {
  const Search search({100, 1, {.tolerance = 1e-12, .longest = 2}}, squared);
  CHECK(!search.met());
  CHECK(search.found == doctest::Approx(2).epsilon(1e-15));
  CHECK(search.solves == 2);
  // The longest length carries enough here, so that the search goes on from it.
  const Search there({3.9, 1, {.tolerance = 1e-12, .longest = 2}, 1}, squared);
  CHECK(there.found == doctest::Approx(std::sqrt(3.9)).epsilon(1e-12));
  CHECK(there.met());
}
