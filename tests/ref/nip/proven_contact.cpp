// What the proofs of the reference's contacts rest on, and that the proofs notice errors.
#include <Eigen/Eigenvalues>

#include <nipref/ref/elastic_nip/internal/proven_elastic.hpp>
#include <nipref/ref/nip/internal/chebyshev_system.hpp>
#include <nipref/ref/nip/internal/proven_contact.hpp>
#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>

#include "support/intervals.hpp"
#include "support/test.hpp"

using namespace nipref::ref;

namespace {

Interval load_of(double half_length, int digits, const NormalKernel& kernel) {
  const auto proof = proven_elastic(Exact(half_length), Exact(0.0), digits, kernel, 100);
  const WorkingDigits working(proof->working_digits);
  return proof->contact->load();
}

/// Right-hand sides of both parities: that of the elastic contact, and one with steadily falling coefficients.
std::vector<SlopeSeries> both_sides(int size) {
  SlopeSeries wave{{Interval(working_bits())}, exp(Interval(-3.0 * size, working_bits()))};
  for (int m = 1; m < 2 * size; ++m) wave.coefficients.push_back(exp(Interval(-1.5 * m, working_bits())));
  return {SlopeSeries::line(size), wave};
}

/// The columns of both right-hand sides, solved at the half-length `system` and proven for an interval about it.
std::vector<BoundedColumn> columns_of(const Float& system, int size, SmoothKernel& kernel,
                                      const Interval& half_length) {
  const ChebyshevSystem both(system, size, kernel, true);
  std::vector<BoundedColumn> columns;
  for (const SlopeSeries& right : both_sides(size))
    columns.push_back(both.proven(both.solution(right), right, half_length));
  return columns;
}

/// The entries sqrt(m k) g_mk/2, m and k from `first` in steps of two, by the quadrature of the system.
DenseMatrix<double> symmetric_form(const ChebyshevSystem& system, int first) {
  const int n = system.size();
  const ChebyshevSystem::Parity& parity = system.parities()[static_cast<std::size_t>(first - 1)];
  DenseMatrix<double> transform(n + 1 - first, n), part(n, n);
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < transform.rows(); ++k) {
      const long m = 2L * k + first;
      transform(k, i) = std::sqrt(m) * mpfr_get_d(system.cosines()(m * (2L * i + 1)).lower(), MPFR_RNDN);
    }
    for (int j = 0; j < n; ++j) part(i, j) = static_cast<double>(parity.part(i, j)) * 2 / (n * n);
  }
  return transform * part * transform.transpose();
}

/// The error of the coefficients of `rough`: sum m |dc_m|.
double missed_by(const ProvenExpansion& rough, const ProvenExpansion& truth) {
  double missed = 0;
  for (std::size_t m = 0; m < truth.coefficients.size(); ++m) {
    const Float mine = m < rough.coefficients.size() ? middle_of(rough.coefficients[m]) : Float(0);
    missed += static_cast<double>(m * abs(middle_of(truth.coefficients[m]) - mine));
  }
  return missed;
}

}  // namespace

TEST_CASE("the contact's smooth kernel is I1 with its logarithm added, within its error") {
  const WorkingDigits working(50);
  SmoothKernel smooth(I1_interval, 40);
  for (const double alpha : {1e-30, 0.001, 0.1, 0.25, 0.7300001, 1.9, 2.0, 7.3, 41.37}) {
    CAPTURE(alpha);
    const Interval truth = I1_interval(Exact(alpha), 110) + log(Interval(alpha, working_bits()));
    CHECK(meet(truth, smooth.over(Interval(alpha, working_bits()))));
    CHECK(smooth(Float(-alpha)) == smooth(Float(alpha)));
  }
  CHECK(static_cast<double>(smooth.error()) < 1e-38);
}

TEST_CASE("a wrong kernel value in the 25th digit makes the proof fail, one known to no more widens it") {
  const WorkingDigits working(50);
  const Interval error(1e-25, 64);
  for (const double half_length : {1e-6, 0.5, 1.5}) {
    CAPTURE(half_length);
    const Interval truth = load_of(half_length, 30, I1_interval);
    CHECK(width_of(truth) <= 1e-30 * highest(truth));
    for (const int count : {0, 7, 16, 23, 29}) {
      CAPTURE(count);
      CHECK_THROWS_AS(load_of(half_length, 30, once_wrong(I1_interval, count, error)), std::logic_error);
      CHECK_THROWS_AS(load_of(half_length, 30, once_wrong(I1_interval, count, -error)), std::logic_error);
      const Interval wide = load_of(half_length, 30, once_wrong(I1_interval, count, either_side(error)));
      CHECK(meet(wide, truth));
      CHECK(width_of(wide) > 1e4 * width_of(truth));
    }
  }
  const auto radius = [&](const Interval& wrong) {
    SmoothKernel kernel(once_wrong(I1_interval, 7, wrong), 40);
    return highest(columns_of(0.5, 30, kernel, Interval(0.5, working_bits())).back().radius);
  };
  CHECK_THROWS_AS(radius(error), std::logic_error);
  CHECK(radius(either_side(error)) > 1e4 * radius(Interval(64)));
}

