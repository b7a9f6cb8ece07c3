// The ladder on a contact that is known, whose levels lack known parts of it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/internal/ladder.hpp>

using namespace nipref::fast;

namespace {

struct ToyContact {
  double half_length;
  double load;
  double tail = 0;
  std::vector<std::unique_ptr<ToyContact>> twins = {};
};

/// load = A^2 (1 + wrong), wrong falling by a factor for each term, down to a noise; or a wrong that is nan.
struct ToyLevels {
  using Contact = ToyContact;
  struct Resolution {
    int terms;
    double least;
  };
  static constexpr int most = 7;
  static constexpr double whole_share = 1;

  double factor;
  std::vector<int>* solves;  ///< one entry for each solution: its terms
  double noise = 0;
  int most_terms = 1000;
  int lucky_terms = 0;     ///< a solution with so many terms is as good as with half as many again
  double rounding = 0;     ///< of the twins, relative
  double fastest = 0;      ///< factor of a term that the levels allow; 0: `factor`
  double tail_factor = 0;  ///< of the tails; 0: `factor`

  [[nodiscard]] Resolution resolution(double, int level) const {
    const int terms = static_cast<int>(std::ceil(4 * std::pow(1.5, level)));
    return {terms, std::pow(fastest == 0 ? factor : fastest, -terms)};
  }
  [[nodiscard]] std::unique_ptr<ToyContact> solve(double half_length, const Resolution& resolution,
                                                  double tolerance, CountedKernels& kernels) const {
    CHECK(tolerance == 1e-16);
    kernels.count_system(resolution.terms);
    solves->push_back(resolution.terms);
    const double terms = resolution.terms == lucky_terms ? 1.5 * lucky_terms : resolution.terms;
    const double wrong = std::pow(factor, -terms) + (solves->size() % 2 == 0 ? noise : -noise);
    const auto with = [&](double relative) {
      return std::make_unique<ToyContact>(half_length, half_length * half_length * (1 + relative));
    };
    auto contact = with(wrong);
    contact->tail = std::max(std::pow(tail_factor == 0 ? factor : tail_factor, -resolution.terms), noise);
    for (const double sign : {-1.0, 1.0}) contact->twins.push_back(with(wrong + sign * rounding));
    return contact;
  }
  [[nodiscard]] static std::vector<AccuracyTarget<ToyContact>> accuracy_targets(const ToyContact&, double) {
    return {{&ToyContact::load}, {&ToyContact::half_length}};
  }
  [[nodiscard]] bool is_affordable(const Resolution& resolution) const {
    return resolution.terms <= most_terms;
  }
  [[nodiscard]] static double half_length_guess(double load) { return load; }
};

}  // namespace

TEST_CASE("ladder: at a length it climbs until the estimate meets the accuracy, and no further") {
  for (const double accuracy : {1e-2, 1e-4, 1e-8, 1e-12}) {
    CAPTURE(accuracy);
    std::vector<int> solves;
    const auto ladder = Ladder<ToyLevels>::at_half_length({6, &solves}, 3, accuracy);
    const Estimate load = ladder.estimate([](const ToyContact& contact) { return contact.load; });
    CHECK(std::fabs(load.value - 9) <= load.error);
    CHECK(load.error <= 9 * accuracy);
    CHECK(ladder.work().systems == solves.size());
    // With one level less the bound from its differences would have been too large.
    const auto wrong = [](int terms) { return std::pow(6.0, -terms); };
    REQUIRE(solves.size() >= 3);
    if (solves.size() > 3) {
      const double d1 = wrong(solves[solves.size() - 3]) - wrong(solves[solves.size() - 2]);
      const double d0 = wrong(solves[solves.size() - 4]) - wrong(solves[solves.size() - 3]);
      CHECK(3 * d1 * d1 / d0 > 0.9 * accuracy);
    }
  }
}

TEST_CASE("ladder: at a load the length is the one that carries it, and one search leads to the next") {
  for (const double accuracy : {1e-4, 1e-10}) {
    CAPTURE(accuracy);
    std::vector<int> solves;
    const auto ladder = Ladder<ToyLevels>::at_load({6, &solves}, 25, accuracy);
    const Estimate length = ladder.estimate([](const ToyContact& contact) { return contact.half_length; });
    CHECK(std::fabs(length.value - 5) <= length.error);
    CHECK(length.error <= 5 * accuracy);
    CHECK(ladder.last().load == doctest::Approx(25).epsilon(1e-2 * accuracy));
    // From the second level on the exponent is known and the length nearly: a step and a look.
    CHECK(std::count(solves.begin(), solves.end(), 6) <= 3);
    CHECK(std::count(solves.begin(), solves.end(), 9) <= 2);
  }
}

TEST_CASE("ladder: beyond its accuracy it is refined as far as rounding lets") {
  std::vector<int> solves;
  auto ladder = Ladder<ToyLevels>::at_load({6, &solves}, 25, 1e-2);
  const auto half_length = [&] {
    return ladder.estimate([](const ToyContact& contact) { return contact.half_length; });
  };
  for (double before = half_length().error; ladder.refine(); before = half_length().error) {
    CHECK(half_length().error <= before);
    CHECK(std::fabs(half_length().value - 5) <= half_length().error);
  }
  CHECK(half_length().error < 5e-13);
  const std::size_t all = solves.size();
  CHECK_FALSE(ladder.refine());
  CHECK(solves.size() == all);
}

