#pragma once
#include <nipref/fast/number/estimate.hpp>
#include <nipref/verify/solve/solve.hpp>

#include "support/reference_values.hpp"
#include "support/test.hpp"

/// Whether two numbers differ by no more than the sum of their errors.
inline bool is_covered(const nipref::fast::Estimate& a, const nipref::fast::Estimate& b) {
  return std::fabs(a.value - b.value) <= a.error + b.error;
}
inline bool is_covered(const nipref::fast::Estimate& found, const nipref::ref::Estimate& truth) {
  return std::fabs(truth.error_of(found.value)) <= found.error + error(truth);
}

inline void check_covered(const nipref::fast::Estimate& found, const nipref::fast::Estimate& truth) {
  CAPTURE(found.value, found.error);
  CHECK(is_covered(found, truth));
}

/// Checks each number of one solution against that of the other.
template <class Number>
void check_covered(const nipref::verify::SceneSolution<nipref::fast::Estimate>& found,
                   const nipref::verify::SceneSolution<Number>& truth) {
  REQUIRE(found.results.size() == truth.results.size());
  for (std::size_t r = 0; r < found.results.size(); ++r) {
    const auto& numbers = found.results[r].numbers;
    const auto& truths = truth.results[r].numbers;
    CAPTURE(found.results[r].what->name);
    REQUIRE(numbers.size() == truths.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      CAPTURE(i, numbers[i].value, numbers[i].error);
      CHECK(is_covered(numbers[i], truths[i]));
    }
  }
}

struct BothPaths {
  nipref::verify::SceneSolution<nipref::fast::Estimate> fast;
  nipref::verify::SceneSolution<nipref::ref::Estimate> ref;
};

/// Solves the scene by both paths and checks that they agree about each number.
inline BothPaths by_both_paths(const nipref::data::Scene& scene, int digits = 16) {
  CAPTURE(scene.title);
  BothPaths solved{nipref::verify::solve(scene), nipref::verify::solve_by_ref(scene, digits)};
  check_covered(solved.fast, solved.ref);
  return solved;
}