TEST_CASE("the contact's quadratic form is at least what the proof takes for it, its entries at most") {
  const WorkingDigits working(25);
  SmoothKernel smooth(I1_interval, 20);
  for (const double half_length : {1e-3, 0.3, 1.0, 3.0, 7.0}) {
    CAPTURE(half_length);
    const int n = size_for(half_length, 6);
    const ChebyshevSystem system(half_length, n, smooth, true);
    const double bound = lowest(coercivity(Interval(half_length, 64), frictionless_stiffness));
    double least = 1, largest_part = 0;
    for (const int first : {1, 2}) {
      const auto form = symmetric_form(system, first);
      const DenseMatrix<double> definite = DenseMatrix<double>::Identity(form.rows(), form.rows()) + form;
      least = std::min(least, Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(definite).eigenvalues()(0));
      for (const double y : {0.5, 1.5, 1.9}) {
        for (const double split : {0.0, 0.3, 0.5}) {
          const double tau = std::asinh(split * y / half_length);
          const double other = std::asinh((1 - split) * y / half_length);
          const double factor = 2 * half_length * std::sqrt(std::cosh(tau) * std::cosh(other)) *
                                (2 / (2 - y) + 4 / ((2 - y) * (2 - y)));
          for (int i = 0; i < form.rows(); ++i) {
            for (int j = 0; j < form.rows(); ++j) {
              const double most = factor * std::exp(-(2 * i + first) * tau - (2 * j + first) * other);
              // 1e-14 n is for the errors of the kernel's values and of double.
              largest_part = std::fmax(largest_part, (std::fabs(form(i, j)) - 1e-14 * n) / most);
            }
          }
        }
      }
    }
    CHECK(bound <= least);
    CHECK(bound >= least / 4);
    CHECK(largest_part <= 1);
    CHECK(largest_part >= 0.01);
  }
}

TEST_CASE("the bound of entries and the rounding of arguments that the proof takes are those of the page") {
  for (const double A : {1e-3, 0.3, 3.0, 30.0}) {
    CAPTURE(A);
    const int n = size_for(A, 20);
    const double y = std::max(1.0, 2 - A / n), tau = std::asinh(y / A);
    const double C = 2 * A * std::cosh(tau) * (2 / (2 - y) + 4 / ((2 - y) * (2 - y)));
    const EntryBounds bounds = entry_bounds(Interval(A, 64), n);
    CHECK(highest(bounds.amplitude) == doctest::Approx(C).epsilon(1e-12));
    CHECK(highest(bounds.rate) == doctest::Approx(tau).epsilon(1e-12));
    double lambda = 0;
    for (double z = 0.125; z < 2; z += 0.125) {
      const double k = 2 * z / A;
      lambda = std::fmax(lambda, (std::cosh(k) - 1) / (std::sinh(k) + k) * (1 - z * z / 4));
    }
    if (A > 0.01)
      CHECK(lowest(coercivity(Interval(A, 64), frictionless_stiffness)) ==
            doctest::Approx(lambda).epsilon(1e-12));
    // An entry is half a difference of two values of J, |J'| <= 2, whose arguments are rounded as in the system.
    const WorkingDigits working(40);
    const Cosines cosines(2L * n, working_bits());
    const double unit = static_cast<double>(std::numeric_limits<Float>::epsilon());
    double largest = 0;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j <= i; ++j) {
        const auto place = [&](int k) -> Float { return Float(A) * middle_of(cosines(2L * k + 1)); };
        const Interval s = Interval(A, 300) * cosines(2L * i + 1), t = Interval(A, 300) * cosines(2L * j + 1);
        const auto off = [](const Float& rounded, const Interval& exact) {
          return highest(distance_from(rounded, exact));
        };
        largest = std::max(largest, off(place(i) - place(j), s - t) + off(place(i) + place(j), s + t));
      }
    }
    CHECK(largest <= argument_units * (A + 1) * unit);
    CHECK(largest >= argument_units * A * unit / 1e3);
  }
}

TEST_CASE("what entries are folded onto one is at most what the proof takes for it, and not much less") {
  constexpr int points = 8;  // N; those folded onto m are 2 N k - m and 2 N k + m
  for (const double tau : {0.05, 0.1, 0.5}) {
    for (const int parity : {1, 0}) {
      double largest = 0;
      for (int m = 2 - parity; m < points; m += 2) {
        for (int n = 2 - parity; n < points; n += 2) {
          double one = 0, by_m = 0, by_n = 0;
          for (int k = 1; k < 400; ++k) {
            for (const int sign : {-1, 1}) {
              const int to_m = 2 * points * k + sign * m, to_n = 2 * points * k + sign * n;
              one += std::exp(-tau * to_m) + std::exp(-tau * to_n);
              by_m += std::exp(-tau * to_m / 2);
              by_n += std::exp(-tau * to_n / 2);
            }
          }
          largest = std::fmax(largest, one + by_m * by_n);
        }
      }
      const EntryBounds decay{Interval(1L, 64), Interval(tau, 64)};
      const double taken = highest(folded_entries(decay, points, points + parity));
      CAPTURE(tau);
      CHECK(largest <= taken);
      CHECK(largest >= taken / 10);
    }
  }
}