TEST_CASE("ladder: an accuracy out of reach is not claimed") {
  std::vector<int> solves;
  const auto ladder = Ladder<ToyLevels>::at_half_length({1.1, &solves}, 1, 1e-12);
  const Estimate load = ladder.estimate([](const ToyContact& contact) { return contact.load; });
  CHECK(std::fabs(load.value - 1) <= load.error);
  CHECK(load.error > 1e-12);
}

TEST_CASE("ladder: it ends where more terms twice do not help, and says what is left") {
  std::vector<int> solves;
  const auto ladder = Ladder<ToyLevels>::at_half_length({1e3, &solves, 1e-9}, 1, 1e-13);
  CHECK(solves.size() == 5);
  const Estimate load = ladder.estimate([](const ToyContact& contact) { return contact.load; });
  CHECK(std::fabs(load.value - 1) <= load.error);
  CHECK(load.error < 2e-8);
}

TEST_CASE("ladder: beyond three levels none that cannot be afforded is tried") {
  for (const int most_terms : {1, 13, 14}) {
    std::vector<int> solves;
    const auto ladder = Ladder<ToyLevels>::at_half_length({1.1, &solves, 0, most_terms}, 1, 1e-12);
    CHECK(solves.back() == std::max(9, most_terms == 14 ? 14 : 0));
    CHECK(ladder.estimate([](const ToyContact& contact) { return contact.load; }).error > 0.1);
  }
}

TEST_CASE(
    "ladder: a small number that converges more slowly than the expansions is told by its own differences") {
  // Two differences tell the rate but roughly; three do better.
  for (const auto& [accuracy, levels, most] : {std::tuple{1e-4, 3, 150.0}, std::tuple{1e-14, 4, 45.0}}) {
    CAPTURE(levels);
    std::vector<int> solves;
    const auto ladder = Ladder<ToyLevels>::at_half_length(
        {.factor = 6, .solves = &solves, .fastest = 1e3, .tail_factor = 1e3}, 3, accuracy);
    CHECK(static_cast<int>(solves.size()) == levels);
    const Estimate small =
        ladder.estimate_down_to_rounding([](const ToyContact& contact) { return contact.load - 9; });
    CHECK(std::fabs(small.value) <= small.error);
    // They fell by the terms gained last, and the last solution has gained half as many again.
    CHECK(small.error <= most * std::fabs(small.value));
  }
}

TEST_CASE(
    "ladder: a solution has kept of its error what its tail has kept, but not less than an expansion can") {
  // A fastest rate that is too fast does not matter where the tails tell the rate, nor tails that fall too fast where
  // the rate cannot be such.
  for (const auto& [fastest, tail_factor] : {std::pair{1e3, 3.0}, std::pair{3.0, 1e3}}) {
    CAPTURE(fastest);
    std::vector<int> solves;
    const auto ladder =
        Ladder<ToyLevels>::at_half_length({3, &solves, 0, 1000, 0, 0, fastest, tail_factor}, 1, 1e-6);
    const Estimate load = ladder.estimate([](const ToyContact& contact) { return contact.load; });
    CHECK(std::fabs(load.value - 1) <= load.error);
    CHECK(load.error <= 1e-6);
    // Once more at the believed rate, its power and the safety factor: not 30 times that.
    CHECK(load.error <= 30 * std::fabs(load.value - 1));
  }
}

TEST_CASE("ladder: what is no number stops it") {
  std::vector<int> solves;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(Ladder<ToyLevels>::at_half_length({nan, &solves}, 1, 1e-6), nipref::data::BadInput);
  CHECK_THROWS_AS(Ladder<ToyLevels>::at_load({nan, &solves}, 1, 1e-6), nipref::data::BadInput);
}

TEST_CASE("ladder: levels that agree by chance do not hide what the last one lacks") {
  for (const int lucky : {4, 6}) {
    std::vector<int> solves;
    const auto ladder = Ladder<ToyLevels>::at_half_length({6, &solves, 0, 1000, lucky}, 1, 1e-3);
    const Estimate load = ladder.estimate([](const ToyContact& contact) { return contact.load; });
    CHECK(std::fabs(load.value - 1) <= load.error);
    CHECK(load.error < 1e-3);
  }
}

TEST_CASE("ladder: rounding is what the twins differ by, and where it rules no more terms are tried") {
  std::vector<int> solves;
  const auto ladder = Ladder<ToyLevels>::at_half_length({1e3, &solves, 0, 1000, 0, 1e-10}, 1, 1e-13);
  CHECK(solves.size() == 3);
  const Estimate load = ladder.estimate([](const ToyContact& contact) { return contact.load; });
  CHECK(load.error >= 1e-10);
  CHECK(load.error < 1e-8);
  // A length found for a load is as unsure as the load that is found at it.
  const auto loaded = Ladder<ToyLevels>::at_load({1e3, &solves, 0, 1000, 0, 1e-10}, 25, 1e-13);
  CHECK(loaded.estimate([](const ToyContact& contact) { return contact.half_length; }).error >= 0.5e-10);
}
