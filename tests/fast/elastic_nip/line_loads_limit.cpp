#include <Eigen/LU>

#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/sheet/kernels.hpp>

#include "support/test.hpp"
#include "support/thesis_nips.hpp"

using namespace nipref;
using namespace nipref::test;

namespace {

/// Numbers of elements of the extrapolation, one for each term of the expansion
///   truth + (a ln m + b)/m + (c ln^2 m + d ln m + e)/m^2:
/// in effect the scheme solves a contact whose ends are displaced by (alpha ln m + beta)/m.
const std::vector<int> elements{64, 96, 128, 192, 256, 384};

double extrapolated(const std::vector<double>& values) {
  Eigen::Matrix<double, 6, 6> rows;
  Eigen::Vector<double, 6> right;
  for (int i = 0; i < 6; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double h = 100.0 / elements[at], ln = std::log(h);  // scaled: columns of similar size
    rows.row(i) << 1, h * ln, h, h * h * ln * ln, h * h * ln, h * h;
    right(i) = values[at];
  }
  return rows.partialPivLu().solve(right)(0);
}

}  // namespace

TEST_CASE("line loads without friction, extrapolated, are the continuous contact") {
  for (const double thickness : data::seed::sheet_thicknesses) {
    for (const double load : {25.0, 200.0}) {
      const data::ElasticNip nip = data::seed::nip(thickness);
      const auto truth = fast::converged_for_load(nip, data::Friction::none, load, 1e-11);
      std::vector<double> lengths, indentations;
      for (const int m : elements) {
        const auto solution = fast::line_loads_for_load(nip, m, load);
        lengths.push_back(solution.contact_length());
        indentations.push_back(solution.indentation);
      }
      CAPTURE(thickness, load);
      const double length = truth.contact_length().value;
      CHECK(extrapolated(lengths) == approx(length, 1e-6));
      CHECK(extrapolated(indentations) == approx(truth.indentation().value, 1e-6));
      CHECK(std::abs(lengths.back() / length - 1) > 1e-3);  // the finest is far off without extrapolation
    }
  }
}

TEST_CASE("the oscillation of short rows of loads is the one counted by hand") {
  CHECK(fast::oscillation(std::vector<double>{1, -1, 1, -1, 1, -1, 1, -1}) == 3);  // 6 bends of 4, over 8
  CHECK(fast::oscillation(std::vector<double>{1, 2, 3, 4}) == 0);
  CHECK(fast::oscillation(std::vector<double>{1, 5}) == 0);
  CHECK(fast::oscillation(std::vector<double>{0, 0, 0}) == 0);
}

TEST_CASE("the condition number of the smallest matrix is the one computed by hand") {
  // One element a side, beta = 1/2: rows (1, -a) and (1, -c), determinant a - c.
  const data::ElasticNip nip{1.0, 2.0, {1.0, 0.25}};
  const double a = 2 * fast::I1(0.5);
  const double c = fast::I1(0.5) + fast::I1(1.5);
  const double norm = std::max(2.0, std::abs(a) + std::abs(c));
  const double inverse_norm = std::max(1 + std::abs(a), 1 + std::abs(c)) / std::abs(a - c);
  CHECK(fast::condition_number(nip, 1, 2.0, data::Friction::none) == approx(norm * inverse_norm, 1e-12));
  // The matrix with friction is the worse conditioned one.
  const auto condition = [](data::Friction friction) {
    return fast::condition_number(data::seed::nip(0.25), 50, 0.113, friction);
  };
  CHECK(condition(data::Friction::full) > condition(data::Friction::none));
}

TEST_CASE("500 elements a side fail nowhere for L/B from 1e-4 to 1e3, Poisson's ratio from -0.9 to 1/2") {
  for (const double poisson : {-0.9, 0.5}) {
    for (const double ratio : {1e-4, 1.0, 1e3}) {
      CAPTURE(poisson, ratio);
      const data::ElasticNip nip{1e5, 1.0, {1.0, poisson}};
      const auto slipping = fast::line_loads_for_length(nip, 500, ratio);
      CHECK(slipping.load() > 0);
      CHECK(slipping.indentation > 0);
      CHECK(slipping.loads.size() == 1000);
      const auto gripped = fast::line_loads_for_length(nip, 500, ratio, full_friction(0.0));
      CHECK(std::isfinite(gripped.load()));
      CHECK(std::isfinite(gripped.peak_shear()));
      CHECK(gripped.loads.size() == 1000);
    }
  }
}