TEST_CASE("what tails of sums are taken for is at least what their terms sum to, and not much more") {
  for (const double rate : {0.05, 0.4, 2.0}) {
    for (const long first : {1L, 8L, 61L}) {
      CAPTURE(rate, first);
      double by_twos = 0, squares = 0;
      for (long m = first; m < first + 2000; ++m) {
        const auto term = static_cast<double>(m) * std::exp(-rate * static_cast<double>(m));
        if ((m - first) % 2 == 0) by_twos += term;
        squares += static_cast<double>(m) * term;
      }
      const double tails = highest(tail(Interval(rate, 64), first)),
                   of_squares = lowest(square_tail(Interval(rate, 64), first));
      CHECK(tails >= by_twos * (1 - 1e-12));
      CHECK(tails <= 4 * by_twos);
      CHECK(of_squares == doctest::Approx(squares).epsilon(1e-12));
    }
  }
}

TEST_CASE("the inequalities of the contact's symbol that the proof uses hold on a mesh") {
  double last_g = 0;
  for (double x = 1e-3; x < 30; x += 1e-3) {
    const double sum = std::sinh(2 * x) + 2 * x;
    const double g = (std::cosh(2 * x) - 1) / sum;
    const double most = 2 * (1 + 2 * x) * std::exp(-2 * x) + 1e-15;
    CHECK_UNARY((1 + 2 * x - std::exp(-2 * x)) / sum <= most);
    CHECK_UNARY(2 * x / sum <= most);
    CHECK_UNARY(4 * x * x * std::sinh(2 * x) / (sum * sum) <= 1);
    CHECK_UNARY(g >= last_g - 1e-15);
    last_g = g;
  }
}

TEST_CASE("an expansion too short for its contact has a radius that covers what it misses") {
  const WorkingDigits working(60);
  SmoothKernel smooth(I1_interval, 50);
  for (const double half_length : {0.01, 0.5, 2.0, 4.0}) {
    CAPTURE(half_length);
    const Interval here(half_length, working_bits());
    const auto truth = columns_of(half_length, size_for(half_length, 30) + 30, smooth, here);
    for (const int digits : {3, 8, 15}) {
      CAPTURE(digits);
      const auto rough = columns_of(half_length, size_for(half_length, digits), smooth, here);
      CHECK(highest(rough[0].radius) <= std::pow(10, -digits));
      for (std::size_t k = 0; k < truth.size(); ++k) {
        CHECK(missed_by(rough[k], truth[k]) <= highest(rough[k].radius) + highest(truth[k].radius));
        CHECK(static_cast<double>(abs(middle_of(truth[k].coefficients[1] - rough[k].coefficients[1]))) <=
              highest(rough[k].energy_radius) + highest(truth[k].energy_radius));
        CHECK(meet(rough[k].constant, truth[k].constant));
        CHECK(highest(truth[k].radius) < 1e-30);
      }
    }
  }
}

TEST_CASE("what an expansion for one half length misses at another is in its radius") {
  const WorkingDigits working(60);
  SmoothKernel smooth(I1_interval, 50);
  const Float here = 1.5, there = 1.5 + 0x1p-20;
  const int size = size_for(1.5, 25);
  const auto truth = columns_of(there, size, smooth, interval_of(there));
  const auto both = columns_of(here, size, smooth, hull(interval_of(here), interval_of(there)));
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const double missed = missed_by(both[k], truth[k]);
    CHECK(missed <= highest(both[k].radius));
    CHECK(missed >= 1e-4 * highest(both[k].radius));
    CHECK(meet(both[k].constant, truth[k].constant));
  }
}

TEST_CASE("a place that may be inside or outside has results for both") {
  const auto proof = proven_elastic(Exact(1.25), Exact(0.25), 25, I1_interval, 100);
  const WorkingDigits working(proof->working_digits);
  const ProvenResults& contact = *proof->contact;
  const Interval step(1e-18, working_bits());
  const SurfacePoint inside{step / 2}, outside{-(step / 2)}, either{either_side(step)};
  const auto covers = [&](const auto& result) {
    const Interval both = result(either);
    CHECK(is_inside(result(inside), both));
    CHECK(is_inside(result(outside), both));
    CHECK(width_of(both) < 1e-7);
  };
  covers([&](const SurfacePoint& place) { return contact.pressure(place); });
  covers([&](const SurfacePoint& place) { return *contact.normal(place); });
  covers([&](const SurfacePoint& place) { return *contact.tangential(place); });
  CHECK(highest(contact.pressure(outside)) == 0);
  CHECK(lowest(contact.pressure(inside)) > 0);
}
